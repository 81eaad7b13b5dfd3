// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_DIAGNOSIS_H
#define HTLOOPS_SOUP_DIAGNOSIS_H

#include "mesh_types.h"
#include "read/soup.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

/// The edges of a soup of triangles, each with all its halfedges: halfedge 3 * face + i goes from
/// corner i of the face to the next corner. Sorted by counting, without a hash: linear in the
/// number of triangles unless many edges meet in one vertex.
class Edge_table
{
public:
  /// A halfedge, with the larger of its two vertices.
  struct Entry
  {
    std::uint32_t far_vertex;
    std::uint32_t halfedge;
  };

  /// An edge: its vertices and the halfedges along it, in either direction.
  struct Edge
  {
    std::uint32_t vertices[2]; // the smaller first
    const Entry* begin;
    const Entry* end;

    std::size_t size() const { return static_cast<std::size_t>(end - begin); }
    std::uint32_t halfedge(std::size_t i) const { return begin[i].halfedge; }
    std::string name() const { return name_of_edge(vertices[0], vertices[1]); }
    std::string name_with_faces() const {
      return name() + " with " + std::to_string(size()) + " faces";
    }
  };

  /// All faces of the soup must be triangles of three different vertices in range.
  explicit Edge_table(const Soup& soup);

  /// calls `visit(edge)` for each edge, ordered by vertices.
  template <typename Visit> void for_each_edge(Visit visit) const {
    for(std::uint32_t near_vertex = 0; near_vertex + 1 < first_.size(); ++near_vertex) {
      const Entry* const end = entries_.data() + first_[near_vertex + 1];
      for(const Entry* begin = entries_.data() + first_[near_vertex]; begin != end;) {
        const Entry* next = begin + 1;
        while(next != end && next->far_vertex == begin->far_vertex)
          ++next;
        visit(Edge{{near_vertex, begin->far_vertex}, begin, next});
        begin = next;
      }
    }
  }

private:
  std::vector<std::uint32_t> first_; // of each vertex, in the entries; one more at the end
  std::vector<Entry> entries_;       // by their smaller vertex, then the larger, then the halfedge
};

/// The sorted vertices of a face, and its number.
using Corners_of_face = std::pair<std::array<std::uint32_t, 3>, std::uint32_t>;

/// the faces at edges at which something is wrong; those with the same vertices follow each other.
std::vector<Corners_of_face> suspicious_faces(const Soup& soup, const Edge_table& edges);

using CGAL::Handle_tunnel_loops::Mesh_defect;

/// What keeps a soup from being an oriented 2-manifold of triangles, with or without boundary.
struct Defect
{
  Mesh_defect kind;
  std::size_t count;              ///< how often it was found
  std::string message;            ///< says it in words and names the first element that has it
  bool is_not_orientable = false; ///< whether the message says that the surface is not orientable
};

/// finds all defects, of every kind. Vertices that no face uses are none, nor is a face without
/// area.
std::vector<Defect> diagnose(const Soup& soup);

/// A mesh, if there are no defects.
struct Built_mesh
{
  Mesh mesh;
  std::vector<Defect> defects;
};

/// makes a mesh of a soup, or says what is wrong with it; vertices and faces keep their numbers.
/// Only a soup that is suspicious is diagnosed, which takes several times as long.
Built_mesh build_mesh(const Soup& soup);

} // namespace htloops

#endif // HTLOOPS_SOUP_DIAGNOSIS_H
