#ifndef BENCHMARK_CORPUS_REFERENCE_H
#define BENCHMARK_CORPUS_REFERENCE_H

#include "Corpus_answer.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Initial_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>

#include <cmath>
#include <cstdio>

/// \file Corpus_reference.h
/// What the host solver and the reference solver have in common on the meshes of a folder.

namespace corpus {

/// By how many steps arrival times are later than those of the narrow band of the host solver.
struct Lateness
{
  double largest_of_single_field = 0.; ///< either way
  double largest_of_layers = 0., mean_of_layers = 0.;
};

inline Lateness lateness(const Mesh& mesh) {
  namespace impl = HTL::internal;
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  const impl::Flat_mesh flat =
      impl::Flat_mesh_builder<Mesh, std::decay_t<decltype(index)>, std::decay_t<decltype(point)>>(
          impl::Execution(), mesh, index, point)
          .build();
  const HTL::Field_constants constants;
  impl::Host_backend backend(impl::Execution(), flat);
  backend.initial_field(flat.seeds, impl::step_coefficients(constants),
                        [](double) { return true; });
  const std::vector<impl::Time> times = backend.arrival_times();
  impl::reference::Single_field field(flat, constants, {});
  for(const impl::Index seed : flat.seeds) {
    field.add_source(seed);
    for(const impl::Index u : flat.ring(seed))
      field.add_source(u);
  }
  field.run_until(std::vector<char>(times.size(), 0));
  impl::reference::Initial_pass layers(flat, constants, flat.seeds);
  while(!layers.is_done())
    layers.step();
  Lateness late;
  for(impl::Index v = 0; v < times.size(); ++v) {
    const double time = double(times[v]) / impl::ticks_per_step;
    const double of_layers = layers.arrivals().time(v) - time;
    late.largest_of_single_field =
        (std::max)(late.largest_of_single_field, std::abs(field.arrivals().time(v) - time));
    late.largest_of_layers = (std::max)(late.largest_of_layers, std::abs(of_layers));
    late.mean_of_layers += of_layers / double(times.size());
  }
  return late;
}

/// whether no loop of one type crosses one of the same type of the other answer, counted with sign.
inline bool do_not_cross(const Mesh& mesh, const Pairs& a, const Pairs& b, CGAL::Loop_type type) {
  namespace impl = HTL::internal;
  using Loop = Solver::Pair::Loop;
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  std::vector<const Loop*> loops;
  for(const Pairs* pairs : {&a, &b})
    for(const auto& pair : *pairs)
      loops.push_back(&pair.loop(type));
  impl::Loop_linker<Mesh, Loop, std::decay_t<decltype(point)>, std::decay_t<decltype(index)>>
      linker(mesh, point, index);
  linker.set_loops(
      impl::Execution(), loops, [](const auto&) { return std::size_t(0); }, 1);
  linker.intersect(impl::Execution());
  const impl::Loop_relations relations = linker.take_relations();
  for(const auto& e : relations.intersections)
    if((e.row < a.size()) != (e.column < a.size()) && e.value != 0)
      return false;
  return true;
}

/// The sums over the meshes on which the reference solver was run.
class Reference_sums
{
public:
  /// runs the reference solver from each seed, and compares its first answer with that of the host.
  void add(const Mesh& mesh, Solver& solver, const Answer& host, std::size_t number_of_seeds) {
    ++meshes_;
    pairs_ += host.pairs.size();
    Answer first = answer_of<CGAL::Reference_tag>(solver, CGAL::parameters::default_values());
    count_certified(first);
    if(number_of_seeds > 1)
      for(const auto seed : spaced_seeds(mesh, number_of_seeds))
        count_certified(
            answer_of<CGAL::Reference_tag>(solver, CGAL::parameters::seed_vertex(seed)));
    if(first.error.empty())
      compare(mesh, host, first);
  }

