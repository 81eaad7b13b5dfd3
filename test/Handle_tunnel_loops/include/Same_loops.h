#ifndef HTL_TEST_SAME_LOOPS_H
#define HTL_TEST_SAME_LOOPS_H

#include "Meshes_of_soups.h"

#include <gtest/gtest.h>

// Equal bit for bit: steps, points, length, type and place in the output.
inline bool are_same(const Pairs::value_type::Loop& a, const Pairs::value_type::Loop& b) {
  if(a.size() != b.size() || a.points() != b.points() || a.length() != b.length() ||
     a.type() != b.type() || a.pair_index() != b.pair_index())
    return false;
  for(std::size_t i = 0; i < a.size(); ++i)
    if(a.steps()[i].halfedge != b.steps()[i].halfedge || a.steps()[i].ratio != b.steps()[i].ratio)
      return false;
  return true;
}

inline void expect_same(const Pairs& a, const Pairs& b) {
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_TRUE(are_same(a[k].handle(), b[k].handle())) << "handle loop of pair " << k;
    EXPECT_TRUE(are_same(a[k].tunnel(), b[k].tunnel())) << "tunnel loop of pair " << k;
  }
}

#endif // HTL_TEST_SAME_LOOPS_H
