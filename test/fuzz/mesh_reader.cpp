// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// A file of a mesh: read, mended, and made a mesh. All that may happen is that it is refused.

#include "fuzz_target.h"

#include "failure.h"
#include "mend/mending.h"
#include "mend/mesh_reader.h"
#include "read/input_file.h"
#include "read/soup.h"
#include "read/soup_diagnosis.h"
#include "solve/changeable_mesh.h"

namespace {

using namespace htloops;

void build_if_sound(const Soup& soup) {
  const Built_mesh built = build_mesh(soup);
  require(built.defects.size() == diagnose(soup).size(), "what is built is sound");
  if(built.defects.empty())
    require(Changeable_copy(built.mesh).mesh.is_valid(), "a sound soup is a valid mesh");
}

} // namespace

void fuzz_mesh_file(const std::string& format, const std::string& input) {
  try {
    const Soup soup = read_whole_soup(Input_file::in_memory("mesh." + format, input));
    build_if_sound(soup);
    for(const Remedies& remedies :
        {Remedies{true, false}, Remedies{false, true}, Remedies{true, true}})
      build_if_sound(mend(soup, remedies).soup);
  } catch(const Failure&) {
  }
}
