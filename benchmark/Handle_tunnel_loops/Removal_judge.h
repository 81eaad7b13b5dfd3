// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_REMOVAL_JUDGE_H
#define BENCHMARK_REMOVAL_JUDGE_H

#include "Group_handles.h"
#include "Line_volumes.h"
#include "New_folds.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

/// \file Removal_judge.h
/// How each handle was removed, measured on the meshes before and after. Of a report only that is
/// believed which handles were removed, in which way, and along loops of which lengths.

namespace judge {

struct Verdict
{
  std::size_t pair = 0;
  Way way = Way::CUT;
  double length = 0.;       ///< of the loop that it was removed along
  double longest = 0.;      ///< ... or of the longer one, if it was taken out whole
  double net = 0.;          ///< volume added, negative if solid was taken
  Volumes gross;            ///< where both happened
  double circles = 0.;      ///< of the largest cap, see Cap
  double fold = 0.;         ///< the largest that is new and above 120 degrees
  double displacement = 0.; ///< of the surface
  bool is_mixed = false;    ///< whether handles were removed in other ways in one group with it
  bool is_flush = true;     ///< whether all caps are flush
  std::size_t number_of_caps = 0;

  bool is_flush_fill() const { return way == Way::FILL && is_flush && number_of_caps > 0; }

  /// what a fill has taken, or a cut added, in sum.
  double wrong_net() const {
    return way == Way::WHOLE ? 0. : (std::max)(0., way == Way::FILL ? -net : net);
  }

  /// the same wherever it did so.
  double wrong_gross() const {
    return way == Way::WHOLE ? 0. : way == Way::FILL ? gross.taken : gross.added;
  }
};

class Removal_judge
{
public:
  using Owners = New_caps::Owners;

  /// \p owners says of new faces for which of the removed handles they were made.
  Removal_judge(const Mesh& before,
                const Mesh& after,
                const Owners& owners,
                const Report& report,
                const Pairs& pairs)
      : before_(before)
      , after_(after)
      , owners_(owners)
      , volume_(CGAL::Polygon_mesh_processing::volume(before))
      , size_(diagonal_of(before)) {
    for(const auto& handle : report.removed)
      verdicts_.push_back(first_verdict(handle, pairs));
    const Changed_faces changed(before, after);
    const Group_handles handles(before, changed, owners, report, pairs);
    for(std::size_t i = 0; i < changed.groups().size(); ++i)
      judge_volumes(changed.groups()[i], handles[i]);
    if(!changed.groups().empty())
      judge_surface(changed);
  }

  const std::vector<Verdict>& verdicts() const { return verdicts_; }

  /// of the mesh before.
  double volume() const { return std::abs(volume_); }

  /// of groups where no handle was removed, or where it is not clear which.
  double unclear_volume() const { return unclear_; }

  /// of the sums along lines, beside the groups' exact volumes.
  double largest_error_of_lines() const { return error_of_lines_; }

private:
  std::size_t owner(Mesh::Face_index f) const {
    return owners_[f] < verdicts_.size() ? owners_[f] : nobody;
  }

  static Verdict first_verdict(const CGAL::Handle_tunnel_loops::Removed_handle& handle,
                               const Pairs& pairs) {
    Verdict verdict;
    verdict.pair = handle.pair;
    verdict.way = handle.by;
    verdict.length = verdict.longest = handle.length;
    if(handle.by == Way::WHOLE && handle.pair < pairs.size())
      verdict.longest = (std::max)({handle.length, pairs[handle.pair].handle().length(),
                                    pairs[handle.pair].tunnel().length()});
    return verdict;
  }

  Triangle outward(Triangle t) const {
    if(volume_ < 0.)
      std::swap(t[0], t[1]);
    return t;
  }

  std::vector<Sheet> sheets_of(const Changed_faces::Group& group) const {
    std::vector<Sheet> sheets;
    for(const Mesh::Face_index f : group.old_faces)
      sheets.push_back({outward(triangle_of(before_, f)), false, nobody});
    for(const Mesh::Face_index f : group.new_faces)
      sheets.push_back({outward(triangle_of(after_, f)), true, owner(f)});
    return sheets;
  }

