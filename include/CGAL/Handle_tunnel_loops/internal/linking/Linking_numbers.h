// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The linking numbers of loops on a surface with copies of each other that are pushed outwards:
V(i, j) is that of loop i with loop j pushed out of the solid. It depends only on the classes of the
loops, so that loop i is taken as its copy across the corners of the faces and loop j as its walk
along the edges (`Surface_curves`). What is counted are the places where, seen along a direction,
the copy passes over the pushed walk, by the sense in which they cross.

- Apart from the midpoints where they touch, a copy and a walk are disjoint wherever the surface
  does not touch itself. Whether two lines cross in the projection is decided by exact predicates,
  which of them is above by another; and if a point happens to be seen on a line, all copies are
  moved aside by an infinitesimal amount, the same for all.
- Where a copy crosses an edge of a walk, that edge is pushed outwards by less than any distance but
  by more than the above amount. If both faces at the edge are seen from outside, the pushed edge
  passes over the copy; if both are seen from inside, under it. At an edge of the silhouette, with
  one face seen from either side, the pushed edge lies beyond the silhouette if the edge is convex,
  and is not crossed; if it is reflex the pushed edge lies between the two faces, and the copy
  passes over it once and under it once.
- A copy and a walk whose boxes are apart are not linked: nothing is counted of them.
- Where V less its transpose is not the intersection matrix, the surface crosses itself, and the
  numbers of both loops mean nothing. Of many loops, a few are counted with all others first, and
  two that these show to be in vain are not counted with each other: where points are anywhere, all
  loops are linked with all others.

No number is compared with a tolerance. The lines that may cross are found by a tree of boxes around
pieces of walks: near linear in the number of lines and of places where one passes over another of a
loop close by. What a corner passes over is added up once, for all loops whose copies cut it: those
that were put together of others have much in common.
*/
class Linking_numbers
{
  using Extent = Box<3>;

  // Around lines in the projection, and around the whole loops that they are of in space.
  using Seen_box = Box<5>;

public:
  explicit Linking_numbers(const Surface_curves& curves)
      : curves_(curves)
      , points_(curves.vertices, next_direction()) {
    add_intersections();
  }

  /// computes V.
  void link(Execution execution) {
    while(!are_touches_decided() && ++number_of_attempts_ < maximum_number_of_attempts)
      points_.see_along(next_direction());
    find_extents(execution);
    gather_copies(execution);
    const Pieces pieces = pieces_of_walks(execution);
    const Sparse_matrix touches =
        crossings_with_walks([this](std::size_t e) { return is_above(e); });
    number_of_corners_.assign(curves_.outward.size(), 0);
    for(const Corner& corner : curves_.corners)
      ++number_of_corners_[corner.loop];
    counts_.assign(curves_.outward.size(), Count::LATER);
    is_in_vain_.assign(curves_.outward.size(), 0);
    while(choose_loops())
      count(execution, touches, pieces);
    add_up(execution, linking_);
  }

  /// what has been computed.
  Linking take() {
    return {std::move(intersections_), std::move(linking_), std::move(defect_),
            std::move(contacts_), has_too_many_contacts_};
  }

private:
  using Edge = Surface_curves::Edge;
  using Corner = Surface_curves::Corner;
  using Point = Projected_points::Point;

  static constexpr int maximum_number_of_attempts = 16;
  static constexpr Index most_lines = 16; // of a piece

  // Pieces of the walks: those that are near each other together.
  struct Pieces
  {
    std::vector<Index> begins;
    Uninitialized_vector<Index> numbers; // in the order of the tree
    Box_tree<5> tree;
  };

  // ---- intersection numbers

  void add_intersections() {
    intersections_ = crossings_with_walks([](std::size_t) { return true; });
    CGAL_postcondition_msg(is_antisymmetric(intersections_),
                           "a copy crosses as often as its loop does");
  }

  // How often copies cross walks at the midpoints of some edges.
  template <typename Is_wanted>
  Sparse_matrix crossings_with_walks(const Is_wanted& is_wanted) const {
    Sparse_matrix crossings; // of edges, by copy
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      if(is_touched(e) && is_wanted(e))
        for(const Matrix_entry& copy : curves_.crossings.of(e))
          crossings.push_back({copy.column, static_cast<Index>(e), copy.value});
    std::sort(crossings.begin(), crossings.end());
    return product(
        crossings, [this](Index e) { return curves_.walks.of(e); },
        [](Index, Index) { return true; });
  }

