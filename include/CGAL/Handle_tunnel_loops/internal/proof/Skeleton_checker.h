// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CHECKER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CHECKER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Cycle_linking.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Hub_places.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inlets.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inside_test.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Segments_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Skeleton_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/append_lines.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Puts together what the parts of the proof say of a skeleton, in words.
class Skeleton_checker
{
public:
  /// The arrays must outlive it. \p places has those of the vertices of the mesh, hubs included.
  Skeleton_checker(Execution execution,
                   const Flat_mesh& mesh,
                   std::vector<Vector> places,
                   const Flat_skeleton& skeleton,
                   const std::vector<Vertex_walk>& walks,
                   const Face_number& face_number,
                   const Point_name& point_name)
      : execution_(execution)
      , mesh_(mesh)
      , places_(std::move(places))
      , skeleton_(skeleton)
      , walks_(walks)
      , face_number_(face_number)
      , point_name_(point_name)
      , parts_of_component_(mesh.seeds.size()) {}

  Skeleton_certificate run() {
    surfaces_ = numbers_of_surfaces();
    genera_ = genera();
    if(!has_known_points())
      return std::move(certificate_);
    const Skeleton_cycles cycles(skeleton_);
    check_parts(cycles);
    const Inlets inlets(mesh_, skeleton_, places_);
    const Face_tree tree(execution_, mesh_, span_of(places_));
    check_inside(inlets, tree);
    check_embedding();
    check_basis(cycles);
    if(mesh_.number_of_hubs > 0)
      check_caps(tree);
    return std::move(certificate_);
  }

  /// something, as has been found by then.
  bool do_caps_meet() const { return do_caps_meet_; }

private:
  using Edge = std::array<Index, 2>;

  // ---- words

  void fail(const std::string& line) { append_line(certificate_.failure, line); }

  void fail(const std::vector<std::string>& lines, const std::string& kind) {
    append_lines(certificate_.failure, lines, kind);
  }

  std::string name(Index point) const {
    return point_name_ ? point_name_(point) : std::to_string(point);
  }

  std::string name(const Edge& edge) const {
    return edge[0] == edge[1] ? "point " + name(edge[0])
                              : "edge " + name(edge[0]) + "-" + name(edge[1]);
  }

  std::string of_component(Index c) const {
    return mesh_.seeds.size() == 1 ? "" : " of component " + std::to_string(c);
  }

  static std::string cycles_in_words(std::size_t n) {
    return std::to_string(n) + (n == 1 ? " cycle" : " cycles");
  }

  // ---- connected parts

  bool has_known_points() {
    for(Index p = 0; p < skeleton_.points.size(); ++p) {
      const Vector& at = skeleton_.points[p];
      if(!std::all_of(at.begin(), at.end(), [](double x) { return std::isfinite(x); }))
        fail("point " + name(p) + " is not finite");
      else if(skeleton_.component_of[p] >= mesh_.seeds.size())
        fail("point " + name(p) + " belongs to component " +
             std::to_string(skeleton_.component_of[p]) + ", but the mesh has only " +
             std::to_string(mesh_.seeds.size()));
      else if(surfaces_[skeleton_.component_of[p]] == 0)
        fail("point " + name(p) + " belongs to component " +
             std::to_string(skeleton_.component_of[p]) + ", which is the wall of a cavity");
      else
        continue;
      return false;
    }
    return true;
  }

  // Of each piece of the solid, the surfaces that bound it.
  std::vector<std::size_t> numbers_of_surfaces() const {
    std::vector<std::size_t> surfaces(mesh_.seeds.size(), 0);
    for(Index seed : mesh_.seeds)
      ++surfaces[mesh_.component[seed]];
    return surfaces;
  }

