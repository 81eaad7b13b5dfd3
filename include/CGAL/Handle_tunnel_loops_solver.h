// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Loops_of_caller.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Prepares a mesh once, for repeated computations of its handle and tunnel loops, for example from
several seeds. The mesh must outlive the solver and must not change during its lifetime.

The preparation needs about 60 bytes per vertex plus one vertex descriptor per vertex, and the index
maps if the mesh has none.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and
  `GeomTraits::Point_3` as value type; the default is the vertex point map of the mesh
\tparam GeomTraits a model of `Kernel` whose number type is `double` or exact; the default is the
  kernel of the points

\sa `CGAL::handle_tunnel_loops()`
*/
template <typename TriangleMesh, typename VertexPointMap = Default, typename GeomTraits = Default>
class Handle_tunnel_loops_solver
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Vertex_point_map = typename Default::Get<
      VertexPointMap,
      typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::type;
  using Point_ = typename boost::property_traits<Vertex_point_map>::value_type;
  using Geom_traits =
      typename Default::Get<GeomTraits, typename Kernel_traits<Point_>::Kernel>::type;

public:
  /// The point type of the mesh.
  using Point = Point_;
  /// The type of the results.
  using Pair = Handle_tunnel_pair<TriangleMesh, Point>;

  /*!
  Checks and prepares a mesh. The complexity is linear, except for sorting the vertices along a
  space-filling curve.

  \param tm a triangle mesh with or without boundary
  \param np an optional sequence of named parameters: `vertex_point_map`, `vertex_index_map`,
    `face_index_map` and `geom_traits`, as in `CGAL::handle_tunnel_loops()`. All computations use
    these maps

  \throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
    mesh, with or without boundary, with finite coordinates
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Handle_tunnel_loops_solver(const TriangleMesh& tm,
                                      const NamedParameters& np = parameters::default_values())
      : Handle_tunnel_loops_solver(Sequential_tag(), tm, np) {}

  /// Same as above; `ConcurrencyTag` selects sequential or parallel preparation.
  template <typename ConcurrencyTag, typename NamedParameters>
  Handle_tunnel_loops_solver(ConcurrencyTag, const TriangleMesh& tm, const NamedParameters& np) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    const auto began = std::chrono::steady_clock::now();
    const auto head_start = impl::head_start<ConcurrencyTag>(solver_options(np), num_vertices(tm));
    const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
    const Vertex_point_map point =
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                     get_const_property_map(vertex_point, tm));
    surface_ = std::make_shared<const Surface>(impl::execution_of<ConcurrencyTag>(), tm,
                                               vertex_index, point);
    const auto traits = parameters::choose_parameter<Geom_traits>(
        parameters::get_parameter(np, internal_np::geom_traits));
    const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
    using Loops_on_mesh = impl::Loops_on_mesh<Surface, std::decay_t<decltype(vertex_index)>,
                                              std::decay_t<decltype(face_index)>, Geom_traits>;
    make_loops_ = [surface = surface_, vertex_index, face_index, traits] {
      return std::make_unique<Loops_on_mesh>(surface, vertex_index, face_index, traits);
    };
    surface_->describe(prepared_);
    prepared_.seconds[static_cast<std::size_t>(Stage::ADAPTOR)] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    statistics_ = prepared_;
  }

  /// Returns the genus, summed over the connected components.
  std::size_t genus() const { return surface_->mesh.genus; }

  /// Returns the number of connected components.
  std::size_t number_of_components() const { return surface_->mesh.seeds.size(); }

  /// Returns the number of boundary curves.
  std::size_t number_of_boundaries() const { return surface_->mesh.number_of_hubs; }

  /// Returns the statistics of the last computation.
  const Handle_tunnel_loops::Statistics& statistics() const { return statistics_; }

  /// Returns the certificate of the last result.
  const Handle_tunnel_loops::Certificate& certificate() const { return certificate_; }

  /*!
  Computes the loops, as `CGAL::handle_tunnel_loops()` does. Afterwards, `certificate()` returns
  what has been certified, including the sides on which each loop bounds.

  \tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
    `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag` and
    `Cuda_if_available_tag`. The result does not depend on the tag.
  \param out an output iterator that accepts `Pair`
  \param np an optional sequence of named parameters: all those of `CGAL::handle_tunnel_loops()`
    except those of the constructor, which are ignored here
  \return `out`, past the last pair written
  \throws . the exceptions of `CGAL::handle_tunnel_loops()`
  */
  template <typename ConcurrencyTag = Sequential_tag,
            typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  OutputIterator find_loops(OutputIterator out,
                            const NamedParameters& np = parameters::default_values()) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    using parameters::choose_parameter;
    using parameters::get_parameter;
    CGAL_expensive_precondition_msg(halfedges(surface_->tm).size() +
                                            2 * surface_->mesh.number_of_faces_of_caps() ==
                                        surface_->mesh.neighbor.size(),
                                    "the mesh has changed since the solver was made");
    statistics_ = prepared_;
    certificate_ = Certificate();
    auto visitor = choose_parameter<Default_visitor>(get_parameter(np, internal_np::visitor));
    const impl::Listeners listeners = {
        choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
        [&](Stage stage) { unwrapped(visitor).start_stage(stage); },
        [&](Stage stage) { unwrapped(visitor).end_stage(stage); }};
    impl::Loop_request wanted = request(np);
    wanted.make_passes = &impl::make_passes<ConcurrencyTag>;
    const auto loops = make_loops_();
    certificate_ = impl::find_loops(impl::execution_of<ConcurrencyTag>(), surface_->mesh, wanted,
                                    *loops, listeners, statistics_);
    return std::move(loops->pairs.begin(), loops->pairs.end(), out);
  }

  /// \cond SKIP_IN_MANUAL
  // For other functions that use the same arrays, such as cuts.
  const auto& prepared_surface() const { return *surface_; }
  /// \endcond

