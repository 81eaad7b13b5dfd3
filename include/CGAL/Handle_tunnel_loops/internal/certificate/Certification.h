// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Computes a `Certificate` step by step, of loops on a closed surface, handles and tunnels in
/// turn. The surface must outlive it.
class Certification
{
  using Halfedge = Closed_triangles::Halfedge;
  using Loop = Closed_triangles::Loop;

public:
  explicit Certification(const Closed_triangles& triangles, Basis_kind kind = Basis_kind::PURE)
      : triangles_(triangles)
      , certifier_(triangles) {
    certificate_.basis_kind = kind;
  }

  /// takes the loops, and checks that they are closed and lie on the surface. What follows is for
  /// such loops only.
  bool are_closed(Execution execution, std::vector<Loop> loops) {
    CGAL_precondition(loops_.empty());
    loops_ = std::move(loops);
    certifier_.set_loops(execution, loops_);
    certificate_.closed_on_surface = certifier_.are_closed_on_surface();
    return certificate_.closed_on_surface;
  }

  /// cuts the mesh along the loops, and finds out whether they are a basis.
  void check_basis(Execution execution) {
    CGAL_precondition(certificate_.closed_on_surface);
    certifier_.cut(execution);
    certificate_.basis = certifier_.are_basis();
  }

  /// whether the loops are as many as a basis has: of others no more is to be known. After
  /// `check_basis()`.
  bool are_as_many_as_asked_for() const { return certifier_.are_as_many_as_asked_for(); }

  /// finds where the solid is, and the intersection numbers of the loops; with \p do_link the
  /// linking numbers as well. After `check_basis()`.
  void relate(Execution execution, bool do_link) {
    CGAL_precondition(certificate_.closed_on_surface);
    Loop_linker<Closed_triangles, Loop, Closed_triangles::Point_map,
                Closed_triangles::Vertex_index_map>
        linker(triangles_, triangles_.point(), {});
    linker.set_boundaries(triangles_.boundaries());
    std::vector<const Loop*> loops;
    for(const Loop& loop : loops_)
      loops.push_back(&loop);
    linker.set_loops(
        execution, std::move(loops), [this](Halfedge f) { return certifier_.component(f); },
        certifier_.number_of_components());
    if(do_link)
      linker.link(execution);
    else
      linker.intersect(execution);
    relate(linker.take_relations());
  }

  /// the same if the relations of the loops are known.
  void relate(Loop_relations relations) {
    CGAL_precondition(relations.components.size() == loops_.size());
    relations_ = std::move(relations);
    are_related_ = true;
    if(relations_.is_linked)
      note_linking();
  }

  /// 1 if the linking numbers show that the first loop of a pair is the handle, -1 if the second,
  /// 0 if they do not tell.
  int handle_of_pair(std::size_t k) const {
    if(!relations_.is_linked)
      return 0;
    CGAL_precondition(2 * k + 1 < certificate_.linking.size());
    const auto insideness = [](const Loop_linking& l) {
      return int(l.bounds_inside_component) - int(l.bounds_outside_component);
    };
    const int difference =
        insideness(certificate_.linking[2 * k]) - insideness(certificate_.linking[2 * k + 1]);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
  }

  /// the loops that were taken.
  const std::vector<Loop>& loops() const { return loops_; }

  /// 1 if the faces along the loops of a pair look out of the solid, -1 if they look into it.
  int outward_of_pair(std::size_t k) const { return relations_.outward[2 * k] < 0 ? -1 : 1; }

  /// changes which loop is the handle and which the tunnel, in the pairs where `is_exchanged`.
  void exchange(const std::vector<char>& is_exchanged) {
    CGAL_precondition(2 * is_exchanged.size() == loops_.size());
    if(!relations_.is_linked)
      return;
    std::vector<Index> before(loops_.size());
    for(Index i = 0; i < before.size(); ++i)
      before[i] = is_exchanged[i / 2] ? i ^ 1 : i;
    relations_.renumber(before);
    note_linking();
  }

