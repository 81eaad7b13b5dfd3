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
/// What has been proved of a curve skeleton.
struct Skeleton_certificate
{
  /// each component of the mesh has one connected part of the skeleton, with as many independent
  /// cycles as the genus of the component, and each part is of one component.
  bool connected = false;

  /// every edge lies strictly inside the component that it belongs to, and meets no other; but for
  /// inlets, which lie on caps.
  bool inside = false;

  /// no two edges meet but in a common end.
  bool embedded = false;

  /// the cycles of each component are a basis of H1 of the solid inside it, by their linking
  /// numbers with the handle loops: an integer matrix of determinant 1 or -1.
  bool basis = false;

  /// an edge that is not strictly inside, by the numbers of its ends; and the face that it meets,
  /// by its number, if it meets one.
  struct Edge_outside
  {
    std::pair<std::size_t, std::size_t> edge;
    std::optional<std::size_t> face;
  };

  /// the edges that are not strictly inside, or cannot be said to be.
  std::vector<Edge_outside> edges_outside;

  /// edges that meet other than in a common end, by the numbers of their ends: the first ones.
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>>>
      edges_that_meet;

  /// in words, what failed, a line for each failure; empty if nothing did.
  std::string failure;

  /// whether everything holds.
  explicit operator bool() const { return connected && inside && embedded && basis; }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SKELETON_CERTIFICATE_H
