// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "words.h"
#include "write/bytes.h"
#include "write/meshes/single_precision.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace htloops {
namespace {

using Place = std::array<float, 3>;

Place rounded(const std::array<double, 3>& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

// Only points that are at different places can fall together.
void check_stay_apart(const Written_mesh& written) {
  Point_merger exact, single;
  std::size_t places = 0, rounded_places = 0;
  for(const auto& p : written.mesh.points) {
    const Place q = rounded(p);
    places = (std::max)(places, std::size_t(exact.number(Point(p[0], p[1], p[2])) + 1));
    rounded_places =
        (std::max)(rounded_places, std::size_t(single.number(Point(q[0], q[1], q[2])) + 1));
  }
  if(rounded_places < places)
    throw wrong_usage(
        counted(places - rounded_places, "vertex would coincide with another one",
                "vertices would coincide") +
        " in the single precision of binary STL: use .ascii.stl, or a format with vertices "
        "(.ply .obj .3mf)");
}

Place normal_of(const std::array<std::array<double, 3>, 3>& corners) {
  std::array<double, 3> u{}, v{};
  for(std::size_t i = 0; i < 3; ++i) {
    u[i] = corners[1][i] - corners[0][i];
    v[i] = corners[2][i] - corners[0][i];
  }
  std::array<double, 3> n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for(double& x : n)
    x = length > 0. ? x / length : 0.;
  return rounded(n);
}

} // namespace

void write_stl(Text_writer& out, const Written_mesh& written) {
  check_single_precision(written);
  check_stay_apart(written);
  constexpr std::size_t header_size = 80;
  std::string bytes = "made by htloops";
  bytes.resize(header_size, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(written.mesh.triangles.size()));
  out << bytes;
  for(const auto& [a, b, c] : written.mesh.triangles) {
    const auto& p = written.mesh.points;
    bytes.clear();
    for(const Place& row :
        {normal_of({p[a], p[b], p[c]}), rounded(p[a]), rounded(p[b]), rounded(p[c])})
      for(const float x : row)
        append_bytes(bytes, x);
    append_bytes(bytes, std::uint16_t(0));
    out << bytes;
  }
}

} // namespace htloops
