// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <boost/pending/disjoint_sets.hpp>

#include <unordered_map>
#include <utility>

namespace htloops {
namespace {

// One of the two orientations that three vertices can have.
bool is_even(const Soup_face& face) {
  const int descents = int(face[0] > face[1]) + int(face[1] > face[2]) + int(face[2] > face[0]);
  return descents == 1;
}

// Faces with the same vertices, at least two.
struct Group
{
  std::vector<std::uint32_t> faces; // sorted
  bool cancels = false;             // as many of one orientation as of the other
};

std::vector<Group> find_groups(const Soup& soup, const Edge_table& edges) {
  const std::vector<Corners_of_face> suspects = suspicious_faces(soup, edges);
  std::vector<Group> groups;
  for(auto next = suspects.begin(); next != suspects.end();) {
    Group group;
    std::size_t number_even = 0;
    for(const auto& corners = next->first; next != suspects.end() && next->first == corners; ++next)
    {
      group.faces.push_back(next->second);
      number_even += is_even(soup.faces[next->second]) ? 1 : 0;
    }
    group.cancels = 2 * number_even == group.faces.size();
    if(group.faces.size() > 1)
      groups.push_back(std::move(group));
  }
  return groups;
}

// Groups that cancel and have an edge in common, and what is fixed to them.
class Flaps
{
public:
  Flaps(const std::vector<Group>& groups, const Edge_table& edges)
      : groups_(groups) {
    for(std::uint32_t i = 0; i < groups.size(); ++i)
      for(const std::uint32_t f : groups[i].faces)
        group_of_face_[f] = i;
    edges.for_each_edge([&](const Edge_table::Edge& edge) { look_at(edge); });
    for(const auto& [group, vote] : votes_of_groups_)
      votes_[joined_.find_set(group)] += vote;
  }

  bool contain(std::uint32_t group) {
    return groups_[group].cancels && votes_[joined_.find_set(group)] > 0;
  }

private:
  // An even number of other faces says that there is no need for the flap, an odd one that there
  // is.
  void look_at(const Edge_table::Edge& edge) {
    if(edge.size() < 3)
      return;
    std::vector<std::uint32_t> cancelling, others; // each group once
    std::size_t number_of_others = 0;
    for(std::size_t i = 0; i < edge.size(); ++i) {
      const auto found = group_of_face_.find(edge.halfedge(i) / 3);
      if(found == group_of_face_.end())
        ++number_of_others;
      else
        (groups_[found->second].cancels ? cancelling : others).push_back(found->second);
    }
    if(cancelling.empty())
      return;
    for(const std::uint32_t group : cancelling)
      joined_.union_set(cancelling.front(), group);
    std::sort(others.begin(), others.end());
    number_of_others +=
        static_cast<std::size_t>(std::unique(others.begin(), others.end()) - others.begin());
    if(number_of_others != 0)
      votes_of_groups_.emplace_back(cancelling.front(), number_of_others % 2 == 0 ? 1 : -1);
  }

  const std::vector<Group>& groups_;
  boost::disjoint_sets_with_storage<> joined_{groups_.size()};
  std::unordered_map<std::uint32_t, std::uint32_t> group_of_face_;
  std::vector<std::pair<std::uint32_t, int>> votes_of_groups_;
  // Of the groups that stand for joined ones.
  std::vector<long long> votes_ = std::vector<long long>(groups_.size());
};

bool repeats_corner(const Corners& corners) {
  bool is_repeated = corners.size() < 3;
  for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) { is_repeated |= u == v; });
  return is_repeated;
}

bool is_degenerate(const Soup_face& face) {
  return face.size() < 3 || face[0] == face[1] || face[1] == face[2] ||
         (face.size() == 3 && face[2] == face[0]);
}

// Most soups have no such face, and need not be copied.
bool has_degenerate_faces(const Soup& soup) {
  if(soup.further_corners.empty())
    return std::any_of(soup.faces.begin(), soup.faces.end(), is_degenerate);
  bool has_any = false;
  for_each_polygon(
      soup, [&](std::size_t, const Corners& corners) { has_any |= repeats_corner(corners); });
  return has_any;
}

// What becomes of triangles with the same three vertices as another one, where edges have too many
// faces or faces that run the same way. All but the first of their kind are duplicates.
//
// A flap is a piece of a surface folded onto itself: each of its faces is there once in each
// orientation, and where it is fixed to others the surface is closed without it. So it is not
// needed at all, and leaving one side of it would leave a boundary.
enum class Fate : char { STAYS, IS_DUPLICATE, IS_OF_FLAP };

// By face; nothing if all stay.
std::vector<Fate> fates_of_faces(const Soup& soup) {
  const Edge_table edges(soup);
  const std::vector<Group> groups = find_groups(soup, edges);
  if(groups.empty())
    return {};
  std::vector<Fate> fates(soup.faces.size(), Fate::STAYS);
  Flaps flaps(groups, edges);
  for(std::uint32_t i = 0; i < groups.size(); ++i) {
    const bool is_flap = flaps.contain(i);
    for(std::size_t k = is_flap ? 0 : 1; k < groups[i].faces.size(); ++k)
      fates[groups[i].faces[k]] = is_flap ? Fate::IS_OF_FLAP : Fate::IS_DUPLICATE;
  }
  return fates;
}

} // namespace

void drop_degenerate_faces(Mended_soup& mended) {
  if(!has_degenerate_faces(mended.soup))
    return;
  replace_faces(mended, [&](std::size_t f, const Corners& corners, Soup& kept) {
    const Corners rest = without_repetitions(corners);
    if(rest.size() < 3 || rest.size() < corners.size())
      mended.log.add_face(rest.size() < 3 ? Change_kind::DEGENERATE_FACES_DROPPED
                                          : Change_kind::CORNERS_DROPPED,
                          mended.face_in_file[f]);
    if(rest.size() >= 3)
      add_face(kept, rest);
  });
}

void drop_duplicate_faces(Mended_soup& mended) {
  const std::vector<Fate> fates = fates_of_faces(mended.soup);
  if(fates.empty())
    return;
  std::size_t kept = 0;
  for(std::uint32_t f = 0; f < mended.soup.faces.size(); ++f)
    if(fates[f] == Fate::STAYS) {
      mended.soup.faces[kept] = mended.soup.faces[f];
      mended.face_in_file[kept++] = mended.face_in_file[f];
    } else
      mended.log.add_face(fates[f] == Fate::IS_DUPLICATE ? Change_kind::DUPLICATE_FACES_DROPPED
                                                         : Change_kind::FLAPS_DROPPED,
                          mended.face_in_file[f]);
  mended.soup.faces.resize(kept);
  mended.face_in_file.resize(kept);
}

} // namespace htloops
