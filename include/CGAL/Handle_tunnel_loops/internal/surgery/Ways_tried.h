// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WAYS_TRIED_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WAYS_TRIED_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_choice.h>

#include <CGAL/assertions.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// How often each kind of region has done on a surface, and how often it has not. What hardly ever
/// does there, as on a surface that crosses itself all over, is given up for all handles that are
/// left, but for strips, which say why. Failures are noted by any thread; what is given up changes
/// between rounds only.
class Ways_tried
{
public:
  void note_failure(const Region_choice& choice) {
    counts_[number(choice)].failures.fetch_add(1, std::memory_order_relaxed);
  }

  void note_success(const Region_choice& choice) { ++counts_[number(choice)].successes; }

  /// to be called between rounds.
  void give_up_what_is_in_vain() {
    constexpr std::size_t most_failures = 64; // for each success, and before the first one
    for(Count& count : counts_)
      count.is_given_up = count.failures >= most_failures * (1 + count.successes);
  }

  bool is_given_up(const Region_choice& choice) const {
    const bool tells_why = choice.style == Region_choice::STRIP && !choice.may_cross;
    return !tells_why && counts_[number(choice)].is_given_up;
  }

private:
  struct Count
  {
    std::atomic<std::size_t> failures{0};
    std::size_t successes = 0;
    bool is_given_up = false;
  };

  static constexpr std::size_t number_of_styles = Region_choice::WHOLE + 1, number_of_rings = 16;

  static std::size_t number(const Region_choice& choice) {
    const auto rings = static_cast<std::size_t>(choice.rings);
    CGAL_precondition(rings < number_of_rings);
    return 2 * (static_cast<std::size_t>(choice.style) * number_of_rings + rings) +
           (choice.may_cross ? 1 : 0);
  }

  std::array<Count, 2 * number_of_styles * number_of_rings> counts_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WAYS_TRIED_H
