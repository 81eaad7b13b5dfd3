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

#include <cstddef>
#include <string>

namespace htloops {

/// a number with its noun: "1 edge", "3 edges".
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace htloops

#endif // HTLOOPS_WORDS_H
