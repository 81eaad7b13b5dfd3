// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "request_checks.h"

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

void require_faces(const Request& request, const char* kind, std::size_t least) {
  // Three halfedges per face, numbered with 32 bits of which one may be a flag.
  constexpr std::size_t most = 700000000;
  if(request.faces >= least && request.faces <= most)
    return;
  throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' of genus " +
                              std::to_string(request.genus) + " needs " +
                              (request.faces < least ? "at least " + std::to_string(least)
                                                     : "at most " + std::to_string(most)) +
                              " faces, not " + std::to_string(request.faces));
}

void require_genus(const Request& request, const char* kind, std::size_t only) {
  if(request.genus != only)
    throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' has genus " +
                                std::to_string(only) + ", not " + std::to_string(request.genus));
}

void require_least_genus(const Request& request, const char* kind, std::size_t least) {
  if(request.genus < least)
    throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' has genus " +
                                std::to_string(least) + " or more, not " +
                                std::to_string(request.genus));
}

void require_parts(const Request& request, const char* kind) {
  if(request.parts == 0)
    throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' has a part");
  require_least_genus(request, kind, request.parts);
}

bool is_connected_of_genus(const Soup& soup, std::size_t genus) {
  // Closed: E = 3 F / 2, so V - F / 2 = 2 - 2 g.
  if(2 * soup.points.size() + 4 * genus != soup.triangles.size() + 4)
    return false;
  return number_of_components(soup) == 1;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
