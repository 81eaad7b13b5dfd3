// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

class Progress;
struct Loop_relations;

/// the certificate of loops, handles and tunnels in turn, but for names.
Certificate certify(Execution execution,
                    Triangle_list list,
                    const std::vector<Listed_loop>& loops,
                    Basis_kind kind,
                    bool do_link);

/// A certificate that has named the loops of pairs.
struct Naming
{
  Certificate certificate;
  std::vector<char> is_exchanged; ///< by pair, if its first loop is the tunnel
};

/// certifies loops of which the relations are known, and tells handles from tunnels: by their
/// linking numbers, or by their growth along the normals where these do not tell (paper, 4.5), at
/// the given offset if it is not 0. `read()` reads the mesh, with points where growth is asked for.
Naming certify_and_name(Execution execution,
                        const std::function<Triangle_list(bool with_points)>& read,
                        const std::vector<Listed_loop>& loops,
                        Basis_kind kind,
                        double offset,
                        Loop_relations relations,
                        Progress& progress);

/// by loop, in words, why it is no closed curve on the surface; empty if it is one.
std::vector<std::string>
reasons_not_closed(Execution execution, Triangle_list list, const std::vector<Listed_loop>& loops);

/// the numbers of those pairs of loops, 2k and 2k + 1, that are not homologous over the integers,
/// as they are directed. The surface may have a boundary, which does not bound.
std::vector<std::size_t> pairs_of_different_class(Execution execution,
                                                  Triangle_list list,
                                                  const std::vector<Listed_loop>& loops);

/// A loop that is said to be homologous to a boundary curve.
struct Listed_waist
{
  Listed_loop loop;
  std::size_t curve; ///< its number
};

/// says in words what is wrong with waists, whoever found them: they have to be closed curves on
/// the surface that are homologous to boundary curves. Time: that of a walk over the faces, and for
/// each waist over the pieces into which all loops cut the surface.
std::vector<std::string> problems_of_waists(Execution execution,
                                            Triangle_list list,
                                            const std::vector<Listed_loop>& curves,
                                            const std::vector<Listed_waist>& waists);

/// the same, and what is wrong with the curves, which have to be those of the surface, all of them.
std::vector<std::string> problems_of_boundaries(Execution execution,
                                                Triangle_list list,
                                                const std::vector<Listed_loop>& curves,
                                                const std::vector<Listed_waist>& waists);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFY_H