  void print() const {
    std::printf("\nReference solver, %zu meshes, %zu pairs of loops\n", meshes_, pairs_);
    std::printf("certified answers: %zu of %zu\n", certified_, answers_);
    std::printf("meshes that break an assumption: %zu (handles within a step %zu, rests %zu, early "
                "vertices %zu, events beside the seed %zu)\n",
                unresolved_, within_steps_, rests_, early_, at_seed_);
    std::printf("tunnels kept from the initial pass: %zu; handles refined: %zu\n", kept_tunnels_,
                pairs_ - kept_handles_);
    std::printf("loops that bound, host: %zu handles, %zu tunnels; reference: %zu, %zu\n",
                bound_[0], bound_[1], bound_[2], bound_[3]);
    std::printf("same classes: %zu meshes; all loops of both bound: %zu, of these same classes: "
                "%zu\n",
                same_classes_, pure_, pure_and_same_);
    std::printf("length over that of the host: median %.2f, 90%% %.2f, least %.2f, most %.2f\n",
                quantile(ratios_, 0.5), quantile(ratios_, 0.9), quantile(ratios_, 0.),
                quantile(ratios_, 1.));
    const auto up_to = [this](double bound) {
      return std::count_if(single_.begin(), single_.end(), [=](double d) { return d <= bound; });
    };
    std::printf("arrival times, single field against narrow band: up to 0.03 steps apart on %td "
                "meshes, up to 0.52 on %td, most %.2f\n",
                up_to(0.03), up_to(0.52), quantile(single_, 1.));
    std::printf("arrival times of the layers: mean lateness, median of the meshes %.3f, 90%% %.3f; "
                "largest, median %.2f, 90%% %.2f\n",
                quantile(mean_of_layers_, 0.5), quantile(mean_of_layers_, 0.9),
                quantile(largest_of_layers_, 0.5), quantile(largest_of_layers_, 0.9));
    std::printf("one thread, first seed: %.1f s in all, longest %.1f s; host solver %.2f s\n",
                quantile(seconds_, 1.) > 0. ? total_seconds_ : 0., quantile(seconds_, 1.),
                host_seconds_);
  }

private:
  void count_certified(const Answer& answer) {
    ++answers_;
    certified_ += answer.error.empty();
  }

  void compare(const Mesh& mesh, const Answer& host, const Answer& reference) {
    const HTL::Field_resolution& r = reference.statistics.resolution;
    unresolved_ += !r.is_resolved();
    within_steps_ += r.handles_within_steps != 0;
    rests_ += r.rests != 0;
    early_ += r.early_vertices != 0;
    at_seed_ += r.events_in_seed_region != 0;
    kept_tunnels_ += reference.statistics.kept_sweep_tunnels;
    kept_handles_ += reference.statistics.kept_sweep_handles;
    bound_[0] += host.handles_inside();
    bound_[1] += host.tunnels_outside();
    bound_[2] += reference.handles_inside();
    bound_[3] += reference.tunnels_outside();
    const bool is_same = do_not_cross(mesh, host.pairs, reference.pairs, CGAL::Loop_type::HANDLE) &&
                         do_not_cross(mesh, host.pairs, reference.pairs, CGAL::Loop_type::TUNNEL);
    const bool is_pure = host.is_pure() && reference.is_pure();
    same_classes_ += is_same;
    pure_ += is_pure;
    pure_and_same_ += is_pure && is_same;
    const auto a = host.lengths(), b = reference.lengths();
    ratios_.push_back((b[0] + b[1]) / (a[0] + a[1]));
    const Lateness late = lateness(mesh);
    single_.push_back(late.largest_of_single_field);
    largest_of_layers_.push_back(late.largest_of_layers);
    mean_of_layers_.push_back(late.mean_of_layers);
    seconds_.push_back(reference.seconds);
    total_seconds_ += reference.seconds;
    host_seconds_ += host.seconds;
  }

  std::size_t meshes_ = 0, pairs_ = 0, answers_ = 0, certified_ = 0;
  std::size_t unresolved_ = 0, within_steps_ = 0, rests_ = 0, early_ = 0, at_seed_ = 0;
  std::size_t kept_tunnels_ = 0, kept_handles_ = 0;
  std::size_t same_classes_ = 0, pure_ = 0, pure_and_same_ = 0;
  std::array<std::size_t, 4> bound_{}; // handles and tunnels of the host, and of the reference
  std::vector<double> ratios_, single_, largest_of_layers_, mean_of_layers_, seconds_;
  double total_seconds_ = 0., host_seconds_ = 0.;
};

} // namespace corpus

#endif // BENCHMARK_CORPUS_REFERENCE_H