  /// the certificate of all that has been computed, and of the basis.
  Certificate finish() {
    certificate_.failure = words(certifier_.failures());
    if(!are_related_)
      return std::move(certificate_);
    std::vector<std::string> failures = certifier_.failures();
    check_pairing(failures);
    check_types(failures);
    certificate_.failure =
        words(certificate_.basis_kind == Basis_kind::PURE ? failures : certifier_.failures());
    if(relations_.is_linked && certificate_.basis)
      count();
    return std::move(certificate_);
  }

private:
  void note_linking() {
    std::vector<Loop_linking>& linking = certificate_.linking;
    linking.assign(loops_.size(), {});
    const std::vector<char> inside = relations_.bounds_alone(true),
                            outside = relations_.bounds_alone(false);
    for(std::size_t i = 0; i < linking.size(); ++i) {
      linking[i].bounds_inside_component = inside[i] != 0;
      linking[i].bounds_outside_component = outside[i] != 0;
    }
    for(const Matrix_entry& e : relations_.linking) {
      CGAL_assertion(e.row < linking.size() && e.column < linking.size() && e.value != 0);
      linking[e.row].row.emplace_back(e.column, e.value);
      linking[e.column].column.emplace_back(e.row, e.value);
    }
    for(const auto& [loop, problem] : relations_.problems)
      linking[loop].problem = problem;
  }

  static std::string words(const std::vector<std::string>& lines) {
    std::string text;
    for(const std::string& line : lines)
      text += (text.empty() ? "" : "\n") + line;
    return text;
  }

  void check_pairing(std::vector<std::string>& failures) {
    std::vector<std::int64_t> crossings(loops_.size() / 2, 0);
    for(const Matrix_entry& e : relations_.intersections)
      if(e.row % 2 == 0 && e.column == e.row + 1)
        crossings[e.row / 2] = e.value;
    certificate_.pairing = true;
    for(std::size_t k = 0; k < crossings.size(); ++k)
      if(std::abs(crossings[k]) != 1) {
        certificate_.pairing = false;
        failures.push_back("pair " + std::to_string(k) + ": the loops cross " +
                           std::to_string(std::abs(crossings[k])) +
                           " times, counted with sign, instead of once");
      }
  }

  // Anew from the rows and columns as they are handed out, not from what the names were given by:
  // no more may speak against the name of a handle than for it.
  void check_types(std::vector<std::string>& failures) {
    certificate_.types = true;
    for(std::size_t k = 0; certificate_.basis && relations_.is_linked && k < loops_.size() / 2; ++k)
    {
      const auto [handle_inside, handle_outside] = sides_of(2 * k);
      const auto [tunnel_inside, tunnel_outside] = sides_of(2 * k + 1);
      const int in_favour = (handle_inside && !tunnel_inside) + (tunnel_outside && !handle_outside);
      const int against = (tunnel_inside && !handle_inside) + (handle_outside && !tunnel_outside);
      if(against > in_favour) {
        certificate_.types = false;
        failures.push_back("pair " + std::to_string(k) +
                           ": the handle and the tunnel loop are swapped");
      }
    }
  }

  // Whether a loop bounds on the inner side of its component, and on the outer one.
  std::pair<bool, bool> sides_of(std::size_t i) const {
    const Loop_linking& l = certificate_.linking[i];
    const auto is_zero = [&](const std::vector<Loop_linking::Number>& numbers) {
      return l.problem.empty() && std::none_of(numbers.begin(), numbers.end(), [&](const auto& n) {
               return relations_.components[n.first] == relations_.components[i];
             });
    };
    return {is_zero(l.row), is_zero(l.column)};
  }

  void count() {
    certificate_.handles_bound_inside = certificate_.tunnels_bound_outside = 0;
    certificate_.handles_bound_inside_alone = certificate_.tunnels_bound_outside_alone = 0;
    for(std::size_t i = 0; i < loops_.size(); i += 2) {
      const Loop_linking &handle = certificate_.linking[i], &tunnel = certificate_.linking[i + 1];
      *certificate_.handles_bound_inside += handle.bounds_inside();
      *certificate_.tunnels_bound_outside += tunnel.bounds_outside();
      *certificate_.handles_bound_inside_alone += handle.bounds_inside_component;
      *certificate_.tunnels_bound_outside_alone += tunnel.bounds_outside_component;
    }
  }

  const Closed_triangles& triangles_;
  Certificate certificate_;
  Loop_certifier certifier_;
  Loop_relations relations_;
  bool are_related_ = false;
  std::vector<Loop> loops_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_H
