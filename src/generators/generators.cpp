// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Random.h"
#include "Shape.h"
#include "kinds.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

const Kind own_kinds[] = {
    {"sphere", "a sphere, a subdivided icosahedron; genus 0, from 4 faces", make_sphere, GENUS,
     10000, 0},
    {"torus", "a torus, as a regular grid; genus 1, from 18 faces", make_torus},
    {"knot", "a tube around a trefoil knot; genus 1, from 150 faces", make_knot},
    {"multi-torus",
     "a flat rounded slab with a hole for each handle; any genus g, from 200 + 200 g faces",
     make_multi_torus},
    {"lattice",
     "tubes along the edges of a cubic grid, some left out at random; any genus g, from "
     "400 + 250 g faces",
     make_lattice},
    {"gyroid",
     "a part of the gyroid with the given number of handles; any genus g, from 400 + 300 g faces",
     make_gyroid},
    {"sponge",
     "a block of cubes with a square hole for each handle, with flat faces and sharp edges; any "
     "genus g, from about 60 + 30 g faces",
     make_sponge},
    {"plates",
     "a stack of plates and blocks with straight bores of random sizes, made of few long, thin "
     "triangles; any genus g, at least the number p of parts, from 16 g + 12 p faces",
     make_plates, GENUS | PARTS},
    {"bars",
     "a row of bars with straight bores in two directions, made of few long, thin triangles; any "
     "genus g, at least the number p of parts, from 16 g + 12 p faces",
     make_bars, GENUS | PARTS},
    {"hubs",
     "a drum with a circle of bores; the vertex in the middle of each end has a quarter as many "
     "neighbors as the mesh has faces; any genus g from 3, from 40 g faces",
     make_hubs, GENUS, 10000, 20},
    {"fan",
     "two fans of triangles over a common rim with random heights; the apex of one is at their "
     "mean; genus 0, from 6 faces",
     make_fan, GENUS, 10000, 0},
    {"chain", "a chain of rings, one for each handle; any genus g from 1, from 72 g faces",
     make_chain},
    {"torus-link",
     "tubes along parallel torus knots (p, q), one for each handle, each linked with all others; "
     "any genus g from 1, from a few hundred faces for each",
     make_torus_link, GENUS | TORUS_KNOT},
    {"ladder",
     "a closed ladder with g - 1 rungs along a torus knot (p, q), for g = 1 a single rail; any "
     "genus g from 1, from about 10000 faces",
     make_ladder, GENUS | TORUS_KNOT, 20000},
    {"shell",
     "tubes along the edges of a cubic grid, with a cavity along some of them: an outer and an "
     "inner surface that share the handles; any genus g, from 1000 + 600 g faces",
     make_shell},
    {"foam",
     "struts of random radii along the edges of a grid with randomly moved nodes; any genus g, "
     "from 600 + 600 g faces",
     make_foam},
    {"interlaced",
     "two grids of tubes, each through the holes of the other; any genus g, half in each, from "
     "1000 + 400 g faces",
     make_interlaced},
    {"waves",
     "a level set of a sum of random waves in a box; the genus and the number of components are "
     "random; from 1000 + 400 f^3 faces for frequency f",
     make_waves, WAVE_FREQUENCY, 20000},
    {"scan",
     "a body like a pot with g large handles and a rough surface, as from a scanner, with small "
     "bridges on the surface and small tunnels below it, one handle each; loops of the body are "
     "longer than 1, loops of bridges and tunnels shorter than 20 mean edges and 0.9; from 25000 "
     "faces, more for more than 8 handles, and 600 for each bridge and tunnel",
     make_scan, GENUS | SMALL_BRIDGES, 60000},
    {"twins",
     "two bodies like pots with g handles each, mirror images of each other, joined by k necks: "
     "genus 2 g + k - 1; loops around necks are shorter than 10 mean edges and 0.5, loops around "
     "and through handles longer than 1; from 50000 faces, more for more than 8 handles, and 180 "
     "for each neck",
     make_twins, GENUS | NECKS, 100000},
    {"hollow",
     "a hollow body like a pot with g handles and k small holes in its wall: genus 2 g + k - 1; "
     "loops around these holes are shorter than 10 mean edges and 0.5, loops around and through "
     "handles longer than 0.8; as many faces as for twins",
     make_hollow, GENUS | NECKS, 100000},
    {"random",
     "a random triangulation with random points, never embedded: scattered, smooth, flat at any "
     "scale, or with slivers and coincident points; any genus g, from 4 faces (g = 0) or 2 + 12 g "
     "faces",
     make_random}};

thread_local const Watch_guard::Look* current_look = nullptr;

/// the edges of all triangles, as pairs of vertices in one number, sorted: an edge of two triangles
/// occurs twice.
std::vector<std::uint64_t> sides_of(const Soup& soup) {
  std::vector<std::size_t> ends(soup.points.size() + 1, 0); // of the sides of each lower vertex
  const auto for_each_side = [&soup](const auto& visit) {
    for(std::size_t f = 0; f < soup.triangles.size(); ++f) {
      look_at(soup, f);
      for(std::size_t i = 0; i < 3; ++i)
        visit(std::minmax(soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]));
    }
  };
  for_each_side([&](const auto& side) { ++ends[side.first + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint64_t> sides(3 * soup.triangles.size());
  for_each_side([&](const auto& side) {
    sides[ends[side.first]++] = std::uint64_t(side.first) << 32 | side.second;
  });
  auto begin = sides.begin();
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    look_at(soup, v);
    const auto end = sides.begin() + static_cast<std::ptrdiff_t>(ends[v]);
    std::sort(begin, end);
    begin = end;
  }
  return sides;
}

} // namespace

