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

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/check_constants.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Capped_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Loop_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes_of_tag.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Handle_tunnel_loops {
namespace internal {
struct Solver_access;
}
} // namespace Handle_tunnel_loops

/*!
\ingroup PkgHandleTunnelLoopsRef

Keeps what can be prepared of a mesh once, for repeated computations of its handle and tunnel loops,
say from several seeds. The mesh must outlive the object and must not change meanwhile.

The preparation takes about 60 bytes per vertex and vertex descriptor, and the index maps of
meshes that have none of their own.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and
  `GeomTraits::Point_3` as value type; by default the mesh's own
\tparam GeomTraits a model of `Kernel` with double or exact numbers; by default that of the points

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
  /// the point type of the mesh.
  using Point = Point_;
  /// the type of the results.
  using Pair = Handle_tunnel_pair<TriangleMesh, Point>;

  /*!
  checks and prepares a mesh. Linear, but for the sort of the vertices along a space-filling curve.

  \param tm the mesh
  \param np a sequence of named parameters: `vertex_point_map`, `vertex_index_map`,
    `face_index_map`, `geom_traits`, as in `CGAL::handle_tunnel_loops()`; the maps are those of all
    computations

  \throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
    mesh, with or without boundary, with finite coordinates
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Handle_tunnel_loops_solver(const TriangleMesh& tm,
                                      const NamedParameters& np = parameters::default_values())
      : Handle_tunnel_loops_solver(Sequential_tag(), tm, np) {}

  /// as above; the preparation is parallel if `ConcurrencyTag` says so.
  template <typename ConcurrencyTag, typename NamedParameters>
  Handle_tunnel_loops_solver(ConcurrencyTag, const TriangleMesh& tm, const NamedParameters& np)
      : tm_(tm)
      , point_(
            parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                         get_const_property_map(vertex_point, tm)))
      , traits_(parameters::choose_parameter<Geom_traits>(
            parameters::get_parameter(np, internal_np::geom_traits))) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    const auto began = std::chrono::steady_clock::now();
    const typename impl::Passes_of_tag<ConcurrencyTag>::Head_start head_start(
        solver_options(np).device, num_vertices(tm));
    const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
    impl::Flat_mesh_builder<TriangleMesh, std::decay_t<decltype(vertex_index)>, Vertex_point_map>
        builder(impl::execution_of<ConcurrencyTag>(), tm, vertex_index, point_);
    mesh_ = builder.build();
    vertices_ = builder.take_vertices();
    if(mesh_.number_of_hubs == 0)
      look_at_closed_surface(vertex_index, CGAL::get_initialized_face_index_map(tm, np));
    else
      look_at_capped_surface(vertex_index);
    statistics_.number_of_vertices = mesh_.number_of_vertices() - mesh_.number_of_hubs;
    statistics_.number_of_faces = mesh_.number_of_faces() - mesh_.number_of_faces_of_caps();
    statistics_.number_of_components = mesh_.seeds.size();
    statistics_.number_of_boundaries = mesh_.number_of_hubs;
    statistics_.genus = mesh_.genus;
    statistics_.seconds[static_cast<std::size_t>(Stage::ADAPTOR)] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

  /// the genus, summed over the connected components.
  std::size_t genus() const { return mesh_.genus; }

  /// the number of connected components.
  std::size_t number_of_components() const { return mesh_.seeds.size(); }

  /// the number of boundary curves.
  std::size_t number_of_boundaries() const { return mesh_.number_of_hubs; }

  /// what the last computation did.
  const Handle_tunnel_loops::Statistics& statistics() const { return statistics_; }

  /// what has been proved of the result of the last computation.
  const Handle_tunnel_loops::Certificate& certificate() const { return certificate_; }

  /*!
  computes the loops, see `CGAL::handle_tunnel_loops()`. `certificate()` says afterwards what has
  been proved of them, among it where each bounds.

  \tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
    `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag` and
    `Cuda_if_available_tag`. The result is the same.
  \param out an output iterator that accepts `Pair`
  \param np a sequence of named parameters: all of `CGAL::handle_tunnel_loops()` but those that the
    constructor takes, which are not looked at here
  \return `out`, past the last pair written
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
    CGAL_expensive_precondition_msg(halfedges(tm_).size() + 2 * mesh_.number_of_faces_of_caps() ==
                                        mesh_.neighbor.size(),
                                    "the mesh has changed since the solver was made");
    forget_last_run();
    auto visitor = choose_parameter<Default_visitor>(get_parameter(np, internal_np::visitor));
    impl::Progress progress(
        choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
        [&](Stage stage) { unwrapped(visitor).start_stage(stage); },
        [&](Stage stage) { unwrapped(visitor).end_stage(stage); }, statistics_,
        impl::Progress::stages_of_loops());

    const std::vector<Pair> pairs = compute<ConcurrencyTag>(np, progress);
    return std::copy(pairs.begin(), pairs.end(), out);
  }

private:
  friend struct Handle_tunnel_loops::internal::Solver_access;

  using Capped_surface = Handle_tunnel_loops::internal::Capped_surface<Point>;

  // What relates loops and certifies them needs a closed mesh. The index maps, whose types are
  // those of the constructor's parameters, are known to these functions only.

  template <typename VertexIndexMap, typename FaceIndexMap>
  void look_at_closed_surface(VertexIndexMap vertex_index, FaceIndexMap face_index) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    name_and_certify_ = [&tm = tm_, point = point_, vertex_index,
                         face_index](impl::Execution execution, const impl::Class_options& wanted,
                                     std::optional<impl::Loop_relations> relations,
                                     std::vector<Pair>& pairs, impl::Progress& progress) {
      return name_and_certify(
          execution, impl::certification<Pair>(tm, point, vertex_index, face_index, wanted.kind),
          impl::Offset_classifier<TriangleMesh, Vertex_point_map>(tm, point, wanted.offset),
          wanted.do_link, std::move(relations), pairs, pairs, progress);
    };
    relate_ = [&tm = tm_, point = point_,
               vertex_index](impl::Execution execution, const std::vector<Pair>& pairs,
                             const std::vector<std::size_t>& components) {
      return relations(execution, tm, point, vertex_index, pairs, components, {});
    };
  }

  template <typename VertexIndexMap> void look_at_capped_surface(VertexIndexMap vertex_index) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    using Mesh = typename Capped_surface::Mesh;
    // Without handles there is nothing to relate.
    if(mesh_.genus == 0) {
      name_and_certify_ = [](impl::Execution, const impl::Class_options& wanted,
                             std::optional<impl::Loop_relations>, std::vector<Pair>&,
                             impl::Progress& progress) {
        progress.start(Stage::CLASSIFY);
        return Certificate::of_no_loops(wanted.kind, wanted.do_link);
      };
      return;
    }
    const auto capped = std::make_shared<const Capped_surface>(mesh_, vertices_, point_);
    const auto point = capped->mesh().points();
    const auto on_capped = [&tm = tm_, capped, vertex_index](const std::vector<Pair>& pairs) {
      return capped->pairs(pairs, tm, vertex_index);
    };
    name_and_certify_ = [capped, point,
                         on_capped](impl::Execution execution, const impl::Class_options& wanted,
                                    std::optional<impl::Loop_relations> relations,
                                    std::vector<Pair>& pairs, impl::Progress& progress) {
      return name_and_certify(execution, impl::certification_of_capped(*capped, wanted.kind),
                              impl::Offset_classifier<Mesh, std::decay_t<decltype(point)>>(
                                  capped->mesh(), point, wanted.offset),
                              wanted.do_link, std::move(relations), on_capped(pairs), pairs,
                              progress);
    };
    relate_ = [capped, point, on_capped](impl::Execution execution, const std::vector<Pair>& pairs,
                                         const std::vector<std::size_t>& components) {
      return relations(execution, capped->mesh(), point, capped->vertex_index(), on_capped(pairs),
                       components, capped->boundaries());
    };
  }

  void forget_last_run() {
    using namespace Handle_tunnel_loops;
    const double seconds_of_adaptor = statistics_.seconds_of(Stage::ADAPTOR);
    statistics_.seconds.fill(0.);
    statistics_.seconds[static_cast<std::size_t>(Stage::ADAPTOR)] = seconds_of_adaptor;
    statistics_.kept_sweep_tunnels = statistics_.kept_sweep_handles = 0;
    statistics_.swept_handles = statistics_.traced_tunnels = statistics_.refined_handles = 0;
    certificate_ = Certificate();
    statistics_.front_events.clear();
    statistics_.resolution = Field_resolution();
    statistics_.backend.clear();
    statistics_.fallback.clear();
    statistics_.device_bytes = 0;
  }

  template <typename T> static T& unwrapped(T& t) { return t; }
  template <typename T> static T& unwrapped(std::reference_wrapper<T> t) { return t.get(); }

  template <typename NamedParameters, typename Tag>
  static constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

  // Where there is a boundary, the hubs of the caps come last and are no vertices of the caller's.
  template <typename NamedParameters>
  void
  put_swept_vertices([[maybe_unused]] const Handle_tunnel_loops::internal::Swept_vertices& swept,
                     [[maybe_unused]] const NamedParameters& np) const {
    [[maybe_unused]] const std::size_t n = mesh_.number_of_vertices() - mesh_.number_of_hubs;
    if constexpr(is_given<NamedParameters, internal_np::vertex_layer_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_layer_map);
      for(std::size_t v = 0; v < n; ++v)
        put(map, vertices_[v], std::size_t(swept.layers[v]));
    }
    if constexpr(is_given<NamedParameters, internal_np::vertex_value_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_value_map);
      for(std::size_t v = 0; v < n; ++v)
        put(map, vertices_[v], swept.times[v]);
    }
  }

  template <typename NamedParameters>
  static Handle_tunnel_loops::Solver_options solver_options(const NamedParameters& np) {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::solver_options),
                                        Handle_tunnel_loops::Solver_options());
  }

  /// What a computation is asked for.
  struct Request
  {
    Handle_tunnel_loops::internal::Pass_options passes;
    Handle_tunnel_loops::internal::Class_options classes;
    std::vector<Handle_tunnel_loops::internal::Index> seeds; // one in each component
  };

  template <typename NamedParameters> Request request(const NamedParameters& np) const {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const Solver_options options = solver_options(np);
    impl::check_constants(options.field_constants);
    Request request;
    request.passes = {options, is_given<NamedParameters, internal_np::vertex_layer_map_t>,
                      is_given<NamedParameters, internal_np::vertex_value_map_t>};
    request.classes.kind =
        choose_parameter(get_parameter(np, internal_np::basis_kind), Basis_kind::PURE);
    request.classes.do_link = options.do_compute_linking;
    request.classes.do_shorten = options.do_tighten;
    if(options.literal_rules.finite_offset)
      request.classes.offset =
          options.literal_rules.offset * mesh_.in_units_of_caller(impl::mean_edge_length(mesh_));
    request.seeds = seeds(
        choose_parameter(get_parameter(np, internal_np::seed_vertex), Graph_traits::null_vertex()));
    return request;
  }

  template <typename ConcurrencyTag, typename NamedParameters>
  std::vector<Pair> compute(const NamedParameters& np,
                            Handle_tunnel_loops::internal::Progress& progress) {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    const Request wanted = request(np);
    const impl::Pass_options& options = wanted.passes;
    std::vector<impl::Flat_pair> flat_pairs;
    if(mesh_.genus > 0 || options.asks_for_fronts()) {
      const auto passes = impl::Passes_of_tag<ConcurrencyTag>::make(mesh_, wanted.seeds, options);
      impl::Loop_pipeline pipeline(*passes, options, progress);
      if(mesh_.genus > 0)
        flat_pairs = pipeline.run(statistics_);
      else
        pipeline.run_initial_pass(statistics_);
      put_swept_vertices(passes->take_swept_vertices(), np);
    }
    const impl::Execution execution = impl::execution_of<ConcurrencyTag>().watched_by(progress);
    std::optional<impl::Loop_relations> relations;
    if(!flat_pairs.empty()) {
      progress.start(Stage::CLASSES);
      relations = impl::find_right_classes(
          execution, mesh_, wanted.classes,
          [&](const std::vector<impl::Flat_pair>& pairs) {
            return relate_(execution, converted(execution, pairs), components());
          },
          flat_pairs, progress);
      progress.end(Stage::CLASSES);
    }
    progress.start(Stage::CONVERT);
    std::vector<Pair> pairs = converted(execution, flat_pairs);
    progress.end(Stage::CONVERT);
    certificate_ =
        name_and_certify_(execution, wanted.classes, std::move(relations), pairs, progress);
    if(!certificate_)
      throw Uncertified_loops_exception("the loops found fail their certificate: " +
                                        certificate_.failure);
    progress.end(Stage::CLASSIFY);
    return pairs;
  }

  // By the caller's index of the vertices.
  std::vector<std::size_t> components() const {
    const auto& original = mesh_.original;
    std::vector<std::size_t> components(
        (std::max)(std::size_t(num_vertices(tm_)),
                   std::size_t(1) + *std::max_element(original.begin(), original.end())),
        0);
    if(mesh_.seeds.size() > 1)
      for(std::size_t v = 0; v < mesh_.original.size(); ++v)
        components[mesh_.original[v]] = mesh_.component[v];
    return components;
  }

  template <typename Mesh, typename PointMap, typename VertexIndexMap, typename MeshPair>
  static Handle_tunnel_loops::internal::Loop_relations
  relations(Handle_tunnel_loops::internal::Execution execution,
            const Mesh& tm,
            PointMap point,
            VertexIndexMap vertex_index,
            const std::vector<MeshPair>& pairs,
            const std::vector<std::size_t>& components,
            std::vector<std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor>>
                boundaries) {
    namespace impl = Handle_tunnel_loops::internal;
    using Loop = typename MeshPair::Loop;
    std::vector<const Loop*> loops;
    for(const MeshPair& pair : pairs)
      loops.insert(loops.end(), {&pair.handle(), &pair.tunnel()});
    impl::Loop_linker<Mesh, Loop, PointMap, VertexIndexMap> linker(tm, point, vertex_index);
    linker.set_boundaries(std::move(boundaries));
    const auto component = [&](const auto& f) {
      return components[get(vertex_index, target(halfedge(f, tm), tm))];
    };
    linker.set_loops(execution, loops, component,
                     1 + *std::max_element(components.begin(), components.end()));
    linker.link(execution);
    return linker.take_relations();
  }

  // The seed takes the place of its component's own one.
  std::vector<Handle_tunnel_loops::internal::Index> seeds(vertex_descriptor seed) const {
    std::vector<Handle_tunnel_loops::internal::Index> seeds = mesh_.seeds;
    if(seed == Graph_traits::null_vertex())
      return seeds;
    const auto it = std::find(vertices_.begin(), vertices_.end(), seed);
    if(it == vertices_.end())
      throw std::invalid_argument("the seed vertex is isolated or not in the mesh");
    const std::size_t i = it - vertices_.begin();
    seeds[mesh_.component[i]] = static_cast<Handle_tunnel_loops::internal::Index>(i);
    return seeds;
  }

  std::vector<Pair>
  converted(Handle_tunnel_loops::internal::Execution execution,
            const std::vector<Handle_tunnel_loops::internal::Flat_pair>& flat_pairs) const {
    using namespace Handle_tunnel_loops;
    namespace impl = Handle_tunnel_loops::internal;
    const impl::Loop_converter<TriangleMesh, Vertex_point_map, Geom_traits> convert(
        tm_, point_, traits_, vertices_);
    std::vector<Pair> pairs(flat_pairs.size());
    impl::for_each_index(
        execution, pairs.size(),
        [&](std::size_t i) {
          pairs[i] = Pair(convert(flat_pairs[i].handle, Loop_type::HANDLE, i),
                          convert(flat_pairs[i].tunnel, Loop_type::TUNNEL, i));
        },
        1);
    return pairs;
  }

  // The linking numbers that tell handles from tunnels are part of the certificate. The stage that
  // tells them is left to be ended. What is looked at are the same pairs, on a closed surface.
  template <typename Certification, typename Classifier, typename ClosedPair>
  static Handle_tunnel_loops::Certificate
  name_and_certify(Handle_tunnel_loops::internal::Execution execution,
                   Certification certification,
                   const Classifier& classifier,
                   bool do_link,
                   std::optional<Handle_tunnel_loops::internal::Loop_relations> relations,
                   const std::vector<ClosedPair>& closed_pairs,
                   std::vector<Pair>& pairs,
                   Handle_tunnel_loops::internal::Progress& progress) {
    using Handle_tunnel_loops::Stage;
    progress.start(Stage::CERTIFICATE);
    const bool are_closed = certification.are_closed(execution, closed_pairs);
    if(are_closed)
      certification.check_basis(execution);
    progress.end(Stage::CERTIFICATE);
    progress.start(Stage::CLASSIFY);
    if(are_closed) {
      if(relations)
        certification.relate(std::move(*relations));
      else
        certification.relate(execution, do_link);
      classify(execution, certification, classifier, closed_pairs, pairs);
    }
    return certification.finish();
  }

  // Handles and tunnels by their linking numbers, or by their growth along the normals where these
  // do not tell (paper, 4.5).
  template <typename Certification, typename Classifier, typename ClosedPair>
  static void classify(Handle_tunnel_loops::internal::Execution execution,
                       Certification& certification,
                       const Classifier& classifier,
                       const std::vector<ClosedPair>& closed_pairs,
                       std::vector<Pair>& pairs) {
    namespace impl = Handle_tunnel_loops::internal;
    std::vector<char> is_exchanged(pairs.size(), 0);
    impl::for_each_index(
        execution, pairs.size(),
        [&](std::size_t k) {
          int handle = certification.handle_of_pair(k);
          if(handle == 0)
            handle = certification.outward_of_pair(k) *
                     classifier.compare_growth(closed_pairs[k].handle(), closed_pairs[k].tunnel());
          is_exchanged[k] = handle < 0;
        },
        1);
    certification.exchange(is_exchanged);
    for(std::size_t k = 0; k < pairs.size(); ++k)
      if(is_exchanged[k])
        pairs[k] = pairs[k].exchanged();
  }

  const TriangleMesh& tm_;
  Vertex_point_map point_;
  Geom_traits traits_;
  Handle_tunnel_loops::internal::Flat_mesh mesh_;
  std::vector<vertex_descriptor> vertices_; // by index of the flat mesh
  std::function<Handle_tunnel_loops::Certificate(
      Handle_tunnel_loops::internal::Execution,
      const Handle_tunnel_loops::internal::Class_options&,
      std::optional<Handle_tunnel_loops::internal::Loop_relations>,
      std::vector<Pair>&,
      Handle_tunnel_loops::internal::Progress&)>
      name_and_certify_;
  std::function<Handle_tunnel_loops::internal::Loop_relations(
      Handle_tunnel_loops::internal::Execution,
      const std::vector<Pair>&,
      const std::vector<std::size_t>&)>
      relate_;
  Handle_tunnel_loops::Statistics statistics_;
  Handle_tunnel_loops::Certificate certificate_;
};

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_H
