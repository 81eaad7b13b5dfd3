// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_BASE64_H
#define HTL_WINDOW_BASE64_H

#include <string>
#include <string_view>

namespace htl_window {

/// bytes as letters, digits, + and / (RFC 4648).
std::string base64_of(std::string_view bytes);

} // namespace htl_window

#endif // HTL_WINDOW_BASE64_H
