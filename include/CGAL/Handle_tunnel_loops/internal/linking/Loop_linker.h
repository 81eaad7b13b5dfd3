// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_LINKER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_LINKER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Cap_hubs.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_walker.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/link.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The intersection and linking numbers of loops on a mesh, and the reasons where the latter mean
/// nothing. Loops that run through places where the surface touches itself are led around them.
///
/// A loop on a surface with boundary bounds on one side if, pushed there, it bounds a surface that
/// does not meet the one it is on: if its linking numbers with the boundary curves are zero, too.
/// The mesh is the surface with caps, but where these are plays no part: no curve enters them.
template <typename TriangleMesh, typename Loop, typename VertexPointMap, typename VertexIndexMap>
class Loop_linker
{
  using Walker = Edge_walker<TriangleMesh, VertexPointMap, VertexIndexMap>;
  using Builder = Surface_curves_builder<TriangleMesh, VertexPointMap, VertexIndexMap>;
  using Walk = typename Walker::Walk;

public:
  Loop_linker(const TriangleMesh& tm, VertexPointMap point, VertexIndexMap vertex_index)
      : tm_(tm)
      , point_(point)
      , vertex_index_(vertex_index)
      , walker_(tm, point, vertex_index, hubs_) {}

  // Walkers refer to the hubs.
  Loop_linker(const Loop_linker&) = delete;
  Loop_linker& operator=(const Loop_linker&) = delete;

  /// takes the boundary curves, with the surface to their left; before `set_loops()`.
  void set_boundaries(std::vector<Walk> boundaries) {
    boundaries_ = std::move(boundaries);
    std::vector<Index> hubs;
    for(const Walk& boundary : boundaries_) {
      const auto beside = opposite(boundary.front(), tm_); // in the cap
      hubs.push_back(static_cast<Index>(get(vertex_index_, target(next(beside, tm_), tm_))));
    }
    hubs_ = Cap_hubs(std::move(hubs));
  }

  /// takes pointers to loops that are closed and lie on the surface; \p component gives the number
  /// of the component of a face. Finds where the solid is, unless \p sides are known, of all
  /// components that have loops.
  template <typename ComponentOfFace>
  void set_loops(Execution execution,
                 std::vector<const Loop*> loops,
                 const ComponentOfFace& component,
                 std::size_t number_of_components,
                 Solid_sides sides = {}) {
    loops_ = std::move(loops);
    for(const Loop* loop : loops_) {
      CGAL_precondition(!loop->steps().empty());
      relations_.components.push_back(component(face(loop->steps().front().halfedge, tm_)));
      CGAL_assertion(relations_.components.back() < number_of_components);
    }
    for(const Walk& boundary : boundaries_)
      boundary_components_.push_back(component(face(boundary.front(), tm_)));
    std::vector<char> has_loop(number_of_components, 0);
    for(std::size_t c : relations_.components)
      has_loop[c] = 1;
    sides_ = sides.outward.empty() ? find_sides(execution, component, has_loop) : std::move(sides);
    keep_boundaries_if(has_loop);
    for(std::size_t i = 0; i < loops_.size(); ++i) {
      relations_.outward.push_back(sides_.outward[relations_.components[i]]);
      if(relations_.outward[i] == 0)
        lasting_problems_.emplace(i, sides_.reasons[relations_.components[i]]);
    }
  }

  /// of the components that have loops.
  const Solid_sides& sides() const { return sides_; }

  /// computes the intersection numbers.
  void intersect(Execution execution) {
    walks_.resize(loops_.size());
    for_each_index(
        execution, loops_.size(),
        [this](std::size_t i) { walks_[i] = walker_.straight(*loops_[i]); }, 1);
    const Surface_curves curves =
        Builder(tm_, point_, vertex_index_, hubs_).build(execution, walks_, relations_.outward);
    relations_.intersections = internal::link(execution, curves, false).intersections;
  }

  /// computes the intersection and the linking numbers; of the latter, if \p is_asked_for is not
  /// empty, only those of the loops for which it is set, with all. Of loops with problems, numbers
  /// with each other are left out, and others may be.
  void link(Execution execution, std::vector<char> is_asked_for = {}) {
    relations_.is_linked = true;
    is_asked_for_ = std::move(is_asked_for);
    for(int round = 0; round < maximum_number_of_rounds; ++round)
      if(!find_walks(execution, round == 0) || !link_walks(execution))
        break;
  }

