// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_DEFLATE_H
#define HTL_WINDOW_DEFLATE_H

#include <string>
#include <string_view>

namespace htl_window {

/// bytes as a stream of RFC 1951, which browsers read as "deflate-raw". Fast rather than small:
/// what is coded here has been made of small numbers already, which are short words.
std::string deflated(std::string_view bytes);

} // namespace htl_window

#endif // HTL_WINDOW_DEFLATE_H
