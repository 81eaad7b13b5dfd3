// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_SCENE_JSON_H
#define HTL_WINDOW_SCENE_JSON_H

#include "Grid.h"
#include "Streams.h"
#include "encode_surface.h"
#include "window.h"

#include <string>
#include <vector>

namespace htl_window {

/// what the scripts of a page are told of a scene, besides the streams.
std::string scene_json(const Scene& scene,
                       const Grid& grid,
                       const std::vector<Encoded_surface>& surfaces,
                       const Packed& lines);

} // namespace htl_window

#endif // HTL_WINDOW_SCENE_JSON_H
