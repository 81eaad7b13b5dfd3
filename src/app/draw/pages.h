// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAGES_H
#define HTLOOPS_PAGES_H

#include "scene/scene.h"

#include <string>

namespace htloops {

/// writes a page in which a scene can be turned.
void write_page(const std::string& file, const htl_scene::Scene& scene);

} // namespace htloops

#endif // HTLOOPS_PAGES_H