private:
  using Surface = Handle_tunnel_loops::internal::Prepared_surface<TriangleMesh, Vertex_point_map>;
  using Loops = Handle_tunnel_loops::internal::Loops_of_caller<Pair>;

  template <typename T> static T& unwrapped(T& t) { return t; }
  template <typename T> static T& unwrapped(std::reference_wrapper<T> t) { return t.get(); }

  template <typename NamedParameters, typename Tag>
  static constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

  template <typename NamedParameters>
  static Handle_tunnel_loops::Solver_options solver_options(const NamedParameters& np) {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::solver_options),
                                        Handle_tunnel_loops::Solver_options());
  }

  template <typename NamedParameters>
  Handle_tunnel_loops::internal::Loop_request request(const NamedParameters& np) const {
    using namespace Handle_tunnel_loops;
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const Solver_options options = solver_options(np);
    Handle_tunnel_loops::internal::Loop_request request =
        Handle_tunnel_loops::internal::loop_request(
            options, is_given<NamedParameters, internal_np::vertex_layer_map_t>,
            is_given<NamedParameters, internal_np::vertex_value_map_t>);
    request.classes.kind =
        choose_parameter(get_parameter(np, internal_np::basis_kind), Basis_kind::PURE);
    request.classes.maximum_running_time = choose_parameter(
        get_parameter(np, internal_np::maximum_running_time), request.classes.maximum_running_time);
    request.seeds = seeds(
        choose_parameter(get_parameter(np, internal_np::seed_vertex), Graph_traits::null_vertex()));
    request.put_swept_vertices = [this, &np](const auto& swept) {
      this->put_swept_vertices(swept, np);
    };
    return request;
  }

  // The given seed replaces the seed of its component.
  std::vector<Handle_tunnel_loops::internal::Index> seeds(vertex_descriptor seed) const {
    auto seeds = surface_->mesh.seeds;
    if(seed == Graph_traits::null_vertex())
      return seeds;
    const Handle_tunnel_loops::internal::Index i = surface_->index_of(seed);
    if(i == Handle_tunnel_loops::internal::no_index)
      throw std::invalid_argument("the seed vertex is isolated or not in the mesh");
    seeds[surface_->mesh.component[i]] = i;
    return seeds;
  }

  template <typename NamedParameters>
  void
  put_swept_vertices([[maybe_unused]] const Handle_tunnel_loops::internal::Swept_vertices& swept,
                     [[maybe_unused]] const NamedParameters& np) const {
    [[maybe_unused]] const auto& vertices = surface_->vertices;
    if constexpr(is_given<NamedParameters, internal_np::vertex_layer_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_layer_map);
      for(std::size_t v = 0; v < vertices.size(); ++v)
        put(map, vertices[v], std::size_t(swept.layers[v]));
    }
    if constexpr(is_given<NamedParameters, internal_np::vertex_value_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_value_map);
      for(std::size_t v = 0; v < vertices.size(); ++v)
        put(map, vertices[v], swept.times[v]);
    }
  }

  std::shared_ptr<const Surface> surface_;
  // One computation; only this function knows the types of the constructor's parameters.
  std::function<std::unique_ptr<Loops>()> make_loops_;
  Handle_tunnel_loops::Statistics prepared_, statistics_;
  Handle_tunnel_loops::Certificate certificate_;
};

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_H
