// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_SAMPLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_SAMPLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Places on a surface, the closer together the smaller the balls inside are that touch it there, and
the regions around them.

Pieces of the surface are looked at in rounds, few of them spread over all at first. Those that are
in no region yet become samples, the ones with large balls first; the region of a sample grows over
pieces that are in none, as far as a part of the radius.
*/
class Surface_samples
{
public:
  struct Sample
  {
    Index piece;
    Inner_ball ball;
  };

  /// \p least_extent is how far regions grow at least; but samples along \p paths, which are pieces
  /// one beside the other, follow each other more closely where balls are small.
  Surface_samples(Execution execution,
                  const Surface_pieces& pieces,
                  const Inner_balls& balls,
                  double least_extent,
                  const std::vector<std::vector<Index>>& paths)
      : pieces_(pieces)
      , balls_(balls)
      , least_extent_(least_extent)
      , region_(pieces.size()) {
    std::fill(region_.begin(), region_.end(), no_index);
    for(const std::vector<Index>& path : paths)
      follow(execution, path);
    for(Index s = 0; s < samples_.size(); ++s)
      grow(s);
    std::size_t stride = 1;
    while(stride * first_number < pieces.size())
      stride *= ratio_of_strides;
    for(; stride > 0; stride /= ratio_of_strides)
      take_every(execution, stride);
    share_out_rest();
  }

  const std::vector<Sample>& samples() const { return samples_; }
  Vector place(Index sample) const { return pieces_.centre(samples_[sample].piece); }
  Index region(Index piece) const { return region_[piece]; }

  /// pairs of samples of which the regions meet, the smaller number first, sorted.
  std::vector<std::pair<Index, Index>> neighbors(Execution execution) const {
    using Pair = std::pair<Index, Index>;
    std::vector<Pair> pairs =
        collect<Pair>(execution, pieces_.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Pair> own;
          for(Index p = static_cast<Index>(begin); p < end; ++p)
            pieces_.for_each_neighbor(p, [&](Index q) {
              const Pair pair(region_[p], region_[q]);
              if(pair.first < pair.second && pair.second != no_index &&
                 (own.empty() || own.back() != pair))
                own.push_back(pair);
            });
          return own;
        });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// the areas of the regions, by sample.
  std::vector<double> areas() const {
    std::vector<double> areas(samples_.size(), 0.);
    for(Index p = 0; p < pieces_.size(); ++p)
      if(region_[p] != no_index)
        areas[region_[p]] += pieces_.area(p);
    return areas;
  }

private:
  static constexpr std::size_t first_number = 256, ratio_of_strides = 4;
  static constexpr double part_of_radius = 0.6; // that a region extends

  std::vector<Sample> samples_at(Execution execution, const std::vector<Index>& pieces) const {
    std::vector<Sample> found(pieces.size());
    for_each_index(
        execution, pieces.size(),
        [&](std::size_t i) {
          found[i] = {pieces[i], balls_(pieces_.centre(pieces[i]), pieces_.face(pieces[i]))};
        },
        64);
    return found;
  }

  // Where regions would be larger than balls, what is not of a region yet becomes a sample, or is
  // of the region of the one before.
  void follow(Execution execution, const std::vector<Index>& path) {
    Index last = no_index;
    for(const Sample& sample : samples_at(execution, path)) {
      Index& region = region_[sample.piece];
      if(part_of_radius * sample.ball.radius > least_extent_) {
        last = no_index;
        continue;
      }
      if(region == no_index) {
        if(!(sample.ball.radius > 0.) && last == no_index)
          continue;
        if(last == no_index || (sample.ball.radius > 0. && is_apart(samples_[last], sample))) {
          region = static_cast<Index>(samples_.size());
          samples_.push_back(sample);
        } else
          region = last;
      }
      last = region;
    }
  }

  bool is_apart(const Sample& a, const Sample& b) const {
    return norm(pieces_.centre(a.piece) - pieces_.centre(b.piece)) >
           part_of_radius * (std::min)(a.ball.radius, b.ball.radius);
  }

  void take_every(Execution execution, std::size_t stride) {
    std::vector<Index> open;
    for(std::size_t p = stride / 2; p < pieces_.size(); p += stride)
      if(region_[p] == no_index)
        open.push_back(static_cast<Index>(p));
    std::vector<Sample> found = samples_at(execution, open);
    std::stable_sort(found.begin(), found.end(), [](const Sample& a, const Sample& b) {
      return a.ball.radius > b.ball.radius;
    });
    for(const Sample& sample : found)
      if(region_[sample.piece] == no_index && sample.ball.radius > 0.) {
        region_[sample.piece] = static_cast<Index>(samples_.size());
        samples_.push_back(sample);
        grow(region_[sample.piece]);
      }
  }

  // Pieces without an inner side are of the region of a neighbour.
  void share_out_rest() {
    std::vector<Index> rest;
    for(Index p = 0; p < pieces_.size(); ++p)
      if(region_[p] == no_index)
        rest.push_back(p);
    for(std::size_t before = rest.size() + 1; rest.size() < before;) {
      before = rest.size();
      rest.erase(std::remove_if(rest.begin(), rest.end(),
                                [this](Index p) {
                                  pieces_.for_each_neighbor(p, [&](Index q) {
                                    if(region_[p] == no_index)
                                      region_[p] = region_[q];
                                  });
                                  return region_[p] != no_index;
                                }),
                 rest.end());
    }
  }

  void grow(Index number) {
    const Sample& sample = samples_[number];
    const double extent = (std::max)(least_extent_, part_of_radius * sample.ball.radius);
    const Vector middle = pieces_.centre(sample.piece);
    reached_.assign(1, sample.piece);
    for(std::size_t i = 0; i < reached_.size(); ++i)
      pieces_.for_each_neighbor(reached_[i], [&](Index p) {
        if(region_[p] == no_index && norm(pieces_.centre(p) - middle) < extent) {
          region_[p] = number;
          reached_.push_back(p);
        }
      });
  }

  const Surface_pieces& pieces_;
  const Inner_balls& balls_;
  double least_extent_;
  std::vector<Sample> samples_;
  Uninitialized_vector<Index> region_; // by piece, the number of a sample
  std::vector<Index> reached_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_SAMPLES_H
