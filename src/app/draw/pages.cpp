// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/pages.h"

#include "window/window.h"
#include "write/files.h"

namespace htloops {

// The page is made before its file is begun: while a file is unfinished, an interrupt has to wait.
void write_page(const std::string& file, const htl_scene::Scene& scene) {
  write_text(file, htl_window::page_of(scene));
}

} // namespace htloops
