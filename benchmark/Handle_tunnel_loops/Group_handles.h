// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_GROUP_HANDLES_H
#define BENCHMARK_GROUP_HANDLES_H

#include "Changed_faces.h"
#include "New_caps.h"

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <set>

/// \file Group_handles.h
/// Which handles were removed where a mesh has changed.

namespace judge {

using Way = CGAL::Handle_tunnel_loops::Removal_way;
using Report = CGAL::Handle_tunnel_loops::Removal_report;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

/// The handles of one group of changed faces, by their positions among those that were removed.
struct Handles_of_group
{
  std::set<std::size_t> owners; ///< new faces were made for them
  std::set<std::size_t> hidden; ///< no new faces are left: others took their place, or others were
                                ///< removed together with them
  bool is_mixed = false;        ///< whether in several ways
};

/// Handles are where their new faces are, or, without any, where their loops were.
class Group_handles
{
public:
  Group_handles(const Mesh& before,
                const Changed_faces& changed,
                const New_caps::Owners& owners,
                const Report& report,
                const Pairs& pairs)
      : groups_(changed.groups().size()) {
    std::set<std::size_t> seen;
    std::map<Mesh::Face_index, std::size_t> group_of;
    for(std::size_t i = 0; i < groups_.size(); ++i) {
      for(const Mesh::Face_index f : changed.groups()[i].new_faces)
        if(owners[f] < report.removed.size())
          groups_[i].owners.insert(owners[f]);
      seen.insert(groups_[i].owners.begin(), groups_[i].owners.end());
      for(const Mesh::Face_index f : changed.groups()[i].old_faces)
        group_of[f] = i;
    }
    for(std::size_t i = 0; i < report.removed.size(); ++i)
      if(seen.count(i) == 0 && report.removed[i].pair < pairs.size())
        add_hidden(before, i, pairs[report.removed[i].pair], group_of);
    for(Handles_of_group& group : groups_)
      group.is_mixed = number_of_ways(group, report) > 1;
  }

  const Handles_of_group& operator[](std::size_t group) const { return groups_[group]; }

private:
  void add_hidden(const Mesh& before,
                  std::size_t handle,
                  const CGAL::Handle_tunnel_pair<Mesh>& pair,
                  const std::map<Mesh::Face_index, std::size_t>& group_of) {
    for(const auto* loop : {&pair.handle(), &pair.tunnel()})
      for(const auto& step : loop->steps())
        for(const Mesh::Halfedge_index h : {step.halfedge, before.opposite(step.halfedge)}) {
          const auto place = group_of.find(before.face(h));
          if(place != group_of.end())
            groups_[place->second].hidden.insert(handle);
        }
  }

  static std::size_t number_of_ways(const Handles_of_group& group, const Report& report) {
    std::set<Way> ways;
    for(const std::set<std::size_t>* handles : {&group.owners, &group.hidden})
      for(const std::size_t i : *handles)
        ways.insert(report.removed[i].by);
    return ways.size();
  }

  std::vector<Handles_of_group> groups_;
};

} // namespace judge

#endif // BENCHMARK_GROUP_HANDLES_H
