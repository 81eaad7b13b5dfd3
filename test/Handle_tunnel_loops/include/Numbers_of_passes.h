#ifndef HTL_TEST_NUMBERS_OF_PASSES_H
#define HTL_TEST_NUMBERS_OF_PASSES_H

#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>

#include <numeric>
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
  Host_backend backend(Execution(), mesh);
  const Step_coefficients k = step_coefficients({}), searching = coefficients_for_searching(k);
  const Callback go_on = [](double) { return true; };
  Numbers_of_passes numbers;
  std::vector<Crossing_loop> contours;
  for(const Handle_candidate& handle : backend.initial_field({0}, k, go_on)) {
    contours.push_back(handle.loop);
    for(const Crossing& crossing : handle.loop)
      numbers.ratios.push_back(crossing.ratio);
  }
  const std::vector<Time> times = backend.arrival_times();
  numbers.times.assign(times.begin(), times.end());
  for(const auto& event : backend.front_log().events)
    for(const auto* fronts : {&event.before, &event.after})
      for(const auto& front : *fronts)
        numbers.lengths.push_back(front.length);
  const Crossing_index index(mesh, contours);
  const std::vector<Time> from_loops = backend.times_from_loops(contours, index, searching);
  numbers.times.insert(numbers.times.end(), from_loops.begin(), from_loops.end());
  std::vector<Index> all(contours.size());
  std::iota(all.begin(), all.end(), Index(0));
  for(const Dual_walks& found : backend.dual_walks({contours, index, false, all}, searching, go_on))
    for(const auto& walk : found.walks)
      numbers.walks.insert(numbers.walks.end(), walk.begin(), walk.end());
  return numbers;
}

#endif // HTL_TEST_NUMBERS_OF_PASSES_H
