// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_EXCEPTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_EXCEPTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The defects for which a mesh is rejected.
enum class Mesh_defect {
  EMPTY,                    ///< the mesh has no face
  NOT_TRIANGULATED,         ///< a face is not a triangle
  BOUNDARY_EDGE,            ///< no two faces share an edge: the file has no common vertices
  NON_MANIFOLD_EDGE,        ///< an edge has more than two faces
  NON_MANIFOLD_VERTEX,      ///< the faces around a vertex form more than one fan
  INCONSISTENT_ORIENTATION, ///< two faces traverse their common edge in the same direction
  DEGENERATE_FACE,          ///< a face names the same vertex twice
  PARALLEL_EDGES,           ///< two edges join the same two vertices
  NON_FINITE_COORDINATE,    ///< a coordinate is infinite or not a number
  TOO_LARGE                 ///< more than 2^32 - 2 halfedges
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if the mesh is not an oriented 2-manifold triangle mesh with finite coordinates. The
/// message names the element by the indices of the caller's index maps.
class Invalid_mesh_exception : public std::invalid_argument
{
public:
  Invalid_mesh_exception(Mesh_defect defect,
                         std::vector<std::size_t> vertices,
                         const std::string& message)
      : std::invalid_argument(message)
      , defect_(defect)
      , vertices_(std::move(vertices)) {}

  /// Returns the kind of the defect.
  Mesh_defect defect() const { return defect_; }

  /// Returns the indices of the vertices of the offending element: one for a vertex, two for an
  /// edge, all of a face; none if the defect concerns the whole mesh.
  const std::vector<std::size_t>& vertices() const { return vertices_; }

private:
  Mesh_defect defect_;
  std::vector<std::size_t> vertices_;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if the function of a Reeb graph is infinite or not a number at a vertex.
class Invalid_function_exception : public std::invalid_argument
{
public:
  explicit Invalid_function_exception(std::size_t vertex)
      : std::invalid_argument("the function is not finite: vertex " + std::to_string(vertex))
      , vertex_(vertex) {}

  /// Returns the index of the first such vertex.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if the loops that were found, or waists, fail their certificate. This indicates a defect
/// of the package, never of the input. No loop has been written.
class Uncertified_loops_exception : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if no cut satisfies the constraints: every cut contains an edge of infinite weight, a
/// constrained edge has infinite weight, or the constrained edges separate a part of the surface.
class No_cut_exception : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if a cut does not open every component to one disk, or if dual cuts are not dual to their
/// loops. This indicates a defect of the package, never of the input. Nothing has been written.
class Uncertified_cut_exception : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if a rule of the paper that is followed literally (`Literal_rules`) finds no result. No
/// loop has been written. The default rules may find a result.
class Literal_failure_exception : public std::runtime_error
{
public:
  explicit Literal_failure_exception(const std::string& reason)
      : std::runtime_error("the paper's literal rules find no loops here: " + reason) {}
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if the `callback` returned `false`. No loop has been written.
class Interrupted_exception : public std::runtime_error
{
public:
  Interrupted_exception()
      : std::runtime_error("the computation was stopped by its callback") {}
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if a computation on a CUDA device fails. The message is that of the CUDA runtime.
class Device_exception : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown by a computation with `Cuda_tag` if there is no CUDA device or no driver for it.
class No_device_exception : public Device_exception
{
public:
  using Device_exception::Device_exception;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Thrown if the device memory is too small. The mesh and the solver are unchanged.
class Out_of_device_memory_exception : public Device_exception
{
public:
  Out_of_device_memory_exception(std::size_t needed, std::size_t free)
      : Device_exception("the device has too little memory: " + std::to_string(needed) +
                         " bytes are needed, " + std::to_string(free) + " are free")
      , needed_(needed)
      , free_(free) {}

  /// Returns the number of bytes needed, as far as it is known.
  std::size_t bytes_needed() const { return needed_; }
  /// Returns the number of free bytes.
  std::size_t bytes_free() const { return free_; }

private:
  std::size_t needed_, free_;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_EXCEPTIONS_H
