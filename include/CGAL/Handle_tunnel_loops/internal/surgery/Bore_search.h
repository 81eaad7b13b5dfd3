// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index_table.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Concave_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the wall of the bore that a tunnel loop goes around: the faces that are reached from it
without passing a convex edge of the solid, if they are bounded by the mouths of the bore. If a
mouth lies at the bottom of a counterbore, the wall of that belongs to it. Where bores meet there
are convex edges; if so wanted, what is beyond a mouth in no plane belongs to the wall, too. One
mouth lies in a plane, or all but does: what is rounded everywhere is no bore.
*/
class Bore_search
{
public:
  Bore_search(const Surgery_mesh& mesh, const Concave_pieces& pieces)
      : mesh_(mesh)
      , pieces_(pieces) {}

  /// Of a bore by itself, and together with bores that it meets; there may be but one of them.
  struct Walls
  {
    std::optional<Cut_region> alone, joined;
  };

  /// of a bore that a loop goes around. Gives up where the wall is many times as
  /// large, or has many mouths. Near linear in its size.
  Walls walls_at(const Curve_off_vertices& loop) const {
    const std::vector<Index> faces = loop.faces();
    const std::size_t most = most_tried + 64 * faces.size();
    Walls walls = walls_of(flood(faces, most), loop, most);
    // What is reached may lead over a mouth and around to other bores, which is the last resort.
    std::size_t number = 0; // of faces that were tried in vain
    if(!walls.alone)
      for(Flood& wall : floods_without_mouths(faces, most)) {
        number += wall.faces.size();
        Walls others = walls_of(std::move(wall), loop, most_tried);
        if(others.alone || !walls.joined)
          walls = std::move(others);
        if(walls.alone || number >= most_tried)
          break;
      }
    return walls;
  }

private:
  static constexpr std::size_t most_tried = 4000, most_mouths = 16;
  static constexpr double most_growth = 2.5; // of the border, by a counterbore

  // What is reached without passing a convex edge.
  struct Flood
  {
    std::vector<Index> faces; // in ascending order
    bool is_bounded;          // these are all, and none of them is in a cap
  };

