// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "request_checks.h"

#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

void require_faces(const Request& request, const char* kind, double least) {
  // Three halfedges per face, numbered with 32 bits of which one may be a flag.
  constexpr double most = 700000000;
  const double faces = static_cast<double>(request.faces);
  if(faces >= least && faces <= most)
    return;
  char limit[32];
  std::snprintf(limit, sizeof(limit), "%.12g", faces < least ? least : most);
  throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' of genus " +
                              std::to_string(request.genus) + " needs " +
                              (faces < least ? "at least " : "at most ") + limit + " faces, not " +
                              std::to_string(request.faces));
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

void require_no_more_than_faces(const Request& request, const Kind& kind) {
  const auto require = [&](unsigned option, std::initializer_list<std::size_t> numbers) {
    for(const std::size_t number : numbers)
      if((kind.options & option) != 0 && number > request.faces)
        throw std::invalid_argument(std::string("a mesh of the kind '") + kind.name + "' of " +
                                    std::to_string(request.faces) + " faces cannot have " +
                                    std::to_string(number) + " of anything");
  };
  require(GENUS, {request.genus});
  require(PARTS, {request.parts});
  require(TORUS_KNOT, {request.p, request.q});
  require(WAVE_FREQUENCY, {request.frequency});
  require(SMALL_BRIDGES, {request.bridges, request.tunnels});
  require(NECKS, {request.necks});
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
