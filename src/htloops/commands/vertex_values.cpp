// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/vertex_values.h"

#include "app/file_names.h"
#include "app/read/vertex_data.h"
#include "app/write/mesh_writer.h"

#include <boost/algorithm/string/join.hpp>

#include <cstdio>

namespace htloops {

Vertex_properties values_to_keep(const Input_file& file,
                                 const File_facts& facts,
                                 const std::string& result_file,
                                 bool is_quiet) {
  if(result_file.empty())
    return {};
  Vertex_properties kept = kept_by_format(result_file, read_vertex_properties(file));
  std::vector<std::string> unread = unread_data(file, kept);
  unread.insert(unread.end(), facts.unread.begin(), facts.unread.end());
  const std::string list = boost::algorithm::join(unread, "; ");
  if(!list.empty() && !is_quiet)
    std::fprintf(stderr, "htloops: not kept from %s: %s\n", file.name().c_str(), list.c_str());
  return kept;
}

void extend(Vertex_properties& properties, const std::vector<std::uint32_t>& origins) {
  for(Vertex_property& property : properties)
    for(const std::uint32_t origin : origins)
      property.values.push_back(double(property.values[origin]));
}

} // namespace htloops