  /// what has been computed.
  Loop_relations take_relations() { return std::move(relations_); }

private:
  static constexpr int maximum_number_of_rounds = 8;

  bool is_boundary(std::size_t number) const { return number >= loops_.size(); }

  void add_problem(std::size_t loop, const std::string& problem) {
    if(!is_boundary(loop))
      relations_.problems.emplace(loop, problem);
  }

  template <typename ComponentOfFace>
  Solid_sides find_sides(Execution execution,
                         const ComponentOfFace& component,
                         const std::vector<char>& has_loop) const {
    std::vector<char> has_boundary(has_loop.size(), 0);
    for(std::size_t c : boundary_components_)
      has_boundary[c] = 1;
    return Component_orientation<TriangleMesh, VertexPointMap, ComponentOfFace>(
               execution, tm_, point_, component, has_loop, std::move(has_boundary))
        .sides();
  }

  void keep_boundaries_if(const std::vector<char>& is_wanted) {
    std::size_t kept = 0;
    for(std::size_t i = 0; i < boundaries_.size(); ++i)
      if(is_wanted[boundary_components_[i]]) {
        boundary_components_[kept] = boundary_components_[i];
        std::swap(boundaries_[kept++], boundaries_[i]);
      }
    boundaries_.resize(kept);
    boundary_components_.resize(kept);
  }

  // Whether there are walks that have not been tried. In the first round these are all; later,
  // those of loops for which there is a way around what has been found.
  bool find_walks(Execution execution, bool is_first) {
    bool is_any_new = is_first && !loops_.empty();
    walks_.resize(loops_.size());
    for(std::size_t i = is_first ? find_straight_walks(execution) : 0; i < loops_.size(); ++i) {
      execution.look();
      Walk walk = walker_(*loops_[i]);
      if(walker_.has_failed() && is_first) {
        walk = walker_.straight(*loops_[i]);
        lasting_problems_.emplace(i, "degenerate faces at vertex " +
                                         std::to_string(walker_.failure()) + " enclose a handle");
      }
      if(is_first || (!walker_.has_failed() && walk != walks_[i])) {
        walks_[i] = std::move(walk);
        is_any_new = true;
      }
    }
    return is_any_new;
  }

  // Finds the walks of the first loops, up to the first one that does not run straight. That walker
  // and those after it learn from each other what to keep away from.
  std::size_t find_straight_walks(Execution execution) {
    constexpr std::size_t loops_at_once = 8;
    std::vector<char> is_straight(loops_.size(), 0);
    execution.for_ranges(loops_.size(), loops_at_once, [&](std::size_t begin, std::size_t end) {
      Walker walker(tm_, point_, vertex_index_, hubs_);
      for(std::size_t i = begin; i < end; ++i) {
        walks_[i] = walker.straight(*loops_[i]);
        is_straight[i] = walker.is_clear(walks_[i]);
      }
    });
    return std::find(is_straight.begin(), is_straight.end(), 0) - is_straight.begin();
  }

  // Whether another round may do better.
  bool link_walks(Execution execution) {
    const Surface_curves curves = curves_with_boundaries(execution);
    relations_.problems = lasting_problems_;
    const bool do_link = relations_.problems.size() < loops_.size();
    Linking numbers = internal::link(execution, curves, do_link);
    relations_.intersections = std::move(numbers.intersections);
    drop_boundaries(relations_.intersections);
    if(!do_link)
      return false;
    relations_.linking = std::move(numbers.linking);
    const bool is_any_avoided = note_problems(numbers, curves);
    note_linked_boundaries();
    drop_boundaries(relations_.linking);
    drop_meaningless_numbers();
    return is_any_avoided;
  }

  // What makes numbers meaningless. Returns whether another round may do better.
  bool note_problems(const Linking& numbers, const Surface_curves& curves) {
    if(numbers.has_too_many_contacts) {
      for(std::size_t i = 0; i < loops_.size(); ++i)
        add_problem(i, "the surface touches itself in too many places");
      return false;
    }
    bool is_any_avoided = false;
    for(const Contact& contact : numbers.contacts)
      if(is_any_loop_at(contact, curves)) {
        note_contact(contact, curves);
        avoid(contact, curves);
        is_any_avoided = true;
      }
    for(const Matrix_entry& e : numbers.defect)
      for(const Index loop : {e.row, e.column})
        add_problem(loop, "the surface crosses itself near it");
    return is_any_avoided;
  }

