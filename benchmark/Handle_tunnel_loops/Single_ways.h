// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SINGLE_WAYS_H
#define BENCHMARK_SINGLE_WAYS_H

#include "Judged_removal.h"
#include "Removal_targets.h"

/// \file Single_ways.h
/// Whether the way that is taken by default is the one that changes the shape least.

namespace judge {

/// What becomes of a handle if it alone is removed: by default, cut, and filled.
class Single_ways
{
public:
  /// \p surface tells distances from the mesh.
  Single_ways(const Mesh& mesh,
              const CGAL::Handle_tunnel_pair<Mesh>& pair,
              const Surface_distance& surface,
              double tolerance)
      : mesh_(mesh)
      , pairs_({pair}) {
    const Judged_removal removal(mesh_, pairs_, options(Method::SMALLEST_CHANGE));
    by_default_ = change(removal);
    cut_ = change(Judged_removal(mesh_, pairs_, options(Method::CUT)));
    fill_ = change(Judged_removal(mesh_, pairs_, options(Method::FILL)));
    if(by_default_ >= 0.)
      way_ = removal.report().removed.front().by;
    if(by_default_ >= 0. && way_ == Way::FILL)
      look_at_caps(removal, surface, tolerance);
  }

  /// Nothing is to be compared where no single way could be.
  bool is_comparable() const { return cut_ >= 0. || fill_ >= 0.; }

  /// of the change of volume by default over that by the better single way.
  double ratio() const {
    if(!is_comparable() || by_default_ == best())
      return 1.;
    return by_default_ < 0. || best() == 0. ? 1e9 : by_default_ / best();
  }

  bool is_flush_fill() const { return is_flush_fill_; }

  bool is_nearly_flush_fill() const { return is_nearly_flush_fill_; }

  /// the changes of volume in words.
  std::string text() const {
    return " (default " + text(by_default_) + (way_ == Way::WHOLE ? " whole" : "") +
           (is_flush_fill_          ? " flush"
            : is_nearly_flush_fill_ ? " nearly flush"
                                    : "") +
           ", cut " + text(cut_) + ", fill " + text(fill_) + ")";
  }

private:
  static constexpr double refused = -1.;

  static Options options(Method method) {
    Options options;
    options.method = method;
    return options;
  }

  static std::string text(double change) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", change);
    return change == refused ? "refused" : text;
  }

  // Of what is the same in both meshes, volumes would only bring in their errors.
  double change(const Judged_removal& removal) const {
    if(removal.report().removed.empty())
      return refused;
    double sum = 0.;
    const Changed_faces changed(mesh_, removal.after());
    for(const Changed_faces::Group& group : changed.groups())
      sum += net_volume(mesh_, removal.after(), group);
    return std::abs(sum);
  }

  void
  look_at_caps(const Judged_removal& removal, const Surface_distance& surface, double tolerance) {
    const Changed_faces changed(mesh_, removal.after());
    const New_caps caps(removal.after(), changed.new_faces(), removal.owners(), surface, tolerance);
    const auto& all = caps.caps();
    is_flush_fill_ = !all.empty() && std::all_of(all.begin(), all.end(),
                                                 [](const Cap& cap) { return cap.is_flush(); });
    is_nearly_flush_fill_ = !all.empty() && std::all_of(all.begin(), all.end(), [](const Cap& cap) {
      return cap.is_flush() || cap.is_nearly_flush();
    });
  }

  double best() const { return cut_ < 0. ? fill_ : fill_ < 0. ? cut_ : (std::min)(cut_, fill_); }

  const Mesh& mesh_;
  const Pairs pairs_;
  double by_default_ = refused, cut_ = refused, fill_ = refused;
  Way way_ = Way::CUT; // by default
  bool is_flush_fill_ = false, is_nearly_flush_fill_ = false;
};

/// compares the ways for the first handles of a mesh.
inline void compare_ways(const std::string& name,
                         const Mesh& mesh,
                         const Pairs& pairs,
                         Removal_targets& targets,
                         std::size_t most = 12) {
  const double size = diagonal_of(mesh);
  const Surface_distance surface(mesh, 1e-12 * size);
  for(std::size_t i = 0; i < (std::min)(most, pairs.size()); ++i) {
    const Single_ways ways(mesh, pairs[i], surface, 1e-9 * size);
    if(ways.is_comparable())
      targets.add_ratio(name + " pair " + std::to_string(i) + ways.text(), ways.ratio(),
                        ways.is_flush_fill(), ways.is_nearly_flush_fill());
  }
}

} // namespace judge

#endif // BENCHMARK_SINGLE_WAYS_H
