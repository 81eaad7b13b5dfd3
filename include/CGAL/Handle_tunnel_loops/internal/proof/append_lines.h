// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_APPEND_LINES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_APPEND_LINES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

inline void append_line(std::string& text, const std::string& line) {
  text += (text.empty() ? "" : "\n") + line;
}

/// not all, if there are many of a kind.
inline void
append_lines(std::string& text, const std::vector<std::string>& lines, const std::string& kind) {
  constexpr std::size_t most = 10;
  for(std::size_t i = 0; i < lines.size() && i < most; ++i)
    append_line(text, lines[i]);
  if(lines.size() > most)
    append_line(text, "... and " + std::to_string(lines.size() - most) + " more " + kind);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_APPEND_LINES_H
