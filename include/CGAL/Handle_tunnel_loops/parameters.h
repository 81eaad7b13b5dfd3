// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_PARAMETERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_PARAMETERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/version.h>

/// \file parameters.h
/// The named parameters of this package, and those that \cgal does not have in version 5.5. They
/// must come first in a sequence: `parameters::seed_vertex(v).callback(f)`.

// CGAL declares its parameters in one central list: for each, a tag and the same overloads.
#define CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE(TAG, NAME)                                             \
  namespace parameters {                                                                           \
  template <typename T, typename Base, typename Tag, typename Next>                                \
  Named_function_parameters<T, internal_np::TAG, Named_function_parameters<Base, Tag, Next>>       \
  NAME(const T& value, const Named_function_parameters<Base, Tag, Next>& np) {                     \
    return Named_function_parameters<T, internal_np::TAG,                                          \
                                     Named_function_parameters<Base, Tag, Next>>(value, np);       \
  }                                                                                                \
  }

#define CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(TAG, VALUE, NAME)                                   \
  namespace internal_np {                                                                          \
  enum TAG { VALUE };                                                                              \
  }                                                                                                \
  namespace parameters {                                                                           \
  template <typename T> Named_function_parameters<T, internal_np::TAG> NAME(const T& value) {      \
    return Named_function_parameters<T, internal_np::TAG>(value);                                  \
  }                                                                                                \
  }                                                                                                \
  CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE(TAG, NAME)

namespace CGAL {

CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(seed_vertex_t, seed_vertex, seed_vertex)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(basis_kind_t, basis_kind, basis_kind)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(solver_options_t, solver_options, solver_options)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_layer_map_t, vertex_layer_map, vertex_layer_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_value_map_t, vertex_value_map, vertex_value_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(source_vertices_t, source_vertices, source_vertices)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(reeb_options_t, reeb_options, reeb_options)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(skeleton_options_t, skeleton_options, skeleton_options)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_arc_map_t, vertex_arc_map, vertex_arc_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(removal_options_t, removal_options, removal_options)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(known_loops_t, known_loops, known_loops)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_cut_spheres_t, do_cut_spheres, do_cut_spheres)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(through_vertices_t, through_vertices, through_vertices)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(least_prominence_t, least_prominence, least_prominence)

#if CGAL_VERSION_NR < 1050600000
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_output_iterator_t,
                                       vertex_output_iterator,
                                       vertex_output_iterator)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(face_output_iterator_t,
                                       face_output_iterator,
                                       face_output_iterator)
#else
CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE(vertex_output_iterator_t, vertex_output_iterator)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE(face_output_iterator_t, face_output_iterator)
#endif

#if CGAL_VERSION_NR < 1060100000
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(edge_weight_t, edge_weight, edge_weight_map)
#else
CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE(edge_weight_t, edge_weight_map)
#endif

} // namespace CGAL

#undef CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER
#undef CGAL_HANDLE_TUNNEL_LOOPS_ADD_BEFORE

#endif // CGAL_HANDLE_TUNNEL_LOOPS_PARAMETERS_H
