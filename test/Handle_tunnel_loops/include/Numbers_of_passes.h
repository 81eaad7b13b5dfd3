#ifndef HTL_TEST_NUMBERS_OF_PASSES_H
#define HTL_TEST_NUMBERS_OF_PASSES_H

#include "Quiet_progress.h"

#include <CGAL/Handle_tunnel_loops/internal/pipeline/Host_backend.h>

#include <vector>

// What a device and the host compute alike, in numbers.
struct Numbers_of_passes
{
  std::vector<double> times;   // of fields from a vertex and from loops
  std::vector<double> ratios;  // where the contours at saddles pass edges
  std::vector<double> lengths; // of fronts
  std::vector<double> walks;   // that the passes for loops find
};

inline Numbers_of_passes
numbers_of_passes(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  Host_backend<Sequential_execution> passes(mesh, step_coefficients({}));
  Quiet_progress progress;
  Numbers_of_passes numbers;
  std::vector<Crossing_loop> contours;
  for(const Handle_candidate& handle : passes.sweep({0}, progress)) {
    contours.push_back(handle.loop);
    for(const Crossing& crossing : handle.loop)
      numbers.ratios.push_back(crossing.ratio);
  }
  numbers.times.assign(passes.arrival_times().begin(), passes.arrival_times().end());
  for(const auto& event : passes.front_log().events)
    for(const auto* fronts : {&event.before, &event.after})
      for(const auto& front : *fronts)
        numbers.lengths.push_back(front.length);
  const Crossing_index index(mesh, contours);
  const std::vector<Time> from_loops = passes.times_from_loops(contours, index);
  numbers.times.insert(numbers.times.end(), from_loops.begin(), from_loops.end());
  std::vector<Index> all(contours.size());
  for(Index k = 0; k < all.size(); ++k)
    all[k] = k;
  passes.search({contours, index, false, all}, progress, [&](Index, const Dual_walks& found) {
    for(const auto& walk : found.walks)
      numbers.walks.insert(numbers.walks.end(), walk.begin(), walk.end());
  });
  return numbers;
}

#endif // HTL_TEST_NUMBERS_OF_PASSES_H