  // ---- loops in turn

  // When numbers of a loop with all others are counted, but for those with loops of before.
  enum class Count : char { LATER, NOW, BEFORE };

  // Of the loops that are asked for and not in vain: some short ones, spread over all of them; or
  // all if these are not many more, or if there is no defect yet. Returns whether there are any.
  bool choose_loops() {
    constexpr std::size_t growth = 4;
    if(most_at_once_ == 0)
      most_at_once_ = 8;
    else if(most_at_once_ < counts_.size())
      most_at_once_ = defect_.empty() ? counts_.size() : growth * most_at_once_;
    std::vector<std::size_t> loops;
    for(std::size_t i = 0; i < counts_.size(); ++i) {
      if(counts_[i] == Count::NOW)
        counts_[i] = Count::BEFORE;
      if(counts_[i] == Count::LATER && !is_in_vain_[i] &&
         (curves_.is_asked_for.empty() || curves_.is_asked_for[i]))
        loops.push_back(i);
    }
    const std::size_t step =
        loops.size() / most_at_once_ >= growth ? loops.size() / most_at_once_ : 1;
    for(std::size_t k = 0; k < loops.size(); k += step)
      counts_[shortest_of(loops, k, (std::min)(k + step, loops.size()))] = Count::NOW;
    return !loops.empty();
  }

  // Whose copy cuts the fewest corners.
  std::size_t
  shortest_of(const std::vector<std::size_t>& loops, std::size_t begin, std::size_t end) const {
    const auto at = [&](std::size_t k) { return loops.begin() + static_cast<std::ptrdiff_t>(k); };
    return *std::min_element(at(begin), at(end), [this](std::size_t a, std::size_t b) {
      return number_of_corners_[a] < number_of_corners_[b];
    });
  }

  bool is_counted_now(Index i, Index j) const {
    return counts_[i] != Count::BEFORE && counts_[j] != Count::BEFORE &&
           (counts_[i] == Count::NOW || counts_[j] == Count::NOW);
  }

  void count(Execution execution, const Sparse_matrix& touches, const Pieces& pieces) {
    Sparse_matrix numbers;
    for(const Matrix_entry& e : touches)
      if(is_counted_now(e.row, e.column))
        numbers.push_back({e.row, e.column, e.value * curves_.outward[e.column]});
    add_crossings(execution, pieces, numbers);
    contacts_.insert(contacts_.end(), new_contacts_.begin(), new_contacts_.end());
    new_contacts_.clear();
    std::sort(contacts_.begin(), contacts_.end());
    add_up(execution, numbers);
    add_defect(execution, numbers);
    linking_.insert(linking_.end(), numbers.begin(), numbers.end());
  }

  // A loop with a contact may be counted along another walk, and is not given up. Contacts of two
  // that are given up are not looked for.
  void add_defect(Execution execution, const Sparse_matrix& numbers) {
    Sparse_matrix defect = numbers;
    for(const Matrix_entry& e : numbers)
      defect.push_back({e.column, e.row, -e.value});
    for(const Matrix_entry& e : intersections_)
      if(is_counted_now(e.row, e.column))
        defect.push_back({e.row, e.column, -curves_.outward[e.row] * e.value});
    add_up(execution, defect);
    for(const Matrix_entry& e : defect)
      is_in_vain_[e.row] = is_in_vain_[e.column] = 1;
    for(const Contact& contact : contacts_)
      curves_.for_each_loop_at(contact, [this](Index loop) { is_in_vain_[loop] = 0; });
    defect_.insert(defect_.end(), defect.begin(), defect.end());
  }

  void add_contact(const Contact& contact) {
    if(std::binary_search(contacts_.begin(), contacts_.end(), contact))
      return; // found when loops of before were counted
    const std::lock_guard<std::mutex> lock(mutex_);
    if(contacts_.size() + new_contacts_.size() < 1000 + curves_.corners.size() / 16)
      new_contacts_.push_back(contact);
    else
      has_too_many_contacts_ = true;
  }

  // ---- midpoints where a copy crosses a walk

  // The same directions in each run.
  Projected_points::Direction next_direction() {
    const auto next = [this] { return (static_cast<int>(random_() % 1024) * 2 - 1023) / 1024.; };
    const double a = next() * curves_.tilts[0];
    return {a, next() * curves_.tilts[1]};
  }

  bool is_touched(std::size_t e) const {
    return !curves_.walks.of(e).empty() && !curves_.crossings.of(e).empty();
  }

