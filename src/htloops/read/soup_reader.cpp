// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup_reader.h"

#include "read/obj_reader.h"
#include "read/off_reader.h"
#include "read/ply_reader.h"
#include "read/stl_reader.h"

namespace htloops {

Soup read_soup(const Input_file& file) {
  if(file.is_of_format(".off"))
    return read_off(file.name(), file.content());
  if(file.is_of_format(".obj"))
    return read_obj(file.name(), std::string(file.content()));
  if(file.is_of_format(".ply"))
    return read_ply(file.name(), file.content());
  if(file.is_of_format(".stl"))
    return read_stl(file.name(), file.content());
  fail_to_read(file.name(),
               "its format, which follows from the extension, is not supported; those that are: "
               ".off .obj .ply .stl (--format says which one it is whatever its name)");
}

} // namespace htloops
