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

// windows.h defines a macro of this name.
#undef PURE

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The kinds of bases of the first homology group.
enum class Basis_kind {
  /// Short handle loops that bound in the solid and short tunnel loops that bound outside of it,
  /// where each component is considered without the others. The loops of each pair cross once. On
  /// components that touch or cross themselves or each other, it is any basis of such pairs.
  PURE,
  /// The shortest loops found that are a basis; they may bound on either side or on none. Use it
  /// for cutting and parametrization. The loops of each pair cross once if they can be paired like
  /// that, and otherwise an odd number of times, counted with sign.
  SHORTEST
};

/// Returns the name of a kind of basis, as it appears in files.
inline const char* name_of(Basis_kind kind) {
  return kind == Basis_kind::PURE ? "pure" : "shortest";
}

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_BASIS_KIND_H
