// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FUNCTION_ON_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FUNCTION_ON_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// an integer that orders as the finite value does; the two zeros are one.
inline std::uint64_t ordering_key(double value) {
  value += 0.; // turns -0 into 0
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  constexpr std::uint64_t sign = std::uint64_t(1) << 63;
  return bits & sign ? ~bits : bits | sign;
}

template <typename Integer>
std::enable_if_t<std::is_integral<Integer>::value, std::uint64_t> ordering_key(Integer value) {
  constexpr std::uint64_t sign = std::uint64_t(1) << 63;
  return std::is_signed<Integer>::value
             ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) ^ sign
             : static_cast<std::uint64_t>(value);
}

/// A function on the vertices, as numbers to calculate with and as integers to sort by: arrival
/// times, or values of the caller. Of these, integers are sorted exactly, all else as double. On a
/// cap it leads from side to side, without a peak.
class Function_on_vertices
{
public:
  /// \p times are those of all vertices; what the front does in a cap is no matter of the surface.
  Function_on_vertices(const Flat_mesh& mesh, std::vector<std::uint32_t> times, double ticks);

  /// \p vertices are those of the flat mesh but for the hubs. Throws `Invalid_function_exception`.
  template <typename Map, typename Vertices>
  Function_on_vertices(const Flat_mesh& mesh, const Map& map, const Vertices& vertices) {
    using Scalar = std::decay_t<typename boost::property_traits<Map>::value_type>;
    values_.reserve(vertices.size());
    keys_.reserve(vertices.size());
    for(const auto v : vertices) {
      const Scalar scalar = get(map, v);
      if constexpr(std::is_arithmetic<Scalar>::value)
        values_.push_back(static_cast<double>(scalar));
      else
        values_.push_back(CGAL::to_double(scalar));
      if constexpr(std::is_integral<Scalar>::value)
        keys_.push_back(ordering_key(scalar));
      else
        keys_.push_back(ordering_key(values_.back()));
    }
    check_values(mesh);
    lead_over_caps(mesh);
  }

  double value(Index v) const {
    return times_.empty() ? values_[v] : double(times_[v]) / ticks_per_step_;
  }
  std::uint64_t key(Index v) const { return times_.empty() ? keys_[v] : times_[v]; }

  /// the vertex of a boundary curve that is in the middle of these, in the order of the function. A
  /// hub with the same key is no critical point, unless the function has several maxima on the
  /// curve.
  Index middle_of_curve(const Flat_mesh& mesh, Index hub) const;

private:
  void check_values(const Flat_mesh& mesh) const;
  void lead_over_caps(const Flat_mesh& mesh);

  std::vector<std::uint32_t> times_; // or both of the others
  std::vector<double> values_;
  std::vector<std::uint64_t> keys_;
  double ticks_per_step_ = 1.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FUNCTION_ON_VERTICES_H
