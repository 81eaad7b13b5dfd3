// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_TEXTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_TEXTS_H

#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// the names and the texts of the files in shapes/.
const std::vector<std::pair<const char*, std::string_view>>& shape_texts();

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_TEXTS_H
