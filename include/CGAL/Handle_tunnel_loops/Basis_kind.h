// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_BASIS_KIND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_BASIS_KIND_H

#include <CGAL/license/Handle_tunnel_loops.h>

// windows.h has a macro of this name.
#undef PURE

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// Which basis of the first homology group is looked for.
enum class Basis_kind {
  /// Handle loops that bound in the solid and tunnel loops that bound outside of it, each component
  /// as if the others were not there, and of these short ones. Each pair crosses once. On
  /// components that touch or cross themselves or others it is any basis in such pairs.
  PURE,
  /// The shortest loops found that are a basis, whatever side they bound on, if any: for cutting
  /// and parametrization. Each pair crosses once if they can be paired so, or else an odd number of
  /// times, counted with sign.
  SHORTEST
};

/// the name of a kind of basis, as it stands in files.
inline const char* name_of(Basis_kind kind) {
  return kind == Basis_kind::PURE ? "pure" : "shortest";
}

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_BASIS_KIND_H
