// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_RECORD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_RECORD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>
#include <CGAL/Handle_tunnel_loops/Loop_linking.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// What has been proved of pairs of loops.
struct Certificate
{
  /// every loop is a closed curve on the surface: consecutive steps lie on a common face.
  bool closed_on_surface = false;

  /// the loops are 2g in number and a basis of the first homology group over the integers.
  bool basis = false;

  /// the two loops of each pair cross once, counted with sign. This, and what follows, is left
  /// undecided, as if it were not so, if there are more or fewer loops than a basis has.
  bool pairing = false;

  /// in no pair the linking numbers show that the loop that is called the handle is the tunnel.
  /// That a loop bounds on neither side is no failure.
  bool types = false;

  /// how each loop lies in space, handles and tunnels in turn; empty if that was not asked for.
  std::vector<Loop_linking> linking;

  /// the number of handle loops that bound in the solid, if linking numbers were computed and the
  /// loops are a basis.
  std::optional<std::size_t> handles_bound_inside;

  /// the number of tunnel loops that bound outside the solid, if linking numbers were computed and
  /// the loops are a basis.
  std::optional<std::size_t> tunnels_bound_outside;

  /// the same, each component as if the others were not there.
  std::optional<std::size_t> handles_bound_inside_alone;

  /// the same, each component as if the others were not there.
  std::optional<std::size_t> tunnels_bound_outside_alone;

  /// what the basis was meant to be. Of the shortest one, `pairing` and `types` are not required.
  Basis_kind basis_kind = Basis_kind::PURE;

  /// in words, what failed, a line for each failure; empty if nothing did.
  std::string failure;

  /// of the empty basis, where the genus is 0.
  static Certificate of_no_loops(Basis_kind kind, bool do_link) {
    Certificate c;
    c.closed_on_surface = c.basis = c.pairing = c.types = true;
    if(do_link)
      c.handles_bound_inside = c.tunnels_bound_outside = c.handles_bound_inside_alone =
          c.tunnels_bound_outside_alone = 0;
    c.basis_kind = kind;
    return c;
  }

  /// whether everything holds that is required.
  explicit operator bool() const {
    return closed_on_surface && basis && (basis_kind == Basis_kind::SHORTEST || (pairing && types));
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_RECORD_H