  // ... and the sum of their genera.
  std::vector<std::size_t> genera() const {
    std::vector<std::size_t> corners(mesh_.seeds.size(), 0), vertices(corners);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      ++vertices[mesh_.component[v]];
      corners[mesh_.component[v]] += mesh_.ring(v).size();
    }
    std::vector<std::size_t> genera;
    for(std::size_t c = 0; c < vertices.size(); ++c) // V - F / 2 = 2 - 2 g, of each surface
      genera.push_back((2 * surfaces_[c] + corners[c] / 6 - vertices[c]) / 2);
    return genera;
  }

  void check_parts(const Skeleton_cycles& cycles) {
    certificate_.connected = true;
    for(Index p = 0; p < cycles.parts().size(); ++p)
      parts_of_component_[skeleton_.component_of[cycles.parts()[p].first]].push_back(p);
    std::vector<std::string> lines;
    for(const Edge& e : skeleton_.edges)
      if(skeleton_.component_of[e[0]] != skeleton_.component_of[e[1]])
        lines.push_back(name(e) + " joins components " +
                        std::to_string(skeleton_.component_of[e[0]]) + " and " +
                        std::to_string(skeleton_.component_of[e[1]]));
    for(Index c = 0; c < genera_.size(); ++c)
      if(const std::string what = problem_of_parts(c, cycles); !what.empty())
        lines.push_back("the skeleton" + of_component(c) + what);
    certificate_.connected = lines.empty();
    fail(lines, "of that kind");
  }

  std::string problem_of_parts(Index c, const Skeleton_cycles& cycles) const {
    const std::vector<Index>& parts = parts_of_component_[c];
    if(surfaces_[c] == 0)
      return "";
    if(parts.empty())
      return " is missing";
    if(parts.size() > 1)
      return " is in " + std::to_string(parts.size()) + " pieces";
    const std::size_t n = cycles.parts()[parts[0]].cycles.size();
    return n == genera_[c]
               ? ""
               : " has " + cycles_in_words(n) + ", but the genus is " + std::to_string(genera_[c]) +
                     (surfaces_[c] == 1 ? "" : ", with that of its cavities");
  }

  // ---- inside

  void check_inside(const Inlets& inlets, const Face_tree& tree) {
    const Inside_test test(mesh_, tree, inlets, skeleton_);
    is_outside_.assign(skeleton_.edges.size(), 0);
    std::vector<std::string> lines;
    for(const auto& [e, face] : test.edges_outside(execution_)) {
      is_outside_[e] = 1;
      note_outside(skeleton_.edges[e], face == no_index ? nullptr : &tree.corners(face), lines);
    }
    for(Index p : test.points_outside())
      lines.push_back("point " + name(p) + " does not lie inside" +
                      of_component(skeleton_.component_of[p]));
    for(Index p = 0; p < skeleton_.points.size(); ++p)
      if(skeleton_.is_inlet[p] && inlets.hub(p) == no_index)
        lines.push_back(
            "point " + name(p) +
            " is not an inlet: it is not the only leaf at the center of a boundary curve");
    certificate_.inside = lines.empty();
    fail(lines, "that are not inside");
  }

  // Where a cap meets something there is no inside, whatever the lines do.
  void check_caps(const Face_tree& tree) {
    std::vector<std::string> lines;
    for(Index hub : Hub_places(execution_, mesh_, places_).caps_met(tree))
      lines.push_back("the cap of the boundary curve at vertex " +
                      std::to_string(mesh_.index_of_caller(hub)) +
                      " meets itself, the surface or another cap: the inside is not known there");
    do_caps_meet_ = !lines.empty();
    if(do_caps_meet_)
      certificate_.inside = certificate_.basis = false;
    fail(lines, "that meet something");
  }

  void
  note_outside(const Edge& edge, const Face_tree::Corners* face, std::vector<std::string>& lines) {
    certificate_.edges_outside.push_back({{edge[0], edge[1]}, {}});
    const Index c = skeleton_.component_of[edge[0]];
    if(face == nullptr) {
      lines.push_back(name(edge) + " lies outside" + of_component(c));
      return;
    }
    const bool is_own = mesh_.component[(*face)[0]] == c;
    std::string line = name(edge) + (is_own ? " leaves through " : " meets ");
    if(const Index hub = hub_of(*face); hub != no_index)
      line +=
          "the cap of the boundary curve at vertex " + std::to_string(mesh_.index_of_caller(hub));
    else {
      const std::size_t number = face_number_((*face)[0], (*face)[1], (*face)[2]);
      certificate_.edges_outside.back().face = number;
      line += "face " + std::to_string(number);
    }
    lines.push_back(line + (is_own ? "" : of_component(mesh_.component[(*face)[0]])));
  }

  Index hub_of(const Face_tree::Corners& face) const {
    for(Index v : face)
      if(mesh_.is_hub(v))
        return v;
    return no_index;
  }

  // ---- embedding

  void check_embedding() {
    constexpr std::size_t most = 100;
    const Segments_apart apart(skeleton_);
    std::vector<std::string> lines;
    for(const Edge& e : apart.edges_without_length())
      lines.push_back(name(e) + " has no length");
    for(const auto& [e, f] : apart.edges_that_meet(execution_)) {
      lines.push_back(name(e) + " meets " + name(f));
      if(certificate_.edges_that_meet.size() < most)
        certificate_.edges_that_meet.push_back({{e[0], e[1]}, {f[0], f[1]}});
    }
    certificate_.embedded = lines.empty();
    fail(lines, "that meet");
  }

  // ---- basis

  // Whether the linking numbers of the cycles of a component mean anything.
  bool is_to_be_linked(Index c, const Skeleton_cycles& cycles) const {
    if(parts_of_component_[c].size() != 1)
      return false;
    const auto& all = cycles.parts()[parts_of_component_[c][0]].cycles;
    for(const Skeleton_cycles::Cycle& cycle : all)
      for(const auto& step : cycle)
        if(is_outside_[step.first])
          return false;
    return all.size() == genera_[c];
  }

  // By component, the numbers of the walks on it.
  std::vector<std::vector<Index>> walks_of_components() const {
    std::vector<std::vector<Index>> walks(genera_.size());
    for(Index w = 0; w < walks_.size(); ++w)
      if(!walks_[w].empty())
        walks[mesh_.component[walks_[w].front()]].push_back(w);
    return walks;
  }

  bool are_walks_on_edges() {
    for(std::size_t w = 0; w < walks_.size(); ++w)
      for(std::size_t i = 0; i < walks_[w].size(); ++i) {
        const Index u = walks_[w][i], v = walks_[w][i + 1 == walks_[w].size() ? 0 : i + 1];
        if(mesh_.position(u, v) == mesh_.ring(u).size()) {
          fail("handle loop " + std::to_string(w) + " is not a closed curve on the surface");
          return false;
        }
      }
    return true;
  }

  void check_basis(const Skeleton_cycles& cycles) {
    if(!are_walks_on_edges())
      return;
    certificate_.basis = true;
    std::vector<char> is_wanted(skeleton_.edges.size(), 0);
    std::vector<Index> components;
    for(Index c = 0; c < genera_.size(); ++c)
      if(surfaces_[c] > 0 && !is_to_be_linked(c, cycles))
        certificate_.basis = false;
      else if(genera_[c] > 0) {
        components.push_back(c);
        for(const auto& cycle : cycles.parts()[parts_of_component_[c][0]].cycles)
          for(const auto& step : cycle)
            is_wanted[step.first] = 1;
      }
    if(components.empty())
      return;
    const Cycle_linking linking(execution_, skeleton_, is_wanted, places_, walks_);
    const std::vector<std::vector<Index>> walks = walks_of_components();
    std::vector<std::string> lines(components.size());
    for_each_index(
        execution_, components.size(),
        [&](std::size_t i) {
          const Index c = components[i];
          lines[i] = problem_of_cycles(c, cycles.parts()[parts_of_component_[c][0]].cycles, linking,
                                       walks[c]);
        },
        1);
    for(const std::string& line : lines)
      if(!line.empty()) {
        certificate_.basis = false;
        fail(line);
      }
  }

  std::string problem_of_cycles(Index c,
                                const std::vector<Skeleton_cycles::Cycle>& cycles,
                                const Cycle_linking& linking,
                                const std::vector<Index>& walks) const {
    Sparse_matrix matrix;
    for(Index i = 0; i < cycles.size(); ++i)
      for(const Matrix_entry& e : linking.numbers(cycles[i], i))
        if(std::binary_search(walks.begin(), walks.end(), e.column))
          matrix.push_back(e);
    const auto d = determinant(matrix, cycles.size());
    if(d == 1)
      return "";
    return "the " + cycles_in_words(cycles.size()) + of_component(c) +
           (cycles.size() == 1 ? " is" : " are") + " not a basis: the determinant of " +
           "their linking numbers with the handle loops is " + d.str() + ", not 1";
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::vector<Vector> places_;
  const Flat_skeleton& skeleton_;
  const std::vector<Vertex_walk>& walks_;
  const Face_number& face_number_;
  const Point_name& point_name_;
  std::vector<std::size_t> surfaces_, genera_;         // by component
  std::vector<std::vector<Index>> parts_of_component_; // by component
  std::vector<char> is_outside_;                       // by edge
  Skeleton_certificate certificate_;
  bool do_caps_meet_ = false;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CHECKER_H