  int outward_at(std::size_t e) const { return curves_.outward[curves_.walks.of(e)[0].column]; }

  // Of an edge, the ends and the third vertices of the faces to the left and right.
  std::array<Point, 4> around(std::size_t e) const {
    const Edge& edge = curves_.edges[e];
    return {points_.vertex(edge.source), points_.vertex(edge.target), points_.vertex(edge.left),
            points_.vertex(edge.right)};
  }

  // Which side of the face to the left, and to the right, is seen: 1 is the outer one.
  std::array<int, 2> visible_sides(std::size_t e) const {
    const auto [source, target, left, right] = around(e);
    return {outward_at(e) * points_.turn(source, target, left),
            outward_at(e) * points_.turn(target, source, right)};
  }

  // Whether no face at a touched edge is seen as a line.
  bool are_touches_decided() const {
    for(std::size_t e = 0; e < curves_.edges.size(); ++e)
      if(is_touched(e)) {
        const auto [left, right] = visible_sides(e);
        if(left == 0 || right == 0)
          return false;
      }
    return true;
  }

  // Whether the copy passes over the pushed edge.
  bool is_above(std::size_t e) {
    const auto [left, right] = visible_sides(e);
    if(left == right)
      return left < 0;
    const auto [source, target, left_apex, right_apex] = around(e);
    const int reflex = outward_at(e) * points_.side(source, target, left_apex, right_apex);
    if(reflex == 0 || left == 0 || right == 0)
      add_contact({Contact::no_corner, e});
    return reflex > 0;
  }

  // ---- places where a copy is seen to cross a walk

  // A line as it is seen.
  struct Seen_line
  {
    Point a, b;
    Box<2> box;
  };

  Seen_line seen_line(const Point& a, const Point& b) const {
    const double e = (std::max)(points_.position_error(a), points_.position_error(b));
    return {a,
            b,
            {{(std::min)(a.x, b.x) - e, (std::min)(a.y, b.y) - e},
             {(std::max)(a.x, b.x) + e, (std::max)(a.y, b.y) + e}}};
  }

  Seen_line seen_edge(std::size_t e) const {
    return seen_line(points_.vertex(curves_.edges[e].source),
                     points_.vertex(curves_.edges[e].target));
  }

  Seen_line seen_corner(std::size_t c) const {
    const Corner& corner = curves_.corners[c];
    return seen_line(points_.midpoint(corner.apex, corner.from),
                     points_.midpoint(corner.apex, corner.to));
  }

  // By loop, around the walk and around the copy.
  void find_extents(Execution execution) {
    extents_of_walks_ =
        extents(execution, curves_.edges.size(), [this](std::size_t e, auto extend) {
          for(const Matrix_entry& walk : curves_.walks.of(e))
            for(Index v : {curves_.edges[e].source, curves_.edges[e].target})
              extend(walk.column, v);
        });
    extents_of_copies_ =
        extents(execution, curves_.corners.size(), [this](std::size_t c, auto extend) {
          const Corner& corner = curves_.corners[c];
          for(Index v : {corner.apex, corner.from, corner.to})
            extend(corner.loop, v);
        });
  }

  // By loop, around the vertices of which `f(i, extend)` tells by `extend(loop, v)`. Loops follow
  // each other.
  template <typename Function>
  std::vector<Extent> extents(Execution execution, std::size_t n, const Function& f) const {
    using Part = std::pair<Index, Extent>;
    std::vector<Extent> extents(curves_.outward.size(), Extent::empty());
    for(const auto& [loop, extent] :
        collect<Part>(execution, n, [&](std::size_t begin, std::size_t end) {
          std::vector<Part> parts;
          for(std::size_t i = begin; i < end; ++i)
            f(i, [&](Index loop_of_vertex, Index v) {
              if(parts.empty() || parts.back().first != loop_of_vertex)
                parts.emplace_back(loop_of_vertex, Extent::empty());
              parts.back().second.extend(place(v));
            });
          return parts;
        }))
      extents[loop].extend(extent);
    return extents;
  }

  Extent place(Index v) const { return {curves_.vertices[v], curves_.vertices[v]}; }

  // Of all loops whose walks run along an edge: nothing, if they cancel each other.
  Extent extent_of_edge(std::size_t e) const {
    Extent all = Extent::empty();
    for(const Matrix_entry& walk : curves_.walks.of(e))
      all.extend(extents_of_walks_[walk.column]);
    return all;
  }

