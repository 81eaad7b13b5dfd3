// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/Loop_certifier.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// What has been proved of a set of loops.
struct Certificate
{
  /// every loop is a closed curve on the surface: consecutive steps lie on a common face.
  bool closed_on_surface = false;

  /// the loops are 2g in number and a basis of the first homology group over the integers.
  bool basis = false;

  /// in words, the first thing that failed; empty if nothing did.
  std::string failure;

  /// whether everything holds.
  explicit operator bool() const { return closed_on_surface && basis; }
};

} // namespace Handle_tunnel_loops

/*!
\ingroup PkgHandleTunnelLoopsRef

computes whether the loops of `pairs` are closed curves on `tm` that form a basis of the first
homology group with integer coefficients.

The loops are moved onto the edges, and the mesh is cut along them. The intersection numbers of the
loops with the closed curves of a tree-cotree decomposition of the dual graph that crosses them as
rarely as possible are integers; the loops are a basis if and only if these vectors span all integer
vectors, which integer elimination decides. Nothing is shared with the code that finds the loops,
nothing rests on floating-point numbers, and the surface need not be connected. Almost linear in the
size of the mesh where the loops are short.

\tparam TriangleMesh a model of `FaceListGraph`, a closed triangle mesh
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param pairs the loops
\param np named parameters

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `tm` is a closed triangle mesh.
*/
template <typename TriangleMesh,
          typename PairRange,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Certificate
certify_handle_tunnel_loops(const TriangleMesh& tm,
                            const PairRange& pairs,
                            const NamedParameters& np = parameters::default_values()) {
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  Handle_tunnel_loops::internal::Loop_certifier<TriangleMesh, decltype(vertex_index),
                                                decltype(face_index)>
      certifier(tm, vertex_index, face_index);
  for(const auto& pair : pairs) {
    certifier.add(pair.handle());
    certifier.add(pair.tunnel());
  }
  Handle_tunnel_loops::Certificate certificate;
  certificate.closed_on_surface = certifier.are_closed_on_surface();
  certificate.basis = certificate.closed_on_surface && certifier.are_basis();
  certificate.failure = certifier.failure();
  return certificate;
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H
