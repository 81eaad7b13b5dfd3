// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_JUDGED_REMOVAL_H
#define BENCHMARK_JUDGED_REMOVAL_H

#include "Removal_judge.h"

#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/remove_handles.h>

/// \file Judged_removal.h
/// Handles are removed from a copy of a mesh, and that is judged.

namespace judge {

using Options = CGAL::Handle_tunnel_loops::Removal_options;
using Method = CGAL::Handle_tunnel_loops::Removal_method;

class Judged_removal
{
public:
  using Tag = CGAL::Parallel_if_available_tag;

  Judged_removal(const Mesh& before, const Pairs& pairs, const Options& options)
      : before_(before)
      , pairs_(pairs)
      , after_(before)
      , owners_(after_.add_property_map<Mesh::Face_index, std::size_t>("f:owner", nobody).first) {
    const double start = seconds_now();
    report_ = CGAL::remove_handles<Tag>(
        after_, CGAL::parameters::removal_options(options, CGAL::parameters::known_loops(pairs))
                    .face_patch_map(owners_));
    seconds_ = seconds_now() - start;
  }

  const Mesh& after() const { return after_; }
  const Removal_judge::Owners& owners() const { return owners_; }
  const Report& report() const { return report_; }
  double seconds() const { return seconds_; }

  Removal_judge judge() const { return Removal_judge(before_, after_, owners_, report_, pairs_); }

private:
  const Mesh& before_;
  const Pairs& pairs_;
  Mesh after_;
  Removal_judge::Owners owners_;
  Report report_;
  double seconds_ = 0.;
};

} // namespace judge

#endif // BENCHMARK_JUDGED_REMOVAL_H
