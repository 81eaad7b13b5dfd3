// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_CHANGED_FACES_H
#define BENCHMARK_CHANGED_FACES_H

#include "Judged_faces.h"

#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

/// \file Changed_faces.h
/// Where two meshes differ.

namespace judge {

/// A number for each position, the same in several meshes, by the bits of the coordinates.
class Position_numbers
{
public:
  std::size_t operator()(const Point& p) {
    // adding 0. leaves one zero only
    return numbers_.emplace(Key{p.x() + 0., p.y() + 0., p.z() + 0.}, numbers_.size()).first->second;
  }

private:
  using Key = std::array<double, 3>;

  struct Hash
  {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for(const double x : key) {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof(bits));
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
      }
      return std::size_t(hash);
    }
  };

  std::unordered_map<Key, std::size_t, Hash> numbers_;
};

/// The faces of one mesh that are none of the other, by the positions of their corners. Those that
/// hang together by edges, old or new, are a group: the new faces of a group and its old ones
/// turned round are a surface without boundary, around what was taken away there and what was put
/// in.
class Changed_faces
{
public:
  struct Group
  {
    std::vector<Mesh::Face_index> old_faces, new_faces;
  };

  Changed_faces(const Mesh& before, const Mesh& after) {
    Position_numbers numbers;
    const std::vector<Numbered> a = numbered(before, numbers), b = numbered(after, numbers);
    std::vector<Numbered> out, in;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out), is_less);
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(in), is_less);
    add_groups(out, in);
  }

  const std::vector<Group>& groups() const { return groups_; }

  /// of all groups.
  std::vector<Mesh::Face_index> new_faces() const {
    std::vector<Mesh::Face_index> faces;
    for(const Group& group : groups_)
      faces.insert(faces.end(), group.new_faces.begin(), group.new_faces.end());
    return faces;
  }

private:
  using Corners = std::array<std::size_t, 3>;
  using Numbered = std::pair<Corners, Mesh::Face_index>;

  static bool is_less(const Numbered& a, const Numbered& b) { return a.first < b.first; }

  // The faces by the numbers of their corners, the least first, and sorted.
  static std::vector<Numbered> numbered(const Mesh& mesh, Position_numbers& numbers) {
    std::vector<Numbered> faces;
    for(const Mesh::Face_index f : mesh.faces()) {
      const Triangle t = triangle_of(mesh, f);
      Corners corners = {numbers(t[0]), numbers(t[1]), numbers(t[2])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      faces.emplace_back(corners, f);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  std::size_t root(std::size_t i) {
    while(parents_[i] != i)
      i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  void join_at_edges(const Corners& corners,
                     std::size_t face,
                     std::map<std::pair<std::size_t, std::size_t>, std::size_t>& faces) {
    for(std::size_t i = 0; i < 3; ++i) {
      const auto edge = std::minmax(corners[i], corners[(i + 1) % 3]);
      const std::size_t other = faces.emplace(edge, face).first->second;
      parents_[root(face)] = root(other);
    }
  }

  void add_groups(const std::vector<Numbered>& out, const std::vector<Numbered>& in) {
    parents_.resize(out.size() + in.size());
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> faces;
    for(std::size_t i = 0; i < parents_.size(); ++i)
      join_at_edges(i < out.size() ? out[i].first : in[i - out.size()].first, i, faces);
    std::map<std::size_t, std::size_t> places;
    for(std::size_t i = 0; i < parents_.size(); ++i) {
      const std::size_t place = places.emplace(root(i), places.size()).first->second;
      groups_.resize(places.size());
      if(i < out.size())
        groups_[place].old_faces.push_back(out[i].second);
      else
        groups_[place].new_faces.push_back(in[i - out.size()].second);
    }
  }

  std::vector<Group> groups_;
  std::vector<std::size_t> parents_;
};

/// the volume that a group has added where faces point outwards.
inline double net_volume(const Mesh& before, const Mesh& after, const Changed_faces::Group& group) {
  double sum = 0.;
  const Point origin =
      triangle_of(group.new_faces.empty() ? before : after,
                  group.new_faces.empty() ? group.old_faces.front() : group.new_faces.front())[0];
  for(const Mesh::Face_index f : group.new_faces)
    sum += six_volumes(triangle_of(after, f), origin);
  for(const Mesh::Face_index f : group.old_faces)
    sum -= six_volumes(triangle_of(before, f), origin);
  return sum / 6.;
}

} // namespace judge

#endif // BENCHMARK_CHANGED_FACES_H
