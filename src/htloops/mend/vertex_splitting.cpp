// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/vertex_splitting.h"

#include "mend/change_counter.h"
#include "read/soup_words.h"

namespace htloops {
namespace {

std::uint32_t previous_in_triangle(std::uint32_t halfedge) {
  return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1;
}

// A corner has the number of the halfedge that begins there.
class Splitter
{
public:
  Splitter(Mended_soup& mended, const Neighbors& neighbors)
      : mended_(mended)
      , neighbors_(neighbors)
      , is_seen_(neighbors.size(), false)
      , number_of_fans_(mended.soup.points.size(), 0) {}

  void run() {
    const auto number_of_vertices = static_cast<std::uint32_t>(number_of_fans_.size());
    for(std::uint32_t corner = 0; corner < neighbors_.size(); ++corner)
      if(!is_seen_[corner])
        take_fan(corner);
    Change_counter counter;
    for(std::uint32_t v = 0; v < number_of_vertices; ++v)
      if(number_of_fans_[v] > 1)
        counter.add(
            [&] { return name_of_vertex(v) + " into " + std::to_string(number_of_fans_[v]); });
    counter.report(mended_, "vertex split", "vertices split");
  }

private:
  void take_fan(std::uint32_t corner) {
    const std::uint32_t v = mended_.soup.source(corner);
    const std::uint32_t own =
        ++number_of_fans_[v] == 1 ? v : mended_.add_vertex(Point(mended_.soup.points[v]), v);
    std::uint32_t c = corner;
    do {
      take_corner(c, own);
      const std::uint32_t g = neighbors_[previous_in_triangle(c)];
      if(g == no_halfedge) {
        take_other_way(corner, own);
        return;
      }
      c = g;
    } while(c != corner);
  }

  // The fan ends on one side; the rest of it lies on the other side of where it began.
  void take_other_way(std::uint32_t corner, std::uint32_t own) {
    for(std::uint32_t g = neighbors_[corner]; g != no_halfedge; g = neighbors_[corner]) {
      corner = next_in_triangle(g);
      take_corner(corner, own);
    }
  }

  void take_corner(std::uint32_t corner, std::uint32_t own) {
    is_seen_[corner] = true;
    mended_.soup.faces[corner / 3][corner % 3] = own;
  }

  Mended_soup& mended_;
  const Neighbors& neighbors_;
  std::vector<bool> is_seen_;
  std::vector<std::uint32_t> number_of_fans_;
};

} // namespace

void split_vertices(Mended_soup& mended, const Neighbors& neighbors) {
  Splitter(mended, neighbors).run();
}

} // namespace htloops
