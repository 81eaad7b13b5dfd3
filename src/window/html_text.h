// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_HTML_TEXT_H
#define HTL_WINDOW_HTML_TEXT_H

#include <string>
#include <string_view>

namespace htl_window {

/// a text with what has a meaning in HTML replaced.
std::string html_of(std::string_view text);

} // namespace htl_window

#endif // HTL_WINDOW_HTML_TEXT_H
