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

#include <boost/algorithm/string/predicate.hpp>

namespace htloops {

Soup read_soup(const Input_file& file) {
  const auto has_extension = [&file](const char* extension) {
    return boost::algorithm::iends_with(file.name(), extension);
  };
  if(has_extension(".off"))
    return read_off(file.name(), file.content());
  if(has_extension(".obj"))
    return read_obj(file.name(), std::string(file.content()));
  if(has_extension(".ply"))
    return read_ply(file.name(), file.content());
  if(has_extension(".stl"))
    return read_stl(file.name(), file.content());
  fail_to_read(file.name(),
               "its format, which follows from the extension, is not supported; those that are: "
               ".off .obj .ply .stl");
}

} // namespace htloops
