// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_FONT_DATA_H
#define HTL_PICTURE_FONT_DATA_H

namespace htl_picture {

/// a TrueType font, as the build found it.
extern const unsigned char font_data[];

} // namespace htl_picture

#endif // HTL_PICTURE_FONT_DATA_H
