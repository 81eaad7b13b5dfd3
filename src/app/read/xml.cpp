// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/xml.h"

#include "read/sources.h"

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>

namespace htloops {
namespace {

// Behind the end of a tag that begins somewhere, over what is in quotes; the end of the document if
// it does not end.
std::size_t end_of_tag(std::string_view document, std::size_t at) {
  char quote = 0;
  for(; at < document.size(); ++at) {
    const char c = document[at];
    if(quote != 0)
      quote = c == quote ? char(0) : quote;
    else if(c == '"' || c == '\'')
      quote = c;
    else if(c == '>')
      return at + 1;
  }
  return at;
}

// The parser calls itself for each element within another one.
bool is_too_deep(std::string_view document) {
  constexpr std::size_t deepest = 1000;
  std::size_t depth = 0;
  const auto begins = [&](std::size_t at, std::string_view mark) {
    return document.substr(at, mark.size()) == mark;
  };
  for(std::size_t at = document.find('<'); at < document.size(); at = document.find('<', at)) {
    if(begins(at, "<!--"))
      at = document.find("-->", at);
    else if(begins(at, "<![CDATA["))
      at = document.find("]]>", at);
    else if(begins(at, "</")) {
      depth -= depth > 0 ? 1 : 0;
      ++at;
    } else if(begins(at, "<!") || begins(at, "<?"))
      ++at;
    else {
      at = end_of_tag(document, at);
      if(!(at >= 2 && document[at - 2] == '/') && ++depth > deepest)
        return true;
    }
  }
  return false;
}

} // namespace

Xml_tree read_xml(const Input_file& file, std::string_view document) {
  if(is_too_deep(document))
    fail_to_read(file.name(), "its XML elements are nested too deeply");
  Xml_tree tree;
  boost::iostreams::stream<boost::iostreams::array_source> stream(document.data(), document.size());
  try {
    boost::property_tree::read_xml(stream, tree);
  } catch(const boost::property_tree::xml_parser_error& error) {
    fail_to_read(file.name(), "it is not valid XML: " + error.message() + " in line " +
                                  std::to_string(error.line()));
  }
  return tree;
}

// A name with a dot, as in GraphML, is no path.
std::string xml_attribute(const Xml_tree& tree, const std::string& name) {
  const auto attributes = tree.get_child_optional("<xmlattr>");
  return attributes ? attributes->get(Xml_tree::path_type(name, '/'), std::string())
                    : std::string();
}

std::vector<double> numbers_of_text(const Input_file& file, std::string_view content) {
  Text_source text(file.name(), content);
  std::vector<double> numbers;
  while(text.skip_to_content()) {
    double x;
    if(!text.read(x))
      fail_to_read(file.name(), "expected a number, not " + in_quotes(text.word()));
    numbers.push_back(x);
  }
  return numbers;
}

} // namespace htloops
