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

/// \file parameters.h
/// The named parameters that only this package has. They begin a chain:
/// `parameters::seed_vertex(v).callback(f)`.

namespace CGAL {
namespace internal_np {

enum seed_vertex_t { seed_vertex };
enum field_constants_t { field_constants };
enum do_refine_handles_t { do_refine_handles };
enum do_tighten_t { do_tighten };
enum do_compute_linking_t { do_compute_linking };
enum do_log_fronts_t { do_log_fronts };
enum literal_rules_t { literal_rules };
enum source_vertices_t { source_vertices };
enum vertex_function_map_t { vertex_function_map };
enum reeb_measure_t { reeb_measure };
enum simplification_threshold_t { simplification_threshold };
enum vertex_arc_map_t { vertex_arc_map };
enum vertex_value_map_t { vertex_value_map };
enum vertex_layer_map_t { vertex_layer_map };
enum vertex_time_map_t { vertex_time_map };
enum allow_parallel_arcs_t { allow_parallel_arcs };
enum device_options_t { device_options };
enum basis_kind_t { basis_kind };
enum removal_method_t { removal_method };
enum target_genus_t { target_genus };
enum maximal_length_t { maximal_length };
enum handle_filter_t { handle_filter };
enum removal_box_t { removal_box };
enum known_pairs_t { known_pairs };
enum do_dry_run_t { do_dry_run };
enum maximal_neck_length_t { maximal_neck_length };
enum minimal_piece_share_t { minimal_piece_share };
enum added_faces_t { added_faces };
enum added_vertices_t { added_vertices };
enum remaining_pairs_t { remaining_pairs };
enum cone_vertices_t { cone_vertices };
enum edge_weight_map_t { edge_weight_map };
enum edge_is_avoided_map_t { edge_is_avoided_map };
enum do_cut_spheres_t { do_cut_spheres };
enum cut_loops_t { cut_loops };
enum face_origin_map_t { face_origin_map };

} // namespace internal_np

namespace parameters {

// CGAL declares its parameters in one central list, by the same two overloads per name.
#define CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(NAME)                                               \
  template <typename T> Named_function_parameters<T, internal_np::NAME##_t> NAME(const T& value) { \
    return Named_function_parameters<T, internal_np::NAME##_t>(value);                             \
  }                                                                                                \
  template <typename T, typename Base, typename Tag, typename Next>                                \
  Named_function_parameters<T, internal_np::NAME##_t, Named_function_parameters<Base, Tag, Next>>  \
  NAME(const T& value, const Named_function_parameters<Base, Tag, Next>& np) {                     \
    return Named_function_parameters<T, internal_np::NAME##_t,                                     \
                                     Named_function_parameters<Base, Tag, Next>>(value, np);       \
  }

CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(seed_vertex)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(field_constants)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_refine_handles)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_tighten)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_compute_linking)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_log_fronts)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(literal_rules)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(source_vertices)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_function_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(reeb_measure)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(simplification_threshold)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_arc_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_value_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_layer_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(vertex_time_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(allow_parallel_arcs)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(device_options)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(basis_kind)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(removal_method)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(target_genus)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(maximal_length)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(handle_filter)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(removal_box)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(known_pairs)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_dry_run)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(maximal_neck_length)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(minimal_piece_share)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(added_faces)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(added_vertices)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(remaining_pairs)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(cone_vertices)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(edge_weight_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(edge_is_avoided_map)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(do_cut_spheres)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(cut_loops)
CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER(face_origin_map)

#undef CGAL_HANDLE_TUNNEL_LOOPS_ADD_PARAMETER

} // namespace parameters
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_PARAMETERS_H
