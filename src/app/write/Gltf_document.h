// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GLTF_DOCUMENT_H
#define HTLOOPS_GLTF_DOCUMENT_H

#include "write/bytes.h"
#include "write/documents.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace htloops {

/// A document of glTF 2.0 and its buffer.
class Gltf_document
{
public:
  using Point = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  /// adds a node with a mesh; it is a `Json` of a primitive that says more of how it looks.
  void add_node(const std::string& name,
                const std::vector<Point>& points,
                const std::vector<Point>& normals,
                const std::vector<Triangle>& triangles,
                Json primitive = Json::object());

  /// returns the number of a new material.
  std::size_t add_material(Json material);

  /// the file, with all nodes below one, which has more of them: a header, and two chunks of whole
  /// words.
  std::string file(Json root);

private:
  template <typename Number>
  std::size_t accessor_of(const std::vector<std::array<Number, 3>>& rows);

  Json json_ = {{"asset", {{"version", "2.0"}, {"generator", "htloops"}}}, {"scene", 0}};
  std::string buffer_;
};

} // namespace htloops

#endif // HTLOOPS_GLTF_DOCUMENT_H