  // The numbers of the boundary curves come after those of the loops.
  Surface_curves curves_with_boundaries(Execution execution) {
    std::vector<Walk> walks = walks_;
    for(const Walk& boundary : boundaries_)
      walks.push_back(clear_boundary(boundary));
    std::vector<int> outward = relations_.outward;
    outward.resize(walks.size(), 1);
    Surface_curves curves =
        Builder(tm_, point_, vertex_index_, hubs_).build(execution, walks, std::move(outward));
    curves.is_asked_for = is_asked_for_;
    if(!is_asked_for_.empty())
      curves.is_asked_for.resize(walks.size(), 0);
    return curves;
  }

  // A boundary curve, or where vertices on it are to be avoided, a curve around these and the cap.
  Walk clear_boundary(const Walk& boundary) {
    if(walker_.is_clear(boundary))
      return boundary;
    Walk around = walker_.around_cap(boundary.front());
    return walker_.has_failed() ? boundary : around;
  }

  void note_linked_boundaries() {
    for(const Matrix_entry& e : relations_.linking)
      if(is_boundary(e.row) != is_boundary(e.column)) {
        const auto [loop, boundary] = std::minmax(e.row, e.column);
        if(boundary_components_[boundary - loops_.size()] == relations_.components[loop])
          add_problem(loop, "a boundary curve is linked with it");
      }
  }

  template <typename Predicate>
  static void drop(Sparse_matrix& matrix, const Predicate& is_of_no_use) {
    matrix.erase(std::remove_if(matrix.begin(), matrix.end(), is_of_no_use), matrix.end());
  }

  void drop_boundaries(Sparse_matrix& matrix) const {
    drop(matrix,
         [this](const Matrix_entry& e) { return is_boundary(e.row) || is_boundary(e.column); });
  }

  // Of two loops that have problems, which were not counted for all of them.
  void drop_meaningless_numbers() {
    const auto has_problem = [this](Index loop) { return relations_.problems.count(loop) != 0; };
    drop(relations_.linking,
         [&](const Matrix_entry& e) { return has_problem(e.row) && has_problem(e.column); });
  }

  // How boundary curves lie to each other is not asked for.
  bool is_any_loop_at(const Contact& contact, const Surface_curves& curves) const {
    bool is_any = false;
    curves.for_each_loop_at(contact, [&](Index loop) { is_any = is_any || !is_boundary(loop); });
    return is_any;
  }

  // The vertices that the edge and the corner share are to be avoided, or all if they share none.
  void avoid(const Contact& contact, const Surface_curves& curves) {
    const Surface_curves::Edge& edge = curves.edges[contact.edge];
    std::vector<Index> vertices = {edge.source, edge.target};
    if(contact.corner != Contact::no_corner) {
      const Surface_curves::Corner& corner = curves.corners[contact.corner];
      std::vector<Index> shared;
      for(Index v : {corner.apex, corner.from, corner.to})
        if(v == edge.source || v == edge.target)
          shared.push_back(v);
      vertices.push_back(corner.apex);
      if(!shared.empty())
        vertices = shared;
    }
    for(Index v : vertices)
      walker_.avoid(curves.originals[v]);
  }

  void note_contact(const Contact& contact, const Surface_curves& curves) {
    const Surface_curves::Edge& edge = curves.edges[contact.edge];
    const std::string problem = "the surface touches itself at the edge " +
                                std::to_string(curves.originals[edge.source]) + " - " +
                                std::to_string(curves.originals[edge.target]);
    curves.for_each_loop_at(contact, [&](Index loop) { add_problem(loop, problem); });
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  VertexIndexMap vertex_index_;
  Cap_hubs hubs_;
  Walker walker_;
  std::vector<const Loop*> loops_;
  std::vector<char> is_asked_for_; // by loop, or empty
  Loop_relations relations_;
  std::vector<Walk> walks_;
  std::vector<Walk> boundaries_; // of components that have loops
  std::vector<std::size_t> boundary_components_;
  std::map<std::size_t, std::string> lasting_problems_;
  Solid_sides sides_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_LINKER_H