  // A loop whose copy cuts a corner, which it does in the direction of the first of these, in net
  // numbers.
  struct Copy
  {
    Index corner, loop;
    int number;
  };

  // A corner by the edge between its ends and the apex. Those at the same place come one after the
  // other, in their order.
  struct Place
  {
    std::uint64_t edge;
    Index apex, corner;

    bool is_at(const Place& p) const { return edge == p.edge && apex == p.apex; }
    bool operator<(const Place& p) const {
      return std::tie(edge, apex, corner) < std::tie(p.edge, p.apex, p.corner);
    }
  };

  std::vector<Place> places_of_corners(Execution execution) const {
    std::vector<Place> places(curves_.corners.size());
    for_each_index(execution, places.size(), [&](std::size_t c) {
      const Corner& corner = curves_.corners[c];
      places[c] = {edge_key(corner.from, corner.to), corner.apex, static_cast<Index>(c)};
    });
    sort(execution, places.begin(), places.end(), std::less<>());
    return places;
  }

  // Loops that were put together of others cut many corners in common.
  void gather_copies(Execution execution) {
    const std::vector<Place> places = places_of_corners(execution);
    using Group = std::pair<Index, Index>; // the first corner, and where they begin
    std::vector<Group> groups =
        collect<Group>(execution, places.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Group> own;
          for(std::size_t i = begin; i < end; ++i)
            if(i == 0 || !places[i].is_at(places[i - 1]))
              own.emplace_back(places[i].corner, static_cast<Index>(i));
          return own;
        });
    sort(execution, groups.begin(), groups.end(), std::less<>());
    copies_begin_.resize(groups.size() + 1);
    copies_ = collect_many<Uninitialized_vector<Copy>>(
        execution, groups.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Copy> own;
          for(std::size_t g = begin; g < end; ++g) {
            const std::size_t before = own.size();
            append_copies(places, groups[g].second, own);
            copies_begin_[g] = static_cast<Index>(own.size() - before);
          }
          return own;
        });
    sum_before_each(execution, copies_begin_);
  }

  // Those at the place of which the first is given.
  void append_copies(const std::vector<Place>& places, Index first, std::vector<Copy>& own) const {
    const std::size_t before = own.size();
    for(Index i = first; i < places.size() && places[i].is_at(places[first]); ++i) {
      const Corner& corner = curves_.corners[places[i].corner];
      if(own.size() == before || own.back().loop != corner.loop)
        own.push_back({places[i].corner, corner.loop, 0});
      own.back().number += corner.from == curves_.corners[places[first].corner].from ? 1 : -1;
    }
  }

  // The copies that cut the same corner, by the order of the first of them.
  Span<const Copy> copies(Index i) const {
    return {copies_.data() + copies_begin_[i], copies_begin_[i + 1] - copies_begin_[i]};
  }

  Extent extent_of_copies(Index i) const {
    Extent all = Extent::empty();
    for(const Copy& copy : copies(i))
      all.extend(extents_of_copies_[copy.loop]);
    return all;
  }

  // The walk that runs along an edge first: edges are numbered as walks pass them.
  Index walk_along(std::size_t e) const {
    const auto walks = curves_.walks.of(e);
    return walks.empty() ? no_index : walks[0].column;
  }

  // Where pieces of lines begin that follow each other on one loop, and the end. There are so few
  // that boxes need no memory worth speaking of.
  template <typename Loop_of>
  static std::vector<Index> begins_of_pieces(std::size_t n, const Loop_of& loop_of) {
    std::vector<Index> begins;
    for(Index i = 0; i < n; ++i)
      if(begins.empty() || i - begins.back() == most_lines || loop_of(i) != loop_of(i - 1))
        begins.push_back(i);
    begins.push_back(static_cast<Index>(n));
    return begins;
  }

  static Seen_box box_around(const Box<2>& seen, const Extent& e) {
    return {{seen.low[0], seen.low[1], e.low[0], e.low[1], e.low[2]},
            {seen.high[0], seen.high[1], e.high[0], e.high[1], e.high[2]}};
  }

  // The order of pieces along a space-filling curve, in slabs: what is seen at one place may be of
  // loops that are far apart. `height(i)` is half of a height.
  template <typename Height>
  static Uninitialized_vector<Index>
  order(Execution execution, const std::vector<Seen_box>& boxes, const Height& height) {
    constexpr double slabs = 8.;
    Seen_box all = Seen_box::empty();
    double low = 0., high = 0.;
    for(std::size_t i = 0; i < boxes.size(); ++i) {
      all.extend(boxes[i]);
      low = i == 0 ? height(i) : (std::min)(low, height(i));
      high = i == 0 ? height(i) : (std::max)(high, height(i));
    }
    const Box<1> heights = {{low}, {high}};
    return space_filling_order(execution, boxes.size(), [&](std::size_t i) {
      const Seen_box& b = boxes[i];
      return Vector{all.part(0, b.low[0]), all.part(1, b.low[1]),
                    std::floor(slabs * heights.part(0, height(i))) / slabs};
    });
  }

  // Those of walks for whose loops that holds.
  template <typename Is_wanted>
  Pieces pieces_where(const Pieces& all, const Is_wanted& is_wanted) const {
    Uninitialized_vector<Index> numbers;
    std::vector<Seen_box> boxes;
    for(std::size_t i = 0; i < all.numbers.size(); ++i) {
      bool is_any = false;
      for(Index e = all.begins[all.numbers[i]]; !is_any && e < all.begins[all.numbers[i] + 1]; ++e)
        for(const Matrix_entry& walk : curves_.walks.of(e))
          is_any = is_any || is_wanted(counts_[walk.column]);
      if(is_any) {
        numbers.push_back(all.numbers[i]);
        boxes.push_back(all.tree.box(i));
      }
    }
    return {all.begins, std::move(numbers), Box_tree<5>(std::move(boxes))};
  }

  Pieces pieces_of_walks(Execution execution) const {
    std::vector<Index> begins =
        begins_of_pieces(curves_.edges.size(), [this](std::size_t e) { return walk_along(e); });
    std::vector<Seen_box> boxes(begins.size() - 1), sorted(boxes.size());
    for_each_index(execution, boxes.size(), [&](std::size_t i) {
      boxes[i] = Seen_box::empty();
      for(Index e = begins[i]; e < begins[i + 1]; ++e)
        boxes[i].extend(box_around(seen_edge(e).box, extent_of_edge(e)));
    });
    Uninitialized_vector<Index> numbers = order(execution, boxes, [&](std::size_t i) {
      return curves_.vertices[curves_.edges[begins[i]].source][2] / 2.;
    });
    for(std::size_t i = 0; i < sorted.size(); ++i)
      sorted[i] = boxes[numbers[i]];
    return {std::move(begins), std::move(numbers), Box_tree<5>(std::move(sorted))};
  }

  void add_crossings(Execution execution, const Pieces& pieces, Sparse_matrix& numbers) {
    const Pieces left = pieces_where(pieces, [](Count c) { return c != Count::BEFORE; }),
                 now = pieces_where(pieces, [](Count c) { return c == Count::NOW; });
    const std::vector<Index> begins = begins_of_pieces(
        copies_begin_.size() - 1, [this](std::size_t i) { return copies_[copies_begin_[i]].loop; });
    const std::vector<Matrix_entry> entries = collect<Matrix_entry>(
        execution, begins.size() - 1,
        [&](std::size_t begin, std::size_t end) {
          Sparse_matrix crossed;
          for(std::size_t i = begin; i < end; ++i) {
            execution.look();
            add_crossings(is_any_counted_now(begins[i], begins[i + 1]) ? left : now, begins[i],
                          begins[i + 1], crossed);
          }
          add_up(Execution(), crossed);
          return numbers_of_copies(begins[begin], begins[end], crossed);
        },
        256);
    numbers.insert(numbers.end(), entries.begin(), entries.end());
  }

  // Of the copies that cut some corners, by how often each of these, once for all its copies, is
  // seen to pass over walks. A copy and a walk that are apart may be seen in part only.
  Sparse_matrix numbers_of_copies(Index begin, Index end, const Sparse_matrix& crossed) const {
    std::vector<std::size_t> rows(end - begin + std::size_t(1), 0); // where they begin, by corner
    for(const Matrix_entry& e : crossed)
      ++rows[e.row - begin + 1];
    std::partial_sum(rows.begin(), rows.end(), rows.begin());
    const auto walks_under = [&](Index c) {
      return Span<const Matrix_entry>(crossed.data() + rows[c - begin],
                                      rows[c - begin + 1] - rows[c - begin]);
    };
    Sparse_matrix cuts; // of corners, by copy
    for(Index c = begin; c < end; ++c)
      for(const Copy& copy : copies(c))
        if(copy.number != 0 && !walks_under(c).empty())
          cuts.push_back({copy.loop, c, copy.number});
    std::sort(cuts.begin(), cuts.end());
    return product(cuts, walks_under, [this](Index copy, Index walk) {
      return is_counted_now(copy, walk) && extents_of_copies_[copy].meets(extents_of_walks_[walk]);
    });
  }

  // Whether any of the copies that cut some corners is of a loop whose numbers are counted now.
  bool is_any_counted_now(Index begin, Index end) const {
    return std::any_of(copies_.begin() + copies_begin_[begin], copies_.begin() + copies_begin_[end],
                       [this](const Copy& copy) { return counts_[copy.loop] == Count::NOW; });
  }

  // Of the corners of a piece of a copy, with walks.
  void add_crossings(const Pieces& pieces, Index begin, Index end, Sparse_matrix& crossed) {
    std::array<Seen_line, most_lines> corners;
    Box<2> seen = Box<2>::empty();
    Extent extent = Extent::empty();
    for(Index i = begin; i < end; ++i) {
      corners[i - begin] = seen_corner(copies(i)[0].corner);
      seen.extend(corners[i - begin].box);
      extent.extend(extent_of_copies(i));
    }
    pieces.tree.for_each_meeting(box_around(seen, extent), [&](Index i, const Seen_box&) {
      const Index piece = pieces.numbers[i];
      for(Index e = pieces.begins[piece]; e < pieces.begins[piece + 1]; ++e) {
        const Seen_line edge = seen_edge(e);
        if(edge.box.meets(seen) && extent_of_edge(e).meets(extent))
          for(Index c = begin; c < end; ++c)
            if(corners[c - begin].box.meets(edge.box))
              add_terms(c, corners[c - begin], e, edge, crossed);
      }
    });
  }

  void add_terms(Index c,
                 const Seen_line& line_of_corner,
                 Index e,
                 const Seen_line& line_of_edge,
                 Sparse_matrix& crossed) {
    if(has_too_many_contacts_ || touches(curves_.corners[copies(c)[0].corner], curves_.edges[e]))
      return;
    const std::optional<int> sign = crossing(line_of_corner, line_of_edge);
    if(!sign)
      for(const Copy& copy : copies(c))
        add_contact({copy.corner, e});
    else if(*sign != 0)
      for(const Matrix_entry& walk : curves_.walks.of(e))
        crossed.push_back({c, walk.column, *sign * walk.value});
  }

  static bool touches(const Corner& c, const Edge& edge) {
    const Index other = edge.source == c.apex ? edge.target : edge.source;
    return (edge.source == c.apex || edge.target == c.apex) && (other == c.from || other == c.to);
  }

  // 0 unless the corner is seen to pass over the edge; 1 if the edge then leads to the left;
  // nothing if they meet.
  std::optional<int> crossing(const Seen_line& corner, const Seen_line& edge) const {
    const Point &a = corner.a, &b = corner.b, &p = edge.a, &q = edge.b;
    if(points_.turn(a, b, p) * points_.turn(a, b, q) > 0 ||
       points_.turn(p, q, a) * points_.turn(p, q, b) > 0)
      return 0;
    // They are seen to meet. If they lie in a plane they do meet.
    const int side = points_.side(a, b, p, q);
    if(side == 0)
      return std::nullopt;
    const int sense = points_.crossing_of_moved(a, b, p, q);
    return side == sense ? sense : 0;
  }

  const Surface_curves& curves_;
  std::minstd_rand random_;
  Projected_points points_;
  Sparse_matrix linking_, intersections_, defect_; // see `Linking`
  int number_of_attempts_ = 0;
  std::vector<Index> number_of_corners_; // by loop
  std::vector<Count> counts_;            // by loop
  std::vector<char> is_in_vain_;         // by loop, whether its numbers are known to mean nothing
  std::size_t most_at_once_ = 0;
  std::vector<Extent> extents_of_walks_, extents_of_copies_; // by loop
  Uninitialized_vector<Copy> copies_;                        // those of one corner together
  std::vector<Index> copies_begin_;                          // by corner
  std::vector<Contact> contacts_;                            // in order
  std::vector<Contact> new_contacts_;                        // since loops were last counted
  std::mutex mutex_;                                         // for the new ones
  std::atomic<bool> has_too_many_contacts_{false};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINKING_NUMBERS_H
