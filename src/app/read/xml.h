// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_XML_H
#define HTLOOPS_XML_H

#include "read/input_file.h"

#include <boost/property_tree/ptree.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace htloops {

using Xml_tree = boost::property_tree::ptree;

/// the tree of a document of XML, which is the content of a file or a part of it; throws `Failure`
/// if it is none.
Xml_tree read_xml(const Input_file& file, std::string_view document);
inline Xml_tree read_xml(const Input_file& file) { return read_xml(file, file.content()); }

/// an attribute of an element; empty if it has none of that name.
std::string xml_attribute(const Xml_tree& tree, const std::string& name);

/// the numbers of a text; throws `Failure` if there is something else.
std::vector<double> numbers_of_text(const Input_file& file, std::string_view content);

} // namespace htloops

#endif // HTLOOPS_XML_H