Watch_guard::Watch_guard(Look look)
    : look_(std::move(look))
    , previous_(std::exchange(current_look, &look_)) {}

Watch_guard::~Watch_guard() { current_look = previous_; }

void look_at(const Soup& soup) {
  if(current_look != nullptr) // a closed surface has about twice as many faces as vertices
    (*current_look)(2 * soup.points.size());
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> kinds(std::begin(own_kinds), std::end(own_kinds));
    const std::vector<Kind> shapes = kinds_of_shapes();
    kinds.insert(kinds.end(), shapes.begin(), shapes.end());
    return kinds;
  }();
  return all;
}

void refuse(const char* kind, const std::string& why) {
  throw std::invalid_argument(std::string("a mesh of the kind '") + kind + "' " + why);
}

void require_faces(const Request& request,
                   const char* kind,
                   double least,
                   const std::string& mesh) {
  // Three halfedges per face, numbered with 32 bits of which one may be a flag.
  constexpr double most = 700000000;
  const double faces = static_cast<double>(request.faces);
  if(faces >= least && faces <= most)
    return;
  char limit[32];
  std::snprintf(limit, sizeof(limit), "%.12g", faces < least ? least : most);
  refuse(kind, (mesh.empty() ? "of genus " + std::to_string(request.genus) : mesh) +
                   (faces < least ? " needs at least " : " can have at most ") + limit +
                   " faces, not " + std::to_string(request.faces));
}

void require_genus(const Request& request, const char* kind, std::size_t only) {
  if(request.genus != only)
    refuse(kind, "has genus " + std::to_string(only) + ", not " + std::to_string(request.genus));
}

void require_least_genus(const Request& request, const char* kind, std::size_t least) {
  if(request.genus < least)
    refuse(kind,
           "has genus " + std::to_string(least) + " or more, not " + std::to_string(request.genus));
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

Soup askew(Soup soup) {
  for(auto& [x, y, z] : soup.points) {
    const std::array<double, 3> p = {x, y, z};
    x = 0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2];
    y = -0.8 * p[0] + 0.6 * p[1];
    z = 0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2];
  }
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
  std::size_t step = 0;
  for(const auto& [a, b, c] : soup.triangles) {
    look_at(soup, step++);
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
  constexpr std::size_t few = 100; // of these, the kind says how many faces they need
  const auto require = [&](unsigned option, const char* what,
                           std::initializer_list<std::size_t> numbers) {
    for(const std::size_t number : numbers)
      if((kind.options & option) != 0 && number > (std::max)(request.faces, few))
        refuse(kind.name, "with " + counted(request.faces, "face", "faces") + " cannot have " +
                              std::to_string(number) + " " + what);
  };
  // Each of these needs a face of its own. Then sums and products of such numbers do not overflow.
  require(GENUS, "handles", {request.genus});
  require(PARTS, "parts", {request.parts});
  require(TORUS_KNOT, "turns", {request.p, request.q});
  require(WAVE_FREQUENCY, "waves along a side", {request.frequency});
  require(SMALL_BRIDGES, "bridges or tunnels", {request.bridges, request.tunnels});
  require(NECKS, "necks", {request.necks});
  return kind.make(request);
}

std::size_t number_of_boundaries(const Soup& soup) {
  const std::vector<std::uint64_t> sides = sides_of(soup);
  Soup boundary; // its edges, as triangles
  boundary.points.resize(soup.points.size());
  for(std::size_t i = 0; i < sides.size(); ++i)
    if((i == 0 || sides[i - 1] != sides[i]) && (i + 1 == sides.size() || sides[i + 1] != sides[i]))
    {
      const auto u = static_cast<std::uint32_t>(sides[i] >> 32);
      const auto v = static_cast<std::uint32_t>(sides[i]);
      boundary.triangles.push_back({u, v, v});
    }
  return number_of_components(boundary);
}

std::size_t genus(const Soup& soup) {
  const auto pieces =
      static_cast<std::ptrdiff_t>(2 * number_of_components(soup) - number_of_boundaries(soup));
  return static_cast<std::size_t>((pieces - euler_characteristic(soup)) / 2);
}

std::ptrdiff_t euler_characteristic(const Soup& soup) {
  std::vector<char> is_used(soup.points.size(), 0);
  for(const auto& triangle : soup.triangles)
    for(const std::uint32_t v : triangle)
      is_used[v] = 1;
  std::vector<std::uint64_t> edges = sides_of(soup);
  const auto number_of_edges = std::unique(edges.begin(), edges.end()) - edges.begin();
  const auto number_of_vertices = std::count(is_used.begin(), is_used.end(), 1);
  return number_of_vertices - number_of_edges + static_cast<std::ptrdiff_t>(soup.triangles.size());
}

} // namespace CGAL::Handle_tunnel_loops::generators
