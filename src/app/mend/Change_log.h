// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANGE_LOG_H
#define HTLOOPS_CHANGE_LOG_H

#include "read/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// What can be different in a mesh that was mended, in the order in which it is told.
enum class Change_kind : char {
  NEAR_VERTICES_WELDED,
  VERTICES_WELDED,
  DEGENERATE_FACES_DROPPED,
  CORNERS_DROPPED,
  FACES_TRIANGULATED,
  DUPLICATE_FACES_DROPPED,
  FLAPS_DROPPED,
  ONE_SIDED_COMPONENT_DROPPED,
  PILLOW_FACES_DROPPED,
  EDGES_SPLIT,
  FACES_TURNED,
  VERTICES_SPLIT,
  EDGES_DIVIDED,
  BOUNDARY_EDGES_CLOSED,
  BOUNDARY_EDGES_OPENED
};

/// One kind of change, in words that follow the count.
struct Change
{
  Change_kind kind;
  std::size_t count;
  std::string words;
};

/// What has been done to a mesh, gathered step by step.
class Change_log
{
public:
  static constexpr std::size_t number_of_kinds = 15;

  /// counts one more; `name()` says what of the file it is.
  template <typename Name_of_element> void add(Change_kind kind, Name_of_element name) {
    findings_[index(kind)].add(name);
  }

  /// counts a face of the file, which may come in parts: one after the other they count once.
  void add_face(Change_kind kind, std::uint32_t face_in_file) {
    std::size_t& last = last_face_[index(kind)];
    if(last != face_in_file + std::size_t(1))
      add(kind, [face_in_file] { return name_of_face(face_in_file); });
    last = face_in_file + std::size_t(1);
  }

  /// adds a change that has words of its own.
  void add(Change_kind kind, std::size_t count, std::string words) {
    remarks_.push_back({kind, count, std::move(words)});
  }

  bool has_any() const;

  /// all changes, by kinds.
  std::vector<Change> changes() const;

private:
  static std::size_t index(Change_kind kind) { return static_cast<std::size_t>(kind); }

  std::array<Finding, number_of_kinds> findings_;
  std::array<std::size_t, number_of_kinds> last_face_{}; // one more than its number
  std::vector<Change> remarks_;
};

} // namespace htloops

#endif // HTLOOPS_CHANGE_LOG_H
