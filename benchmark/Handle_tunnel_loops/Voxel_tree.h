// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_VOXEL_TREE_H
#define BENCHMARK_VOXEL_TREE_H

#include "Loop_cones.h"

#include <array>
#include <queue>
#include <unordered_map>
#include <vector>

/// \file Voxel_tree.h
/// Cubes of different sizes, and how far from a surface the places in each of them are at most.

namespace voxel_measures {

/// The cube around a surface, halved in each direction where it is asked for. Cubes that the
/// surface may meet are "cut", the others "whole": those are on one side of it.
class Voxel_tree
{
public:
  struct Voxel
  {
    std::array<std::uint32_t, 3> low{}; ///< in units of the smallest possible
    int level = 0;                      ///< the sides are halves of those of the level before
    std::uint32_t first_child = 0;      ///< of eight; none for 0
    double middle = 0.;                 ///< how far from the surface its middle is
    double known = 0.;                  ///< some place in it is as far away as that
    double most = 0.;                   ///< no place in it is farther away
    bool is_bounded = false;            ///< `most` is as good as it gets
    std::vector<std::uint32_t> cones;   ///< triangles of the cones that meet it, and maybe others
  };

  Voxel_tree(const Triangle_tree& surface, const Loop_cones& cones, CGAL::Random& random)
      : surface_(surface)
      , cones_(cones) {
    const CGAL::Bbox_3 box = surface.box();
    double square = 0., widest = 0.;
    for(int i = 0; i < 3; ++i) {
      square += std::pow((box.max)(i) - (box.min)(i), 2.);
      widest = (std::max)(widest, (box.max)(i) - (box.min)(i));
    }
    // No place between points of the surface is farther from it than the diagonal.
    side_ = widest + 2.1 * std::sqrt(square);
    for(int i = 0; i < 3; ++i)
      corner_[i] = ((box.max)(i) + (box.min)(i)-side_) / 2. +
                   random.get_double(-0.02, 0.02) * std::sqrt(square);
    Voxel root;
    for(std::size_t t = 0; t < cones.triangles().size(); ++t)
      root.cones.push_back(std::uint32_t(t));
    add(std::move(root), std::numeric_limits<double>::infinity());
  }

  std::size_t size() const { return voxels_.size(); }
  const Voxel& operator[](std::size_t v) const { return voxels_[v]; }

  Point middle(std::size_t v) const { return place(voxels_[v], 0.5, 0.5, 0.5); }
  double half_diagonal(std::size_t v) const { return std::sqrt(0.75) * side(voxels_[v]); }
  bool is_whole(std::size_t v) const { return voxels_[v].middle > half_diagonal(v); }
  bool is_leaf(std::size_t v) const { return voxels_[v].first_child == 0; }

  /// divides and bounds until all leaves with places as far away as that are whole and bounded.
  /// Returns false if there are too many.
  bool settle(double least, std::size_t most_voxels) {
    for(std::vector<std::uint32_t> stack = leaves(least); !stack.empty();) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if(voxels_[v].most < least)
        continue;
      bound(v);
      if(voxels_[v].most < least || is_whole(v))
        continue;
      if(voxels_.size() > most_voxels || voxels_[v].level >= deepest)
        return false;
      divide(v);
      for(std::uint32_t i = 0; i < 8; ++i)
        stack.push_back(voxels_[v].first_child + i);
    }
    return true;
  }

  /// the leaves with places as far away as that.
  std::vector<std::uint32_t> leaves(double least) const {
    std::vector<std::uint32_t> result;
    for(std::size_t v = 0; v < voxels_.size(); ++v)
      if(is_leaf(v) && voxels_[v].most >= least)
        result.push_back(std::uint32_t(v));
    return result;
  }

  void divide(std::uint32_t v) {
    const auto first = std::uint32_t(voxels_.size());
    if(voxels_[v].level >= deepest)
      return;
    for(std::uint32_t i = 0; i < 8; ++i) {
      Voxel child;
      child.low = voxels_[v].low;
      child.level = voxels_[v].level + 1;
      for(int axis = 0; axis < 3; ++axis)
        child.low[axis] += (i >> axis & 1) * units(child);
      const Point m = place(child, 0.5, 0.5, 0.5);
      const double reach = (1. + 1e-9) * std::sqrt(0.75) * side(child);
      for(const std::uint32_t t : voxels_[v].cones)
        if(distance(m, cones_.triangles()[t]) <= reach)
          child.cones.push_back(t);
      add(std::move(child), voxels_[v].most);
    }
    voxels_[v].first_child = first;
    voxels_[v].cones = {};
  }

