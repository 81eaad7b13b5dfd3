// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/bytes.h"
#include "write/meshes/single_precision.h"

#include <boost/endian/conversion.hpp>

#include <cstdint>

namespace htloops {

void write_freesurfer(Text_writer& out, const Written_mesh& written) {
  constexpr auto order = boost::endian::order::big;
  const auto& [points, triangles] = written.mesh;
  const double scale = scale_to_millimeters(written);
  check_single_precision(written, scale);
  std::string bytes = "\xFF\xFF\xFE"
                      "made by htloops\n\n";
  append_bytes<order>(bytes, static_cast<std::int32_t>(points.size()));
  append_bytes<order>(bytes, static_cast<std::int32_t>(triangles.size()));
  for(const auto& point : points)
    for(const double x : point)
      append_bytes<order>(bytes, static_cast<float>(scale * x));
  for(const auto& triangle : triangles)
    for(const std::uint32_t v : triangle)
      append_bytes<order>(bytes, v);
  out << bytes << written.facts.volume_geometry;
}

} // namespace htloops