  // What is reached from a loop along a mouth, where some of its faces are beyond that: from one of
  // them; and, as the wall may have convex edges of its own, that with what is beside it but for
  // two others, which may be beyond the mouths.
  std::vector<Flood> floods_without_mouths(const std::vector<Index>& faces,
                                           std::size_t most) const {
    std::vector<Flood> floods = floods_from(faces, most).floods;
    const std::size_t number = floods.size();
    for(std::size_t i = 0; i < number; ++i) {
      const auto is_here = [&](Index f) { return is_in(f, floods[i].faces); };
      if(4 * static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), is_here)) <
         faces.size())
        continue; // the loop hardly goes around there
      const Floods beside = floods_from(faces_beyond(floods[i].faces), most);
      for(Flood& wall : with_all_but_two(floods[i], beside))
        floods.push_back(std::move(wall));
    }
    // The walls are smaller than the plates that they lead through.
    std::sort(floods.begin() + static_cast<std::ptrdiff_t>(number), floods.end(),
              [](const Flood& a, const Flood& b) {
                const std::size_t m = a.faces.size(), n = b.faces.size();
                return m != n ? m < n : a.faces < b.faces;
              });
    return floods;
  }

  // Those that come to an end, each once, and where the others begin.
  struct Floods
  {
    std::vector<Flood> floods;
    std::vector<Index> pieces_without_end;
  };

  Floods floods_from(const std::vector<Index>& faces, std::size_t most) const {
    Floods all;
    std::vector<Index>& endless = all.pieces_without_end;
    std::vector<Index> tried;
    for(std::size_t i = 0; i < faces.size() && tried.size() < most_tried; ++i) {
      const Index piece = pieces_.piece(faces[i]);
      if(is_in(faces[i], tried) ||
         std::find(endless.begin(), endless.end(), piece) != endless.end())
        continue;
      Flood reached = flood({faces[i]}, most);
      tried = united(tried, reached.faces);
      if(reached.is_bounded)
        all.floods.push_back(std::move(reached));
      else
        endless.push_back(piece);
    }
    return all;
  }

  std::vector<Index> faces_beyond(const std::vector<Index>& faces) const {
    std::vector<Index> beyond;
    for(Index f : faces)
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        if(const Index g = mesh_.face(mesh_.twin(h)); !is_in(g, faces))
          beyond.push_back(g);
    make_set(beyond);
    return beyond;
  }

  // A flood with those beside it, but for two, to which those without end count.
  static std::vector<Flood> with_all_but_two(const Flood& flood, const Floods& beside) {
    constexpr std::size_t most_beside = 8;
    const std::size_t n = beside.floods.size(),
                      number_out = 2 - (std::min)(std::size_t(2), beside.pieces_without_end.size());
    std::vector<Flood> all;
    if(n <= number_out || n > most_beside)
      return all;
    for(unsigned choice = 0; choice < 1u << n; ++choice) {
      const std::bitset<most_beside> is_out(choice);
      if(is_out.count() != number_out)
        continue;
      all.push_back(flood);
      for(std::size_t k = 0; k < n; ++k)
        if(!is_out[k])
          all.back().faces = united(all.back().faces, beside.floods[k].faces);
    }
    return all;
  }

  // A counterbore may have so many faces.
  Walls walls_of(Flood reached, const Curve_off_vertices& loop, std::size_t most) const {
    Walls walls;
    if(!reached.is_bounded)
      return walls;
    std::optional<Cut_region> wall = Cut_region::wall(mesh_, std::move(reached.faces));
    if(!wall || wall->number_of_borders() > most_mouths)
      return walls;
    const auto counterbores = [&](const Cut_region& w, std::size_t border) {
      return with_counterbore(w, border, most);
    };
    wall = widened(std::move(*wall), counterbores);
    if(!wall)
      return walls;
    // What has no mouth in a plane is no bore that others could meet.
    if(const std::size_t number = number_of_flush_mouths(*wall);
       number == wall->number_of_borders())
      walls.joined = wall;
    else if(number > 0)
      walls.joined = widened(*wall, [&](const Cut_region& w, std::size_t border) {
        auto wider = counterbores(w, border);
        return wider ? std::move(wider) : with_bore_that_meets(w, border, most);
      });
    if(walls.joined && number_of_flush_mouths(*walls.joined) != walls.joined->number_of_borders())
      walls.joined.reset();
    if(are_mouths_closed_well(*wall, loop.length()))
      walls.alone = std::move(wall);
    return walls;
  }

  bool is_flush_at(const Cut_region& wall, std::size_t border) const {
    return is_flush(rim_of(mesh_, wall, border));
  }

  std::size_t number_of_flush_mouths(const Cut_region& wall) const {
    std::size_t number = 0;
    for(std::size_t border = 0; border < wall.number_of_borders(); ++border)
      number += is_flush_at(wall, border);
    return number;
  }

  // Whether each is flush; or at least one is nearly so, and the others are narrow.
  bool are_mouths_closed_well(const Cut_region& wall, double length_of_loop) const {
    constexpr double most_ratio = 1.5;
    bool is_any_flush = false;
    for(std::size_t border = 0; border < wall.number_of_borders(); ++border) {
      const Polygon_in_space rim = rim_of(mesh_, wall, border);
      const bool is_flush = internal::is_flush(rim);
      is_any_flush |= is_flush || is_nearly_flush(rim);
      if(!is_flush && !(length(wall.border(border)) <= most_ratio * length_of_loop))
        return false;
    }
    return is_any_flush;
  }

  Flood flood(const std::vector<Index>& begin, std::size_t most) const {
    Flood flood{{}, true};
    std::vector<Index>& reached = flood.faces;
    Index_table is_reached, pieces;
    std::size_t size = 0; // of the pieces
    const auto reach = [&](Index f) {
      if(!is_reached.insert(f, 0).second)
        return;
      reached.push_back(f);
      const Index piece = pieces_.piece(f);
      if(piece != no_index && pieces.insert(piece, 0).second)
        size += pieces_.size(piece);
      flood.is_bounded =
          flood.is_bounded && size <= most && reached.size() <= most && !mesh_.is_in_cap(f);
    };
    for(Index f : begin)
      reach(f);
    for(std::size_t i = 0; i < reached.size() && flood.is_bounded; ++i)
      for(Index h : {3 * reached[i], 3 * reached[i] + 1, 3 * reached[i] + 2})
        if(const Index f = mesh_.face(mesh_.twin(h));
           is_reached.find(f) == nullptr && !pieces_.is_convex(h))
          reach(f);
    make_set(reached);
    return flood;
  }

  // With what is beyond the mouths, as long as `wider(wall, border)` gives that of one. None if
  // there are too many in the end. What is not given is not given later: the wall only grows.
  template <typename Function>
  std::optional<Cut_region> widened(Cut_region wall, const Function& wider) const {
    std::vector<Index> done; // by their first halfedges, borders beyond which there is nothing
    for(std::size_t border = 0; border < wall.number_of_borders();) {
      const Index first = wall.border(border).front();
      if(std::find(done.begin(), done.end(), first) != done.end())
        ++border;
      else if(std::optional<Cut_region> next = wider(wall, border)) {
        wall = std::move(*next);
        if(wall.number_of_borders() > most_mouths)
          return std::nullopt;
        border = 0;
      } else
        done.push_back(first);
    }
    return wall;
  }

  // A ring around a mouth, up to one that is flush with what is around it, and not much larger.
  std::optional<Cut_region>
  with_counterbore(const Cut_region& wall, std::size_t border, std::size_t most) const {
    if(!Scaled_polygon(rim_of(mesh_, wall, border)).is_flat())
      return std::nullopt;
    const double most_length = most_growth * length(wall.border(border));
    std::optional<Cut_region> wider = with_faces_beyond(wall, border, most, most_length);
    if(!wider || wider->number_of_borders() != wall.number_of_borders())
      return std::nullopt;
    const std::vector<std::size_t> outer = new_borders(*wider, wall);
    const bool is_ring = outer.size() == 1 && length(wider->border(outer[0])) <= most_length;
    return is_ring && is_flush_at(*wider, outer[0]) ? wider : std::nullopt;
  }

  // Another bore leads to mouths of its own. If there is only one of these, and much larger, it is
  // the edge of a pocket.
  std::optional<Cut_region>
  with_bore_that_meets(const Cut_region& wall, std::size_t border, std::size_t most) const {
    if(is_flush_at(wall, border))
      return std::nullopt;
    std::optional<Cut_region> wider = with_faces_beyond(wall, border, most, std::nullopt);
    if(!wider)
      return std::nullopt;
    const std::vector<std::size_t> outer = new_borders(*wider, wall);
    const bool is_pocket = outer.size() == 1 && !(length(wider->border(outer[0])) <=
                                                  most_growth * length(wall.border(border)));
    return is_pocket ? std::nullopt : wider;
  }

  // If none of them has a border that is longer, where that counts.
  std::optional<Cut_region> with_faces_beyond(const Cut_region& wall,
                                              std::size_t border,
                                              std::size_t most,
                                              std::optional<double> most_length) const {
    if(wall.faces().size() >= most)
      return std::nullopt;
    std::vector<Index> beyond;
    for(Index h : wall.border(border))
      beyond.push_back(mesh_.face(mesh_.twin(h)));
    make_set(beyond);
    const auto [faces, is_bounded] = flood(beyond, most - wall.faces().size());
    if(!is_bounded ||
       (most_length && is_any_longer(Cut_region::borders_of(mesh_, faces), *most_length)))
      return std::nullopt;
    std::vector<Index> all = united(wall.faces(), faces);
    const bool leads_back = all.size() != wall.faces().size() + faces.size();
    return leads_back ? std::nullopt : Cut_region::wall(mesh_, std::move(all));
  }

  // The borders that are none of another wall.
  std::vector<std::size_t> new_borders(const Cut_region& wider, const Cut_region& wall) const {
    std::vector<std::size_t> borders;
    for(std::size_t i = 0; i < wider.number_of_borders(); ++i)
      if(!wall.contains(mesh_.face(wider.border(i).front())))
        borders.push_back(i);
    return borders;
  }

  bool is_any_longer(const std::vector<std::vector<Index>>& borders, double most_length) const {
    return std::any_of(borders.begin(), borders.end(),
                       [&](const auto& border) { return !(length(border) <= most_length); });
  }

  double length(const std::vector<Index>& border) const {
    double sum = 0.;
    for(Index h : border)
      sum += distance(mesh_, mesh_.source(h), mesh_.target(h));
    return sum;
  }

  const Surgery_mesh& mesh_;
  const Concave_pieces& pieces_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H
