// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_WORDS_H
#define HTLOOPS_WORDS_H

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>

#include <cstddef>
#include <string>

namespace htloops {

/// a number with its noun: "1 edge", "3 edges".
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// how many loops bound where; empty if linking numbers were not computed.
inline std::string summary_of_sides(const CGAL::Handle_tunnel_loops::Certificate& certificate) {
  const std::size_t pairs = certificate.linking.size() / 2;
  if(pairs == 0)
    return "";
  return std::to_string(*certificate.handles_bound_inside) + " of " +
         counted(pairs, "handle loop bounds", "handle loops bound") + " inside, " +
         std::to_string(*certificate.tunnels_bound_outside) + " of " +
         counted(pairs, "tunnel loop", "tunnel loops") + " outside";
}

/// the word for the side on which a loop bounds.
inline const char* word_for_side(const CGAL::Handle_tunnel_loops::Loop_linking& linking) {
  return !linking.problem.empty()   ? "undecided"
         : linking.bounds_inside()  ? "inside"
         : linking.bounds_outside() ? "outside"
                                    : "neither";
}

} // namespace htloops

#endif // HTLOOPS_WORDS_H
