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

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/middle_of_curve.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A function of the caller, as numbers to calculate with and as integers to sort by. Integers are
/// sorted exactly, all else as double. On a cap it leads from side to side, without a peak.
class Function_on_vertices
{
public:
  /// \p vertices are those of the flat mesh but for the hubs. Throws `Invalid_function_exception`.
  template <typename Map, typename Vertices>
  Function_on_vertices(const Flat_mesh& mesh, const Map& map, const Vertices& vertices) {
    using Scalar = std::decay_t<typename boost::property_traits<Map>::value_type>;
    values_.reserve(vertices.size());
    keys_.reserve(vertices.size());
    Index not_finite = no_index;
    for(std::size_t v = 0; v < vertices.size(); ++v) {
      const Scalar scalar = get(map, vertices[v]);
      if constexpr(std::is_arithmetic<Scalar>::value)
        values_.push_back(static_cast<double>(scalar));
      else
        values_.push_back(CGAL::to_double(scalar));
      if(!std::isfinite(values_.back()))
        not_finite = (std::min)(not_finite, mesh.original[v]);
      if constexpr(std::is_integral<Scalar>::value)
        keys_.push_back(ordering_key(scalar));
      else
        keys_.push_back(ordering_key(values_.back()));
    }
    if(not_finite != no_index)
      throw Invalid_function_exception(not_finite);
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
      const Index v = middle_of_curve(mesh, hub, [this](Index u) { return keys_[u]; });
      values_.push_back(values_[v]);
      keys_.push_back(keys_[v]);
    }
  }

  double value(Index v) const { return values_[v]; }
  std::uint64_t key(Index v) const { return keys_[v]; }

private:
  std::vector<double> values_;
  std::vector<std::uint64_t> keys_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FUNCTION_ON_VERTICES_H
