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

} // namespace device_agreement

#endif // HTL_TEST_PASS_ANSWERS_H
