#ifndef HTL_TEST_PASS_ANSWERS_H
#define HTL_TEST_PASS_ANSWERS_H

#include "Device_agreement.h"

#include <tuple>
#include <vector>

namespace device_agreement {

// What all passes find on a mesh of one handle.
struct Answers
{
  std::vector<Handle_candidate> handles;
  std::vector<Time> times, times_from_loops, times_from_vertices;
  std::vector<Index> layers;
  std::vector<std::vector<Index>> walks;

  bool operator==(const Answers& other) const {
    return std::tie(handles, times, times_from_loops, times_from_vertices, layers, walks) ==
           std::tie(other.handles, other.times, other.times_from_loops, other.times_from_vertices,
                    other.layers, other.walks);
  }
};

// All of it, by any backend.
template <typename Backend> Answers answers_of(Backend& backend, const Flat_mesh& mesh) {
  const Step_coefficients k = step_coefficients({}), searching = coefficients_for_searching(k);
  Answers answers;
  answers.handles = backend.initial_field({0}, k, go_on);
  answers.layers = backend.front_log().layer;
  const std::vector<Crossing_loop> contours = loops_of(answers.handles);
  const Crossing_index index(mesh, contours);
  answers.times_from_loops = backend.times_from_loops(contours, index, searching);
  answers.times_from_vertices = backend.times_from_vertices({5, 6, 40}, k, go_on);
  for(const bool bars_only_own : {false, true})
    for(const Dual_walks& found :
        backend.dual_walks({contours, index, bars_only_own, {0}}, searching, go_on))
      answers.walks.insert(answers.walks.end(), found.walks.begin(), found.walks.end());
  answers.times = backend.arrival_times();
  return answers;
}

} // namespace device_agreement

#endif // HTL_TEST_PASS_ANSWERS_H
