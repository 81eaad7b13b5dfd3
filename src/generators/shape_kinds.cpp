// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Shape.h"
#include "request_checks.h"
#include "shape_texts.h"

#include <deque>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

std::vector<Kind> kinds_of_shapes() {
  static std::deque<std::string> descriptions; // kinds refer to them
  std::vector<Kind> kinds;
  for(const auto& [name, text] : shape_texts()) {
    const Shape shape(text);
    descriptions.push_back(shape.description() + "; genus " + std::to_string(*shape.genus()));
    kinds.push_back({name, descriptions.back().c_str(),
                     [name = name, text = text](const Request& request) {
                       const Shape described(text);
                       require_genus(request, name, *described.genus());
                       return mesh_of_shape(described, request, name);
                     },
                     GENUS, shape.faces(), *shape.genus()});
  }
  return kinds;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
