// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "generators.h"

#include "Random.h"
#include "kinds.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

using Index = std::uint32_t;
constexpr Index none = static_cast<Index>(-1);

// Halfedges 3f, 3f + 1, 3f + 2 lead around face f.
class Hole_cutter
{
public:
  explicit Hole_cutter(const Soup& mesh)
      : mesh_(mesh)
      , is_gone_(mesh.triangles.size(), 0)
      , is_taken_(mesh.points.size(), 0)
      , next_(mesh.points.size(), none)
      , previous_(mesh.points.size(), none) {
    find_twins();
  }

  void cut(const Hole_request& holes) {
    std::vector<Index> centers(mesh_.points.size());
    std::iota(centers.begin(), centers.end(), Index(0));
    Random random(holes.seed);
    random.shuffle(centers);
    std::size_t number = 0;
    for(const Index v : centers)
      if(number < holes.number && out_[v] != none && cut_star(v)) {
        widen(holes.faces, holes.is_ragged);
        ++number;
      }
    if(number < holes.number && !holes.may_be_fewer)
      throw std::invalid_argument("only " + std::to_string(number) + " of " +
                                  counted(holes.number, "hole", "holes") +
                                  (number == 1 || holes.number == 1 ? " fits" : " fit") +
                                  ": use more faces, fewer holes or smaller ones");
  }

  Soup take() const {
    Soup result;
    std::vector<Index> number(mesh_.points.size(), none);
    for(Index f = 0; f < mesh_.triangles.size(); ++f) {
      if(is_gone_[f])
        continue;
      auto triangle = mesh_.triangles[f];
      for(Index& v : triangle) {
        if(number[v] == none) {
          number[v] = static_cast<Index>(result.points.size());
          result.points.push_back(mesh_.points[v]);
        }
        v = number[v];
      }
      result.triangles.push_back(triangle);
    }
    return result;
  }

private:
  static Index after(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index before(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return mesh_.triangles[h / 3][h % 3]; }
  Index target(Index h) const { return source(after(h)); }

  void find_twins() {
    const Index n = static_cast<Index>(3 * mesh_.triangles.size());
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index(0));
    const auto key = [this](Index h) { return std::minmax({source(h), target(h)}); };
    std::sort(order.begin(), order.end(), [&](Index g, Index h) { return key(g) < key(h); });
    twin_.resize(n);
    for(Index i = 0; i < n; i += 2) {
      twin_[order[i]] = order[i + 1];
      twin_[order[i + 1]] = order[i];
    }
    out_.assign(mesh_.points.size(), none);
    for(Index h = 0; h < n; ++h)
      out_[source(h)] = h;
  }

  // Takes the faces at a vertex, if none of their vertices belongs to another hole.
  bool cut_star(Index v) {
    std::vector<Index> rim; // halfedges of the faces
    Index h = out_[v];
    do {
      rim.push_back(after(h));
      h = twin_[before(h)];
    } while(h != out_[v]);
    if(is_taken_[v] ||
       std::any_of(rim.begin(), rim.end(), [this](Index r) { return is_taken_[source(r)] != 0; }))
      return false;
    is_taken_[v] = 1;
    rim_.clear();
    size_ = rim.size();
    for(const Index r : rim) {
      is_gone_[r / 3] = 1;
      is_taken_[source(r)] = 1;
      link(source(r), target(r));
      rim_.push_back(r);
    }
    return true;
  }

  // On the boundary of the hole.
  void link(Index u, Index v) {
    next_[u] = v;
    previous_[v] = u;
  }

  // Takes faces beyond the rim, one after the other: those with a vertex that belongs to no hole,
  // and for a round hole those that fill a notch.
  void widen(std::size_t faces, bool is_ragged) {
    for(std::size_t i = 0; i < rim_.size() && size_ < faces; ++i) {
      const Index out = twin_[rim_[i]], u = source(rim_[i]), v = target(rim_[i]);
      if(is_gone_[out / 3] || next_[u] != v)
        continue;
      const Index tip = source(before(out));
      if(!is_taken_[tip]) {
        is_taken_[tip] = 1;
        link(u, tip);
        link(tip, v);
      } else if(!is_ragged && next_[v] == tip && next_[tip] != u)
        link(u, tip);
      else if(!is_ragged && previous_[u] == tip && next_[v] != tip)
        link(tip, v);
      else
        continue;
      is_gone_[out / 3] = 1;
      ++size_;
      rim_.insert(rim_.end(), {after(out), before(out)});
    }
  }

  const Soup& mesh_;
  std::vector<Index> twin_, out_;      // by halfedge, and by vertex
  std::vector<char> is_gone_;          // by face
  std::vector<char> is_taken_;         // by vertex, whether it belongs to a hole
  std::vector<Index> next_, previous_; // by vertex, along the boundary of its hole
  std::vector<Index> rim_;             // halfedges of faces of the hole
  std::size_t size_ = 0;               // of the hole, in faces
};

} // namespace

Soup with_holes(const Soup& mesh, const Hole_request& holes) {
  Hole_cutter cutter(mesh);
  cutter.cut(holes);
  return cutter.take();
}

} // namespace CGAL::Handle_tunnel_loops::generators
