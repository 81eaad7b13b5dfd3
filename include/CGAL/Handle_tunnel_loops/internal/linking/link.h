// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_relations.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Integer multiples of numbered elements, one chain for each of a family of loops, kept by
/// element.
class Chains
{
public:
  struct Term
  {
    Index loop;
    std::int32_t value;
  };

  struct Terms
  {
    const Term *first, *last;
    const Term* begin() const { return first; }
    const Term* end() const { return last; }
    bool empty() const { return first == last; }
  };

  /// The loops must come in ascending order.
  void add(Index element, Index loop, std::int32_t value) {
    CGAL_precondition(entries_.empty() || entries_.back().term.loop <= loop);
    entries_.push_back({element, {loop, value}});
  }

  /// adds up what was added to one element for one loop. To be called once, after the last `add()`.
  void finish(std::size_t number_of_elements) {
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.element < b.element; });
    begin_.assign(number_of_elements + 1, 0);
    for(auto e = entries_.begin(); e != entries_.end();) {
      Entry sum = *e;
      for(++e; e != entries_.end() && e->element == sum.element && e->term.loop == sum.term.loop;
          ++e)
        sum.term.value += e->term.value;
      if(sum.term.value != 0) {
        terms_.push_back(sum.term);
        ++begin_[sum.element + 1];
      }
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<Entry>().swap(entries_);
  }

  /// the terms of an element, in the order of the loops; none is zero.
  Terms of(std::size_t element) const {
    CGAL_precondition_msg(element + 1 < begin_.size(), "after `finish()`");
    return {terms_.data() + begin_[element], terms_.data() + begin_[element + 1]};
  }

private:
  struct Entry
  {
    Index element;
    Term term;
  };

  std::vector<Entry> entries_;
  std::vector<Term> terms_;
  std::vector<std::size_t> begin_; // by element
};

/*!
A family of loops on a surface, each as two homologous curves in general position to those of the
others: a walk along the edges, and a copy beside it that runs from midpoint to midpoint of the
edges, across the corners of the faces. A walk and a copy meet at midpoints only, where the copy
crosses the walk.
*/
struct Surface_curves
{
  /// An edge of the walks, with the third vertices of the faces to its left and right.
  struct Edge
  {
    Index source, target, left, right;
  };

  /// A line across a face, from the midpoint of the edge `apex` - `from` to that of `apex` - `to`,
  /// along which the copy of a loop runs.
  struct Corner
  {
    Index apex, from, to, loop;
  };

  std::vector<Vector> vertices;
  std::vector<Edge> edges;
  std::vector<Corner> corners;
  Chains walks;             ///< by edge: how often each loop's walk runs along it
  Chains crossings;         ///< by edge: how often each loop's copy crosses it from right to left
  std::vector<int> outward; ///< by loop: 1 if the faces beside it look out of the solid, or -1
};

/// the intersection numbers of loops, and with \p do_link all the rest.
CGAL_HTL_CORE Linking link(Execution execution, const Surface_curves& curves, bool do_link);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/linking/link_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_H
