// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/parts.h"

#include "interrupt.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace htloops {
namespace {

using Kernel_of_copy = CGAL::Exact_predicates_inexact_constructions_kernel;
using Face = Changeable_mesh::Face_index;

std::size_t label(const Changeable_mesh& mesh, std::vector<std::uint32_t>& of_face) {
  of_face.assign(mesh.number_of_faces() + mesh.number_of_removed_faces(), 0);
  const auto map = boost::make_function_property_map<Face>(
      [&](Face f) -> std::uint32_t& { return of_face[f.idx()]; });
  return CGAL::Polygon_mesh_processing::connected_components(mesh, map);
}

void measure(const Changeable_mesh& mesh, Parts& parts) {
  for(const Face f : mesh.faces()) {
    Part& part = parts.all[parts.of_face[f.idx()]];
    const auto [p, q, r] = corners_of(mesh, f);
    if(part.faces++ == 0)
      part.box = p.bbox();
    part.box += p.bbox() + q.bbox() + r.bbox();
    part.area += std::sqrt(CGAL::squared_area(p, q, r));
    for(const auto side : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      part.is_closed &= !mesh.is_border(mesh.opposite(side));
  }
}

// A sum of many terms, in the unit of the box, from a corner of that: what is below its rounding
// tells nothing.
class Volume
{
public:
  explicit Volume(const CGAL::Bbox_3& box)
      : box_(box)
      , unit_((std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin(),
                          (std::numeric_limits<double>::min)()})) {}

  template <typename Point> void add(const Point& p, const Point& q, const Point& r) {
    const Vector a = scaled(p), b = scaled(q), c = scaled(r);
    const double term = CGAL::scalar_product(a, CGAL::cross_product(b, c)) / 6.;
    sum_ += term;
    sum_of_sizes_ += std::abs(term);
    ++number_;
  }

  void give_to(Part& part) const {
    const double rounding =
        double(number_ + 16) * std::numeric_limits<double>::epsilon() * sum_of_sizes_;
    if(!part.is_closed || std::abs(sum_) <= rounding)
      return;
    part.orientation = sum_ > 0. ? 1 : -1;
    part.volume = std::abs(sum_) * unit_ * unit_ * unit_;
  }

private:
  using Vector = Kernel_of_copy::Vector_3;

  template <typename Point> Vector scaled(const Point& p) const {
    return {(p.x() - box_.xmin()) / unit_, (p.y() - box_.ymin()) / unit_,
            (p.z() - box_.zmin()) / unit_};
  }

  CGAL::Bbox_3 box_;
  double unit_, sum_ = 0., sum_of_sizes_ = 0.;
  std::size_t number_ = 0;
};

void orient(const Changeable_mesh& mesh, Parts& parts) {
  std::vector<Volume> volumes;
  for(const Part& part : parts.all)
    volumes.emplace_back(part.box);
  for(const Face f : mesh.faces()) {
    const auto [p, q, r] = corners_of(mesh, f);
    volumes[parts.of_face[f.idx()]].add(p, q, r);
  }
  for(std::size_t i = 0; i < parts.all.size(); ++i)
    volumes[i].give_to(parts.all[i]);
}

using Pair_of_parts = std::pair<std::uint32_t, std::uint32_t>;

// Parts of which faces meet, the smaller number first.
std::set<Pair_of_parts> find_meeting(const Pairs_of_faces& faces, Parts& parts) {
  std::set<Pair_of_parts> pairs;
  for(const auto& [f, g] : faces)
    if(const Pair_of_parts pair = std::minmax(parts.of_face[f], parts.of_face[g]);
       pair.first != pair.second)
    {
      pairs.insert(pair);
      parts.all[pair.first].meets_others = parts.all[pair.second].meets_others = true;
    }
  return pairs;
}

bool contains(const CGAL::Bbox_3& outer, const CGAL::Bbox_3& inner) {
  for(int i = 0; i < 3; ++i)
    if(inner.min(i) < outer.min(i) || inner.max(i) > outer.max(i))
      return false;
  return true;
}

// By part, those whose boxes lie in its own.
std::vector<std::vector<std::uint32_t>> find_candidates(const Parts& parts) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  std::vector<Box> boxes;
  for(std::uint32_t i = 0; i < parts.all.size(); ++i)
    boxes.emplace_back(parts.all[i].box, i);
  std::vector<std::vector<std::uint32_t>> inner(parts.all.size());
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    for(const auto& [i, j] : {std::pair(a.info(), b.info()), std::pair(b.info(), a.info())})
      if(parts.all[i].is_closed && contains(parts.all[i].box, parts.all[j].box))
        inner[i].push_back(j);
  });
  return inner;
}

void find_depths(const Changeable_mesh& mesh,
                 const std::set<Pair_of_parts>& crossing,
                 Parts& parts) {
  constexpr std::size_t enough = 64;
  using Side = CGAL::Side_of_triangle_mesh<Changeable_mesh, Kernel_of_copy>;
  std::vector<std::vector<Changeable_mesh::Vertex_index>> vertices(parts.all.size());
  std::vector<std::vector<Face>> faces(parts.all.size());
  const std::vector<std::vector<std::uint32_t>> inner = find_candidates(parts);
  for(const Face f : mesh.faces()) {
    const std::uint32_t i = parts.of_face[f.idx()];
    if(vertices[i].size() < enough)
      vertices[i].push_back(mesh.target(mesh.halfedge(f)));
    if(!inner[i].empty())
      faces[i].push_back(f);
  }
  for(std::uint32_t i = 0; i < parts.all.size(); ++i) {
    if(inner[i].empty())
      continue;
    throw_if_interrupted();
    typename Side::AABB_tree tree(faces[i].begin(), faces[i].end(), mesh,
                                  get(CGAL::vertex_point, mesh));
    const Side side(tree);
    for(const std::uint32_t j : inner[i])
      if(crossing.count(std::minmax(i, j)) == 0)
        for(const auto v : vertices[j]) // those that touch the other part do not tell
          if(const CGAL::Bounded_side where = side(mesh.point(v)); where != CGAL::ON_BOUNDARY) {
            if(where == CGAL::ON_BOUNDED_SIDE)
              parts.all[j].around.push_back(i);
            break;
          }
  }
  for(Part& part : parts.all)
    part.depth = part.around.size();
}

} // namespace

Parts measured_parts(const Changeable_mesh& mesh) {
  Parts parts;
  parts.all.resize(label(mesh, parts.of_face));
  measure(mesh, parts);
  orient(mesh, parts);
  return parts;
}

Parts parts_of(const Changeable_mesh& mesh, const Crossings& crossings) {
  Parts parts = measured_parts(mesh);
  find_meeting(crossings.touching, parts);
  find_depths(mesh, find_meeting(crossings.crossing, parts), parts);
  return parts;
}

} // namespace htloops
