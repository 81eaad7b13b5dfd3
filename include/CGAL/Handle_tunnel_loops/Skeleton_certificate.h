// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_SKELETON_CERTIFICATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_SKELETON_CERTIFICATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The certificate of a curve skeleton: the properties that have been certified.
struct Skeleton_certificate
{
  /// whether each piece of the solid has one connected part of the skeleton, with as many
  /// independent cycles as the genera of the surfaces that bound it add up to, and each part
  /// belongs to one piece.
  bool connected = false;

  /// whether every edge lies strictly inside its piece of the solid and meets no face. Inlets,
  /// which lie on caps, are exempt.
  bool inside = false;

  /// whether two edges meet at most in a common endpoint.
  bool embedded = false;

  /// whether the cycles in each piece of the solid are a basis of its H1. The matrix of
  /// their linking numbers with the handle loops proves this if its determinant is 1 or -1.
  bool basis = false;

  /// An edge that is not certified to lie strictly inside, given by the numbers of its ends, and
  /// the number of the face that it meets, if any.
  struct Edge_outside
  {
    std::pair<std::size_t, std::size_t> edge;
    std::optional<std::size_t> face;
  };

  /// the edges that are not certified to lie strictly inside.
  std::vector<Edge_outside> edges_outside;

  /// the first pairs of edges that meet other than in a common endpoint, by the numbers of their
  /// ends.
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>>>
      edges_that_meet;

  /// which components of the surface bound a piece of the solid by themselves although they lie in
  /// another one, or meet it, and why, as text with one line each; empty if there are none.
  std::string taken_alone;

  /// what failed, as text with one line per failure; empty if nothing failed.
  std::string failure;

  /// Returns whether all properties hold.
  explicit operator bool() const { return connected && inside && embedded && basis; }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SKELETON_CERTIFICATE_H
