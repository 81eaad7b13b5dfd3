// Boxes that meet a given one, by looking at each.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_sorted_boxes {

using CGAL::Handle_tunnel_loops::generators::Random;
using namespace CGAL::Handle_tunnel_loops::internal;

template <std::size_t d> Box<d> random_box(Random& random) {
  Box<d> box;
  for(std::size_t k = 0; k < d; ++k) {
    box.low[k] = random.uniform(0., 1.);
    box.high[k] = box.low[k] + 0.1 * random.uniform(0., 1.);
  }
  return box;
}

template <std::size_t d> void expect_those_that_meet(std::size_t number) {
  Random random(number + d);
  std::vector<Box<d>> boxes;
  for(std::size_t i = 0; i < number; ++i)
    boxes.push_back(random_box<d>(random));
  const Sorted_boxes<d> sorted(Execution(), boxes);
  for(int i = 0; i < 50; ++i) {
    const Box<d> box = random_box<d>(random);
    std::vector<char> is_met(number, 0);
    sorted.for_each_meeting(box, [&](Index k, const Box<d>& b) {
      EXPECT_EQ(b.low, boxes[k].low);
      is_met[k] = 1;
    });
    bool is_any = false;
    for(std::size_t k = 0; k < number; ++k) {
      EXPECT_EQ(is_met[k] != 0, boxes[k].meets(box));
      is_any = is_any || is_met[k] != 0;
    }
    EXPECT_EQ(sorted.any_meeting(box, [](Index, const Box<d>&) { return true; }), is_any);
  }
}

TEST(Sorted_boxes, AreThoseThatMeet) {
  for(const std::size_t number : {0, 1, 2, 5, 300}) {
    expect_those_that_meet<2>(number);
    expect_those_that_meet<3>(number);
  }
}

} // namespace test_sorted_boxes