  /// calls `visit` with the leaves that touch a leaf and are not smaller; maybe more than once.
  template <typename Visit> void visit_touching(std::uint32_t v, const Visit& visit) const {
    const Voxel& voxel = voxels_[v];
    const std::int64_t step = units(voxel);
    for(int n = 0; n < 27; ++n) {
      std::array<std::uint32_t, 3> at;
      bool is_in = n != 13;
      for(int axis = 0, rest = n; axis < 3; ++axis, rest /= 3) {
        const std::int64_t x = voxel.low[axis] + (rest % 3 - 1) * step;
        is_in = is_in && x >= 0 && x < std::int64_t(1) << deepest;
        at[axis] = std::uint32_t(x);
      }
      if(!is_in)
        continue;
      std::uint32_t w = 0;
      while(!is_leaf(w) && voxels_[w].level < voxel.level)
        w = child_at(w, at);
      if(is_leaf(w) && (voxels_[w].level < voxel.level || w < v))
        visit(w);
    }
  }

  /// a place on both of two leaves that touch.
  Point common_place(std::uint32_t v, std::uint32_t w) const {
    std::array<double, 3> x;
    for(int axis = 0; axis < 3; ++axis) {
      const double low = (std::max)(voxels_[v].low[axis], voxels_[w].low[axis]);
      const double high = (std::min)(voxels_[v].low[axis] + units(voxels_[v]),
                                     voxels_[w].low[axis] + units(voxels_[w]));
      x[axis] = corner_[axis] + (low + high) / 2. * unit();
    }
    return {x[0], x[1], x[2]};
  }

private:
  static constexpr int deepest = 20;

  double unit() const { return std::ldexp(side_, -deepest); }
  double side(const Voxel& v) const { return std::ldexp(side_, -v.level); }
  static std::uint32_t units(const Voxel& v) { return std::uint32_t(1) << (deepest - v.level); }

  Point place(const Voxel& v, double x, double y, double z) const {
    const double u = unit(), n = units(v);
    return {corner_[0] + u * (v.low[0] + x * n), corner_[1] + u * (v.low[1] + y * n),
            corner_[2] + u * (v.low[2] + z * n)};
  }

  std::uint32_t child_at(std::uint32_t v, const std::array<std::uint32_t, 3>& at) const {
    const int bit = deepest - voxels_[v].level - 1;
    return voxels_[v].first_child + (at[0] >> bit & 1) + 2 * (at[1] >> bit & 1) +
           4 * (at[2] >> bit & 1);
  }

  void add(Voxel voxel, double most) {
    const auto nearest = surface_.nearest(place(voxel, 0.5, 0.5, 0.5));
    voxel.known = voxel.middle = nearest.distance;
    voxel.most = (std::min)(most, nearest.distance + std::sqrt(0.75) * side(voxel));
    voxels_.push_back(std::move(voxel));
  }

  const Triangle_tree::Nearest& nearest_to_corner(const Voxel& v, int c) {
    std::uint64_t key = 0;
    for(int axis = 0; axis < 3; ++axis)
      key = key << 21 | (v.low[axis] + (c >> axis & 1) * units(v));
    const auto [known, is_new] = corners_.try_emplace(key);
    if(is_new)
      known->second = surface_.nearest(place(v, c & 1, c >> 1 & 1, c >> 2 & 1));
    return known->second;
  }

  // The distance to the surface is at most the distance to each triangle, and so at most any mean
  // of such distances, which is convex: largest at a corner. The weights are chosen to make that
  // small: those triangles count more that are nearer to the corner where the mean is largest.
  void bound(std::uint32_t v) {
    Voxel& voxel = voxels_[v];
    if(voxel.is_bounded)
      return;
    voxel.is_bounded = true;
    std::vector<std::size_t> triangles = {surface_.nearest(middle(v)).triangle};
    for(int c = 0; c < 8; ++c) {
      const auto& nearest = nearest_to_corner(voxel, c);
      voxel.known = (std::max)(voxel.known, nearest.distance);
      triangles.push_back(nearest.triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<std::array<double, 8>> distances;
    for(const std::size_t t : triangles) {
      distances.emplace_back();
      for(int c = 0; c < 8; ++c)
        distances.back()[c] =
            distance(place(voxel, c & 1, c >> 1 & 1, c >> 2 & 1), surface_.triangles()[t]);
      voxel.most = (std::min)(voxel.most,
                              *std::max_element(distances.back().begin(), distances.back().end()));
    }
    std::array<double, 8> sum{};
    int corner = 0;
    for(int n = 1; n <= 60; ++n) {
      const auto& best =
          *std::min_element(distances.begin(), distances.end(),
                            [&](const auto& a, const auto& b) { return a[corner] < b[corner]; });
      for(int c = 0; c < 8; ++c)
        sum[c] += best[c];
      corner = int(std::max_element(sum.begin(), sum.end()) - sum.begin());
      voxel.most = (std::min)(voxel.most, sum[corner] / n);
    }
  }

  const Triangle_tree& surface_;
  const Loop_cones& cones_;
  double side_;
  std::array<double, 3> corner_;
  std::vector<Voxel> voxels_;
  std::unordered_map<std::uint64_t, Triangle_tree::Nearest> corners_;
};

} // namespace voxel_measures

#endif // BENCHMARK_VOXEL_TREE_H
