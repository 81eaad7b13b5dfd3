// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/mesh_reader.h"

#include "failure.h"
#include "read/mesh_builder.h"
#include "read/soup_diagnosis.h"
#include "read/soup_reader.h"

namespace htloops {
namespace {

std::string message(const std::string& file, const std::vector<Defect>& defects) {
  if(defects.size() == 1)
    return file + ": " + defects.front().message;
  std::string text = file + " is no closed oriented manifold of triangles:";
  for(const Defect& defect : defects)
    text += "\n  " + defect.message;
  return text;
}

} // namespace

Mesh read_mesh(const Input_file& file) {
  const Soup soup = read_soup(file);
  const Diagnosis diagnosis = diagnose(soup);
  if(!diagnosis.defects.empty())
    throw Failure(Exit_code::UNACCEPTABLE_MESH, message(file.name(), diagnosis.defects));
  return build_mesh(soup, diagnosis);
}

} // namespace htloops
