// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/html_page.h"

#include <cstddef>
#include <cstdint>

namespace htloops {
namespace {

constexpr char style[] =
    "body{font:16px/1.5 sans-serif;max-width:64em;margin:2em auto;padding:0 1em;color:#222}"
    "figure{display:inline-block;width:48%;min-width:20em;margin:0 1% 1em 0}"
    "img{width:100%;border:1px solid #ddd}"
    "figcaption{color:#555}"
    "table{border-collapse:collapse;margin:1em 0}"
    "th,td{padding:.2em .8em;border-bottom:1px solid #ddd;text-align:left}"
    "th{background:#f4f4f4}"
    ".n{text-align:right;font-variant-numeric:tabular-nums}";

} // namespace

Html_page::Html_page(const std::string& target, std::string_view title)
    : out_(target) {
  out_ << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>"
       << html_of(title) << "</title>\n<style>" << style << "</style>\n</head>\n<body>\n<h1>"
       << html_of(title) << "</h1>\n";
}

void Html_page::paragraph(std::string_view text) { out_ << "<p>" << html_of(text) << "</p>\n"; }

void Html_page::picture(const std::string& png, std::string_view caption) {
  if(png.empty())
    return;
  const std::string text = html_of(caption);
  out_ << "<figure><img alt=\"" << text << "\" src=\"data:image/png;base64," << base64_of(png)
       << "\"><figcaption>" << text << "</figcaption></figure>\n";
}

void Html_page::table(const std::vector<std::vector<std::string>>& rows,
                      std::size_t first_number,
                      std::size_t last_number) {
  out_ << "<table>\n";
  for(std::size_t i = 0; i < rows.size(); ++i) {
    const std::string_view tag = i == 0 ? "th" : "td";
    out_ << "<tr>";
    for(std::size_t j = 0; j < rows[i].size(); ++j)
      out_ << '<' << tag << (j >= first_number && j < last_number ? " class=\"n\">" : ">")
           << html_of(rows[i][j]) << "</" << tag << '>';
    out_ << "</tr>\n";
  }
  out_ << "</table>\n";
}

void Html_page::finish() {
  out_ << "</body>\n</html>\n";
  out_.finish();
}

std::string html_of(std::string_view text) {
  std::string html;
  for(const char c : text)
    switch(c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    default:
      html += c;
    }
  return html;
}

std::string base64_of(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for(std::size_t j = i; j < i + 3; ++j)
      triple = triple << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
    for(int shift = 18; shift >= 0; shift -= 6)
      text += digits[triple >> shift & 63u];
  }
  for(std::size_t missing = (3 - bytes.size() % 3) % 3, k = 1; k <= missing; ++k)
    text[text.size() - k] = '=';
  return text;
}

} // namespace htloops
