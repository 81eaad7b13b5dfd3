// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <unordered_map>

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
      , neighbors_(neighbors) {}

  bool run() {
    const std::size_t number_before = mended_.soup.points.size();
    for(std::uint32_t corner = 0; corner < neighbors_.size(); ++corner)
      if(!is_seen_[corner])
        take_fan(corner);
    return mended_.soup.points.size() != number_before;
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
  std::vector<bool> is_seen_ = std::vector<bool>(neighbors_.size());
  std::vector<std::uint32_t> number_of_fans_ =
      std::vector<std::uint32_t>(mended_.soup.points.size());
};

// Their sum may be beyond all numbers.
Point middle_of(const Point& p, const Point& q) {
  return {0.5 * p.x() + 0.5 * q.x(), 0.5 * p.y() + 0.5 * q.y(), 0.5 * p.z() + 0.5 * q.z()};
}

class Divider
{
public:
  Divider(Mended_soup& mended, Gluing& gluing)
      : mended_(mended)
      , gluing_(gluing) {}

  void run() {
    for(std::uint32_t h : surplus_edges()) {
      // Where it is by now.
      for(auto moved = moved_.find(h); moved != moved_.end(); moved = moved_.find(h))
        h = moved->second;
      mended_.log.add(Change_kind::EDGES_DIVIDED, [&] {
        return name_of_edge(mended_.in_file(soup_.source(h)),
                            mended_.in_file(soup_.source(next_in_triangle(h))));
      });
      divide(h);
    }
  }

private:
  // One halfedge of each.
  std::vector<std::uint32_t> surplus_edges() const {
    std::vector<std::uint32_t> surplus;
    Edge_table(soup_).for_each_edge([&](const Edge_table::Edge& edge) {
      for(std::size_t i = 1; i < edge.size(); ++i) {
        const std::uint32_t h = edge.halfedge(i), g = neighbors_[h];
        if(g != edge.halfedge(0) && (g == no_halfedge || h < g))
          surplus.push_back(h);
      }
    });
    return surplus;
  }

  void divide(std::uint32_t h) {
    const std::uint32_t u = soup_.source(h), v = soup_.source(next_in_triangle(h));
    const std::uint32_t middle =
        mended_.add_vertex(middle_of(soup_.points[u], soup_.points[v]), mended_.in_file(u));
    const std::uint32_t g = neighbors_[h];
    const std::uint32_t second_of_h = divide_face(h, middle);
    if(g == no_halfedge)
      return;
    const std::uint32_t second_of_g = divide_face(g, middle);
    glue(h, second_of_g);
    glue(g, second_of_h);
  }

  void glue(std::uint32_t h, std::uint32_t g) {
    neighbors_[h] = g;
    if(g != no_halfedge)
      neighbors_[g] = h;
  }

  // The halfedge keeps its first half; that of its second half is returned.
  std::uint32_t divide_face(std::uint32_t h, std::uint32_t middle) {
    const std::uint32_t next = next_in_triangle(h), last = next_in_triangle(next);
    const std::uint32_t first = static_cast<std::uint32_t>(3 * soup_.faces.size());
    Soup_face face = soup_.faces[h / 3];
    face[0] = middle;
    face[1] = soup_.source(next);
    face[2] = soup_.source(last);
    soup_.faces.push_back(face);
    mended_.face_in_file.push_back(std::uint32_t(mended_.face_in_file[h / 3]));
    soup_.faces[next / 3][next % 3] = middle;
    gluing_.is_turned.push_back(bool(gluing_.is_turned[h / 3]));
    neighbors_.resize(neighbors_.size() + 3, no_halfedge);
    glue(first + 1, neighbors_[next]);
    moved_[next] = first + 1;
    glue(next, first + 2);
    return first;
  }

  Mended_soup& mended_;
  Soup& soup_ = mended_.soup;
  Gluing& gluing_;
  Neighbors& neighbors_ = gluing_.neighbors;
  std::unordered_map<std::uint32_t, std::uint32_t> moved_;
};

} // namespace

bool split_vertices(Mended_soup& mended, const Neighbors& neighbors) {
  return Splitter(mended, neighbors).run();
}

void divide_parallel_edges(Mended_soup& mended, Gluing& gluing) { Divider(mended, gluing).run(); }

} // namespace htloops
