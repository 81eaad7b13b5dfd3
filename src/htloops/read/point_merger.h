// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POINT_MERGER_H
#define HTLOOPS_POINT_MERGER_H

#include "mesh_types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace htloops {

/// Numbers different points as they come.
class Point_merger
{
public:
  /// the number of a point, which is `next` if it has not come yet.
  std::uint32_t number(const Point& point, std::uint32_t next) {
    return numbers_.emplace(bits_of(point), next).first->second;
  }

private:
  // Also what is not a number is equal to itself this way.
  using Bits = std::array<std::uint64_t, 3>;

  struct Hash
  {
    std::size_t operator()(const Bits& bits) const;
  };

  static Bits bits_of(const Point& point);

  std::unordered_map<Bits, std::uint32_t, Hash> numbers_;
};

} // namespace htloops

#endif // HTLOOPS_POINT_MERGER_H
