// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SIDES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SIDES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_relations.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
On which sides the loops of a basis bound, each component for itself, and the projections to the
classes that do.

On a component that does not cross itself, L_in and L_out are the classes that bound inside and
outside; H1 is their direct sum, and each is its own annihilator under the intersection form J. A
class x of L_in has V(x, .) = 0 and one of L_out V(., x) = 0. Hence V(x, y) is, up to one sign, the
intersection number of the part of x in L_out with y, and also of x with the part of y in L_in:
the linking numbers *are* the intersection numbers of the projections with the basis.
*/
class Loop_sides
{
public:
  /// \p relations are those of the basis.
  Loop_sides(const Loop_classes& classes, const Loop_relations& relations)
      : rows_(classes.size())
      , columns_(classes.size())
      , signs_(classes.size(), 0) {
    for(const Matrix_entry& e : relations.linking)
      if(relations.components[e.row] == relations.components[e.column]) {
        rows_[e.row].emplace_back(e.column, e.value);
        columns_[e.column].emplace_back(e.row, e.value);
      }
    for(auto* matrix : {&rows_, &columns_})
      for(Class_vector& v : *matrix)
        normalize(v);
    find_signs(classes, relations);
  }

  /// whether it is known for the component of a loop which classes bound inside and outside.
  bool is_decided(Index i) const { return signs_[i] != 0; }

  bool bounds_inside(Index i) const { return is_decided(i) && rows_[i].empty(); }
  bool bounds_outside(Index i) const { return is_decided(i) && columns_[i].empty(); }

  /// the intersection numbers with the basis of the part of a loop in L_in (`true`) or L_out.
  Class_vector numbers_of_part(Index i, bool inside) const {
    return scaled(inside ? columns_[i] : rows_[i], inside ? -signs_[i] : signs_[i]);
  }

private:
  // V less its transpose is J or -J on a component. If it is neither, the surface crosses itself.
  void find_signs(const Loop_classes& classes, const Loop_relations& relations) {
    std::map<std::size_t, int> sign_of_component;
    std::set<std::size_t> bad_components;
    for(const auto& problem : relations.problems)
      bad_components.insert(relations.components[problem.first]);
    for(Index i = 0; i < classes.size(); ++i) {
      Class_vector skew = rows_[i];
      const bool fits = add_multiple(skew, -1, columns_[i]);
      const std::size_t component = relations.components[i];
      const int sign =
          sign_of_component.emplace(component, skew == classes.row(i) ? 1 : -1).first->second;
      if(!fits || skew != scaled(classes.row(i), sign))
        bad_components.insert(component);
    }
    for(Index i = 0; i < classes.size(); ++i) {
      const std::size_t component = relations.components[i];
      signs_[i] = bad_components.count(component) != 0 ? 0 : sign_of_component.at(component);
    }
  }

  static Class_vector scaled(Class_vector v, int factor) {
    for(auto& entry : v)
      entry.second *= factor;
    return v;
  }

  std::vector<Class_vector> rows_, columns_; // of V, within the components
  std::vector<int> signs_;                   // by loop; 0 if nothing is known
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SIDES_H
