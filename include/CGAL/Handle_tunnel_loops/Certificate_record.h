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
/// The certificate of a set of pairs of loops: the properties that have been certified.
struct Certificate
{
  /// whether every loop is a closed curve on the surface: consecutive steps lie on a common face.
  bool closed_on_surface = false;

  /// whether there are 2g loops that are a basis of the first homology group over the integers.
  bool basis = false;

  /// whether the two loops of each pair cross once, counted with sign. This member and the
  /// following ones remain undecided, with the value `false`, if the number of loops is not 2g.
  bool pairing = false;

  /// whether no pair is named wrongly, that is, linking numbers never show that the loop that is
  /// called the handle loop is the tunnel loop. A loop that bounds on neither side is no failure.
  bool types = false;

  /// the linking numbers of each loop, in the order handle loop, tunnel loop for each pair; empty
  /// if they were not computed.
  std::vector<Loop_linking> linking;

  /// the number of handle loops that bound in the solid; set if linking numbers were computed and
  /// the loops are a basis.
  std::optional<std::size_t> handles_bound_inside;

  /// the number of tunnel loops that bound outside the solid; set if linking numbers were computed
  /// and the loops are a basis.
  std::optional<std::size_t> tunnels_bound_outside;

  /// the number of handle loops that bound inside their component, considered without the others.
  std::optional<std::size_t> handles_bound_inside_alone;

  /// the number of tunnel loops that bound outside their component, considered without the others.
  std::optional<std::size_t> tunnels_bound_outside_alone;

  /// the requested kind of basis. For the shortest basis, `pairing` and `types` are not required.
  Basis_kind basis_kind = Basis_kind::PURE;

  /// what failed, as text with one line per failure; empty if nothing failed.
  std::string failure;

  /// Returns the certificate of the empty basis of a surface of genus 0.
  static Certificate of_no_loops(Basis_kind kind, bool do_link) {
    Certificate c;
    c.closed_on_surface = c.basis = c.pairing = c.types = true;
    if(do_link)
      c.handles_bound_inside = c.tunnels_bound_outside = c.handles_bound_inside_alone =
          c.tunnels_bound_outside_alone = 0;
    c.basis_kind = kind;
    return c;
  }

  /// Returns whether all required properties hold.
  explicit operator bool() const {
    return closed_on_surface && basis && (basis_kind == Basis_kind::SHORTEST || (pairing && types));
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_RECORD_H
