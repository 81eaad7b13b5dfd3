// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/holes.h"

#include "interrupt.h"
#include "words.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/merge_border_vertices.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <iterator>

namespace htloops {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Border = Changeable_mesh::Halfedge_index;
using Face = Changeable_mesh::Face_index;
using Cap = std::vector<Face>;

constexpr std::size_t none = static_cast<std::size_t>(-1);

// The caps of all curves, and which of them a face belongs to.
class Caps
{
public:
  explicit Caps(Changeable_mesh& mesh)
      : mesh_(mesh)
      , flatness_(1e-9 * diagonal_of(PMP::bbox(mesh)))
      , first_face_(mesh.number_of_faces() + mesh.number_of_removed_faces()) {}

  // Of least area, or, once that does not fit, as smooth as the surface around it.
  void make(std::size_t curve, Border border, bool is_smooth) {
    constexpr std::size_t most_edges = 300; // of a cubic search
    const auto edges = CGAL::halfedges_around_face(border, mesh_);
    const bool is_long = std::size_t(std::distance(edges.begin(), edges.end())) > most_edges;
    if(caps_.size() <= curve)
      caps_.resize(curve + 1);
    Cap& cap = caps_[curve];
    if(!is_smooth)
      PMP::triangulate_hole(mesh_, border, std::back_inserter(cap),
                            CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
                                .threshold_distance(flatness_)
                                .do_not_use_cubic_algorithm(is_long));
    else if(!is_long)
#ifdef CGAL_EIGEN3_ENABLED
      PMP::triangulate_refine_and_fair_hole(mesh_, border, std::back_inserter(cap),
                                            CGAL::Emptyset_iterator());
#else
      PMP::triangulate_and_refine_hole(mesh_, border, std::back_inserter(cap),
                                       CGAL::Emptyset_iterator());
#endif
    cap_of_.resize(mesh_.number_of_faces() + mesh_.number_of_removed_faces() - first_face_, none);
    for(const Face f : cap)
      cap_of_[f.idx() - first_face_] = curve;
  }

  const Cap& operator[](std::size_t cap) const { return caps_[cap]; }

  /// none for faces of the surface, which caps become part of.
  std::size_t cap_of(std::uint32_t face) const {
    return face < first_face_ ? none : cap_of_[face - first_face_];
  }

  void become_part_of_surface(std::size_t cap) {
    for(const Face f : caps_[cap])
      cap_of_[f.idx() - first_face_] = none;
  }

  void take_out(std::size_t cap) {
    for(const Face f : caps_[cap])
      CGAL::Euler::remove_face(mesh_.halfedge(f), mesh_);
    caps_[cap].clear();
  }

private:
  Changeable_mesh& mesh_;
  const double flatness_; // of what lies in a plane
  const std::size_t first_face_;
  std::vector<Cap> caps_;
  std::vector<std::size_t> cap_of_; // by new face
};

// By curve: first those that cross the surface, then, of two that cross, the later one.
std::vector<char>
crossing_caps(const Caps& caps, std::size_t count, const Pairs_of_faces& crossings) {
  std::vector<char> crosses(count, 0);
  const auto for_each_pair = [&](const auto& visit) {
    for(const auto& [f, g] : crossings)
      visit(caps.cap_of(f), caps.cap_of(g));
  };
  for_each_pair([&](std::size_t i, std::size_t j) {
    if(i == none && j != none)
      crosses[j] = 1;
  });
  for_each_pair([&](std::size_t i, std::size_t j) {
    if(i != none && j != none && !crosses[i] && !crosses[j])
      crosses[(std::max)(i, j)] = 1;
  });
  return crosses;
}

void drop_removed(const Changeable_mesh& mesh, Pairs_of_faces& pairs) {
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&](const auto& pair) {
                               return mesh.is_removed(Face(pair[0])) ||
                                      mesh.is_removed(Face(pair[1]));
                             }),
              pairs.end());
}

std::string words_of(const Changeable_mesh& mesh, Border border, bool has_crossed) {
  const auto& p = mesh.point(mesh.target(border));
  const auto edges = CGAL::halfedges_around_face(border, mesh);
  return "a boundary curve of " +
         counted(std::size_t(std::distance(edges.begin(), edges.end())), "edge", "edges") +
         formatted(", perimeter %.4g, at (%.4g, %.4g, %.4g): ",
                   PMP::face_border_length(border, mesh), p.x(), p.y(), p.z()) +
         (has_crossed ? "its cap would cross the surface" : "no cap was found");
}

} // namespace

Closed_holes close_holes(Changeable_mesh& mesh) {
  // Where holes touch in a vertex it had become several, along one curve around all of them.
  PMP::merge_duplicated_vertices_in_boundary_cycles(mesh);
  std::vector<Border> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  Closed_holes holes{borders.size()};
  std::vector<double> lengths;
  for(const Border border : borders)
    lengths.push_back(PMP::face_border_length(border, mesh));
  Caps caps(mesh);
  std::vector<char> is_open(borders.size(), 1), has_crossed(borders.size(), 0);
  for(const bool is_smooth : {false, true}) {
    for(std::size_t i = 0; i < borders.size(); ++i)
      if(is_open[i]) {
        throw_if_interrupted();
        caps.make(i, borders[i], is_smooth);
      }
    holes.crossings = crossings_of(mesh);
    is_open = crossing_caps(caps, borders.size(), holes.crossings.crossing);
    for(std::size_t i = 0; i < borders.size(); ++i)
      if(is_open[i]) {
        caps.take_out(i);
        has_crossed[i] = 1;
      } else if(caps[i].empty())
        is_open[i] = 1;
      else
        caps.become_part_of_surface(i);
    if(std::count(is_open.begin(), is_open.end(), 1) == 0)
      break;
  }
  PMP::duplicate_non_manifold_vertices(mesh); // of those that stay
  drop_removed(mesh, holes.crossings.crossing);
  drop_removed(mesh, holes.crossings.touching);
  for(std::size_t i = 0; i < borders.size(); ++i)
    if(is_open[i])
      holes.open.push_back({mesh.target(borders[i]), words_of(mesh, borders[i], has_crossed[i])});
    else {
      ++holes.closed;
      holes.longest = (std::max)(holes.longest, lengths[i]);
    }
  return holes;
}

} // namespace htloops
