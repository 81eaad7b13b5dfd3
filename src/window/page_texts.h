// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_PAGE_TEXTS_H
#define HTL_WINDOW_PAGE_TEXTS_H

#include <string>
#include <string_view>
#include <vector>

namespace htl_window {

/// a text with what has a meaning in HTML replaced.
std::string html_of(std::string_view text);

// The files in page/ as they were when this was built; scripts in their order.
extern const std::string_view page_html, page_css;
extern const std::vector<std::string_view> page_scripts;

} // namespace htl_window

#endif // HTL_WINDOW_PAGE_TEXTS_H
