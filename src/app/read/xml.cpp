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

// The parser calls itself for each element within another one.
bool is_too_deep(std::string_view document) {
  constexpr std::size_t deepest = 1000;
  std::size_t depth = 0;
  for(std::size_t i = document.find('<'); i != document.npos; i = document.find('<', i + 1)) {
    const std::string_view mark = document.substr(i + 1, 1);
    const std::size_t end = (std::min)(document.find('>', i), document.size());
    if(mark == "/")
      depth -= depth > 0 ? 1 : 0;
    else if(mark != "!" && mark != "?" && document[end - 1] != '/' && ++depth > deepest)
      return true;
  }
  return false;
}

} // namespace

Xml_tree read_xml(const Input_file& file, std::string_view document) {
  if(is_too_deep(document))
    fail_to_read(file.name(), "elements of its XML are nested too deep");
  Xml_tree tree;
  boost::iostreams::stream<boost::iostreams::array_source> stream(document.data(), document.size());
  try {
    boost::property_tree::read_xml(stream, tree);
  } catch(const boost::property_tree::xml_parser_error& error) {
    fail_to_read(file.name(),
                 "it is not XML: " + error.message() + " in line " + std::to_string(error.line()));
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
      fail_to_read(file.name(),
                   "there is no number where one should be: " + in_quotes(text.word()));
    numbers.push_back(x);
  }
  return numbers;
}

} // namespace htloops