  void judge_volumes(const Changed_faces::Group& group, const Handles_of_group& handles) {
    const std::set<std::size_t>& owners = handles.owners;
    const double net = net_volume(before_, after_, group) * (volume_ < 0. ? -1. : 1.);
    if(owners.empty()) {
      unclear_ += std::abs(net);
      return;
    }
    for(const std::size_t i : owners) {
      verdicts_[i].is_mixed = verdicts_[i].is_mixed || handles.is_mixed;
      if(verdicts_[i].way == Way::WHOLE)
        for(const std::size_t j : handles.hidden) // may have been taken out with it
          verdicts_[i].longest = (std::max)(verdicts_[i].longest, verdicts_[j].longest);
    }
    const std::vector<Sheet> sheets = sheets_of(group);
    double by_lines = 0.;
    const Line_volumes lines(sheets, 1e-10 * size_);
    for(const auto& [i, volumes] : lines.volumes()) {
      add_volumes(i, volumes, handles);
      by_lines += volumes.added - volumes.taken;
    }
    if(owners.size() == 1)
      verdicts_[*owners.begin()].net += net;
    error_of_lines_ = (std::max)(error_of_lines_, std::abs(by_lines - net));
  }

  // What ends at old faces only is of the handle of its group, if it does not matter of which.
  void add_volumes(std::size_t i, const Volumes& volumes, const Handles_of_group& handles) {
    if(i == nobody && handles.is_mixed) {
      unclear_ += volumes.added + volumes.taken;
      return;
    }
    Verdict& verdict = verdicts_[i != nobody ? i : *handles.owners.begin()];
    verdict.gross.added += volumes.added;
    verdict.gross.taken += volumes.taken;
    if(handles.owners.size() > 1)
      verdict.net += volumes.added - volumes.taken;
  }

  void judge_surface(const Changed_faces& changed) {
    const std::vector<Mesh::Face_index> new_faces = changed.new_faces();
    const Surface_distance old_surface(before_, 1e-12 * size_), new_surface(after_, 1e-12 * size_);
    const New_caps caps(after_, new_faces, owners_, old_surface, 1e-9 * size_);
    for(const Cap& cap : caps.caps())
      if(cap.owner < verdicts_.size())
        judge_cap(cap, old_surface);
    judge_folds(new_faces);
    for(const Changed_faces::Group& group : changed.groups())
      judge_what_went(group, new_surface);
  }

  void judge_cap(const Cap& cap, const Surface_distance& old_surface) {
    Verdict& verdict = verdicts_[cap.owner];
    ++verdict.number_of_caps;
    verdict.is_flush = verdict.is_flush && cap.is_flush();
    verdict.circles = (std::max)(verdict.circles, cap.circles());
    if(verdict.way != Way::FILL || !cap.is_flush())
      for(const Mesh::Face_index f : cap.faces)
        displace(verdict, old_surface.most(triangle_of(after_, f), verdict.length / 20.));
  }

  static void displace(Verdict& verdict, double distance) {
    verdict.displacement = (std::max)(verdict.displacement, distance);
  }

  void judge_folds(const std::vector<Mesh::Face_index>& new_faces) {
    const Old_folds old_folds(before_, size_);
    for(const Mesh::Face_index f : new_faces)
      for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(after_.halfedge(f), after_))
        if(owner(f) != nobody) {
          double& fold = verdicts_[owner(f)].fold;
          fold = (std::max)(fold, old_folds.new_fold(after_, after_.edge(h)));
        }
  }

  // Walls that are buried in the solid have not moved anywhere; what else is gone must not be far.
  void judge_what_went(const Changed_faces::Group& group, const Surface_distance& new_surface) {
    std::vector<Mesh::Face_index> faces; // of cuts, and what was taken out whole
    for(const Mesh::Face_index f : group.new_faces)
      if(owner(f) != nobody && verdicts_[owner(f)].way != Way::FILL)
        faces.push_back(f);
    const Surface_distance theirs(after_, faces, 1e-12 * size_);
    if(theirs.is_empty())
      return;
    for(const Mesh::Face_index f : group.old_faces) {
      const Triangle t = triangle_of(before_, f);
      Verdict& verdict = verdicts_[owner(theirs.nearest_face(CGAL::centroid(t[0], t[1], t[2])))];
      for(const Point& p : samples_of(t, verdict.length / 20.))
        displace(verdict, how_far_outside(p, new_surface, verdict.displacement));
    }
  }

  // 0 if it is not further than what is known.
  static double how_far_outside(const Point& p, const Surface_distance& surface, double known) {
    const double distance = surface(p);
    return distance > known && !surface.is_inside(p) ? distance : 0.;
  }

  const Mesh &before_, &after_;
  const Owners owners_;
  const double volume_, size_;
  std::vector<Verdict> verdicts_;
  double unclear_ = 0., error_of_lines_ = 0.;
};

} // namespace judge

#endif // BENCHMARK_REMOVAL_JUDGE_H
