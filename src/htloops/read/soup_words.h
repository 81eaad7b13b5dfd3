// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_WORDS_H
#define HTLOOPS_SOUP_WORDS_H

#include <cstddef>
#include <string>

namespace htloops {

inline std::string name_of_face(std::size_t face) { return "face " + std::to_string(face); }

inline std::string name_of_vertex(std::size_t vertex) { return "vertex " + std::to_string(vertex); }

/// that a face names a vertex, counted from `first`, which is not among those of the file.
inline std::string
no_such_vertex(std::size_t face, long long vertex, std::size_t number_of_vertices, int first = 0) {
  return name_of_face(face) + " names vertex " + std::to_string(vertex) + " of " +
         std::to_string(number_of_vertices) + " (they count from " + std::to_string(first) + ")";
}

} // namespace htloops

#endif // HTLOOPS_SOUP_WORDS_H
