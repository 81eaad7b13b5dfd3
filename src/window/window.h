// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_WINDOW_H
#define HTL_WINDOW_WINDOW_H

#include "scene/scene.h"

#include <string>

/// \file window.h
/// Pages of HTML in which triangle meshes with lines on them can be turned and looked through. They
/// need a browser with WebGL 2 and nothing else, no network either.

namespace htl_window {

using namespace htl_scene;

/*!
The text of a page. Coordinates are kept to 1 / 65535 of the extent of all that is shown along each
axis, so that a point that is on an edge in the scene is so on the page, but for rounding. About 4
to 8 bytes for each triangle; near linear in the size of the scene.
*/
std::string page_of(const Scene& scene);

} // namespace htl_window

#endif // HTL_WINDOW_WINDOW_H
