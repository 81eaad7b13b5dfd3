// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_MAP_H
#define HTLOOPS_VERTEX_MAP_H

#include "mesh_types.h"

#include <boost/property_map/property_map.hpp>

#include <vector>

namespace htloops {

/// Writes what is told of vertices where an answer has room for it.
template <typename Value> struct Vertex_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = Value;
  using reference = Value;
  using category = boost::writable_property_map_tag;

  std::vector<Value>* room;

  friend void put(const Vertex_map& map, key_type v, Value value) { (*map.room)[v.idx()] = value; }
};

} // namespace htloops

#endif // HTLOOPS_VERTEX_MAP_H
