// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_PROPERTIES_H
#define HTLOOPS_VERTEX_PROPERTIES_H

#include <algorithm>
#include <string>
#include <vector>

namespace htloops {

/// A number for each vertex, in the order of the vertices, as PLY files have them.
struct Vertex_property
{
  std::string name;
  std::string type; ///< a type of PLY
  std::vector<double> values;

  bool is_real() const { return type.find("float") == 0 || type.find("double") == 0; }
};

using Vertex_properties = std::vector<Vertex_property>;

inline bool has_property(const Vertex_properties& properties, const std::string& name) {
  return std::any_of(properties.begin(), properties.end(),
                     [&name](const Vertex_property& p) { return p.name == name; });
}

} // namespace htloops

#endif // HTLOOPS_VERTEX_PROPERTIES_H
