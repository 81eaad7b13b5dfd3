// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "generators.h"

#include "Random.h"
#include "Shape.h"
#include "kinds.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// throws `std::invalid_argument` if of what the kind looks at more is asked for than faces, none
/// of which can serve two: then no sum or product of what a kind needs is out of range.
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

} // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> kinds = {sphere_kind,  torus_kind,  knot_kind,       multi_torus_kind,
                               lattice_kind, gyroid_kind, sponge_kind,     plates_kind,
                               bars_kind,    chain_kind,  torus_link_kind, ladder_kind,
                               shell_kind,   foam_kind,   interlaced_kind, waves_kind,
                               scan_kind,    twins_kind,  hollow_kind,     random_kind};
    const std::vector<Kind> shapes = kinds_of_shapes();
    kinds.insert(kinds.end(), shapes.begin(), shapes.end());
    return kinds;
  }();
  return all;
}

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

bool is_connected_of_genus(const Soup& soup, std::size_t genus) {
  // Closed: E = 3 F / 2, so V - F / 2 = 2 - 2 g.
  if(2 * soup.points.size() + 4 * genus != soup.triangles.size() + 4)
    return false;
  return number_of_components(soup) == 1;
}

Soup permute_vertices(const Soup& soup, unsigned seed) {
  Random random(seed);
  std::vector<std::uint32_t> new_index(soup.points.size());
  std::iota(new_index.begin(), new_index.end(), 0u);
  random.shuffle(new_index);

  Soup permuted;
  permuted.points.resize(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    permuted.points[new_index[v]] = soup.points[v];
  permuted.triangles = soup.triangles;
  for(auto& triangle : permuted.triangles)
    for(std::uint32_t& v : triangle)
      v = new_index[v];
  random.shuffle(permuted.triangles);
  return permuted;
}

Soup disjoint_union(const std::vector<Soup>& soups) {
  std::vector<Soup> shifted = soups;
  double x = 0.;
  for(Soup& soup : shifted) {
    if(soup.points.empty())
      continue;
    const auto [lowest, highest] =
        std::minmax_element(soup.points.begin(), soup.points.end(),
                            [](const auto& a, const auto& b) { return a[0] < b[0]; });
    const double width = (*highest)[0] - (*lowest)[0], shift = x - (*lowest)[0];
    for(auto& point : soup.points)
      point[0] += shift;
    x += 1.1 * width;
  }
  return joined(shifted);
}

Soup joined(const std::vector<Soup>& soups) {
  Soup all;
  for(const Soup& soup : soups) {
    if(all.points.size() + soup.points.size() > std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument("too many vertices for one mesh");
    const auto first = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
    for(const auto& [a, b, c] : soup.triangles)
      all.triangles.push_back({first + a, first + b, first + c});
  }
  return all;
}

Soup translated(Soup soup, const std::array<double, 3>& by) {
  for(auto& point : soup.points)
    for(int i = 0; i < 3; ++i)
      point[i] += by[i];
  return soup;
}

Soup reversed(Soup soup) {
  for(auto& triangle : soup.triangles)
    std::swap(triangle[1], triangle[2]);
  return soup;
}

std::size_t number_of_components(const Soup& soup) {
  boost::disjoint_sets_with_storage<> sets(soup.points.size());
  std::vector<char> is_used(soup.points.size(), 0);
  for(const auto& [a, b, c] : soup.triangles) {
    sets.union_set(a, b);
    sets.union_set(b, c);
    is_used[a] = is_used[b] = is_used[c] = 1;
  }
  std::size_t count = 0;
  for(std::size_t v = 0; v < is_used.size(); ++v)
    count += is_used[v] != 0 && sets.find_set(v) == v;
  return count;
}

Soup make(const Kind& kind, const Request& request) {
  require_no_more_than_faces(request, kind);
  return kind.make(request);
}

std::size_t number_of_boundaries(const Soup& soup) {
  std::vector<std::pair<std::uint64_t, bool>> sides; // of edges, and whether they lead upwards
  for(const auto& triangle : soup.triangles)
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t u = triangle[i], v = triangle[(i + 1) % 3];
      const auto [low, high] = std::minmax(u, v);
      sides.emplace_back(std::uint64_t(low) << 32 | high, u < v);
    }
  std::sort(sides.begin(), sides.end());
  boost::disjoint_sets_with_storage<> sets(soup.points.size());
  std::vector<char> is_on_boundary(soup.points.size(), 0);
  for(std::size_t i = 0; i < sides.size(); ++i) {
    const std::uint64_t edge = sides[i].first;
    if((i > 0 && sides[i - 1].first == edge) ||
       (i + 1 < sides.size() && sides[i + 1].first == edge))
      continue;
    const auto u = static_cast<std::uint32_t>(edge >> 32), v = static_cast<std::uint32_t>(edge);
    sets.union_set(u, v);
    is_on_boundary[u] = is_on_boundary[v] = 1;
  }
  std::size_t count = 0;
  for(std::size_t v = 0; v < is_on_boundary.size(); ++v)
    count += is_on_boundary[v] != 0 && sets.find_set(v) == v;
  return count;
}

std::size_t genus(const Soup& soup) {
  const auto pieces =
      static_cast<std::ptrdiff_t>(2 * number_of_components(soup) - number_of_boundaries(soup));
  return static_cast<std::size_t>((pieces - euler_characteristic(soup)) / 2);
}

std::ptrdiff_t euler_characteristic(const Soup& soup) {
  std::vector<char> is_used(soup.points.size(), 0);
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * soup.triangles.size());
  for(const auto& triangle : soup.triangles)
    for(int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.push_back(std::uint64_t(low) << 32 | high);
      is_used[triangle[i]] = 1;
    }
  std::sort(edges.begin(), edges.end());
  const auto number_of_edges = std::unique(edges.begin(), edges.end()) - edges.begin();
  const auto number_of_vertices = std::count(is_used.begin(), is_used.end(), 1);
  return number_of_vertices - number_of_edges + static_cast<std::ptrdiff_t>(soup.triangles.size());
}

} // namespace CGAL::Handle_tunnel_loops::generators
