// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/json_errors.h"

#include "file_names.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace htloops {
namespace {

constexpr auto npos = std::string::npos;

// What stands between two texts; up to the end if the second one does not follow.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  if(at == npos)
    return "";
  const std::size_t first = at + begin.size();
  return text.substr(first, text.find(end, first) - first);
}

// The place of a character. The library counts columns from 1, or gives 0 for the end of the line
// before.
std::size_t place_of(std::string_view text, std::size_t line, std::size_t column) {
  std::size_t begin = 0;
  for(std::size_t i = 1; i < line && begin < text.size(); ++i)
    begin = (std::min)(text.find('\n', begin), text.size() - 1) + 1;
  return begin + column - (begin + column > 0 ? 1 : 0);
}

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
}

// The string, number, word or sign that the library had read up to a place.
std::string_view token_at(std::string_view text, std::size_t place) {
  std::size_t begin = place;
  if(text[place] == '"' && place > 0) {
    const std::size_t quote = text.rfind('"', place - 1);
    begin = quote == npos ? place : quote;
  }
  while(begin > 0 && is_of_word(text[place]) && is_of_word(text[begin - 1]))
    --begin;
  while(place + 1 < text.size() && is_of_word(text[begin]) && is_of_word(text[place + 1]))
    ++place;
  return text.substr(begin, place + 1 - begin);
}

const char* expected_in(const std::string& context) {
  constexpr std::pair<std::string_view, const char*> all[] = {
      {"object key", "a name in double quotes"},
      {"object separator", "a colon"},
      {"object", "a comma or }"},
      {"array", "a comma or ]"}};
  for(const auto& [name, words] : all)
    if(context == name)
      return words;
  return "a value";
}

// "line 2, column 7", from 1.
std::string words_of_place(std::string_view text, std::size_t place) {
  const std::string_view before = text.substr(0, place);
  return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) +
         ", column " + std::to_string(before.size() - (before.rfind('\n') + 1) + 1);
}

std::string shortened(std::string_view token) {
  constexpr std::size_t most = 24;
  return printable(token.substr(0, most)) + (token.size() > most ? "..." : "");
}

} // namespace

std::string words_of_json_error(const std::string& message, std::string_view text) {
  if(message.compare(0, 16, "[json.exception.") != 0)
    return message;
  if(const std::string number = between(message, "number overflow parsing '", "'"); !number.empty())
    return "the number " + shortened(number) + " is too large";
  const std::string problem = between(message, " - ", "; last read");
  std::size_t line = 0, column = 0;
  if(problem.empty() || std::sscanf(between(message, "parse error at ", ":").c_str(),
                                    "line %zu, column %zu", &line, &column) != 2)
    return message.substr((std::min)(message.find("] "), message.size() - 2) + 2);
  const std::size_t place = place_of(text, line, column);
  const std::string expected = problem.find("; expected end of input") != npos
                                   ? "the end"
                                   : expected_in(between(message, "while parsing ", " - "));
  if(problem == "invalid string: missing closing quote")
    return words_of_place(text, text.size()) + ": the text ends within a string";
  if(problem.compare(0, 23, "unexpected end of input") == 0 || place >= text.size())
    return words_of_place(text, text.size()) + ": the text ends where " + expected + " is expected";
  if(problem.compare(0, 10, "unexpected") != 0 && problem != "invalid literal")
    return words_of_place(text, place) + ": " + problem;
  // What is wrong with a word may be that it ends.
  const bool is_beyond = problem == "invalid literal" && place > 0 && !is_of_word(text[place]) &&
                         is_of_word(text[place - 1]);
  const std::string_view token = token_at(text, is_beyond ? place - 1 : place);
  return words_of_place(text, static_cast<std::size_t>(token.data() - text.data())) + ": '" +
         shortened(token) + "' stands where " + expected + " is expected";
}

} // namespace htloops
