// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces on which loops are shortened, whatever their faces look like.

#ifndef HTL_TEST_SURFACES_FOR_LOOPS_H
#define HTL_TEST_SURFACES_FOR_LOOPS_H

#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// Each calls `f(mesh, seed)`, the seed being one for loops.

template <typename F> void for_each_smooth_surface(const F& f) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    f(flat_mesh_of(recipe), 1u);
  }
}

template <typename F> void for_each_random_surface(const F& f) {
  generators::Random random(2);
  for(unsigned i = 0; i < 100; ++i) {
    const std::size_t genus = random.below(6);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(300), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(testing::PrintToString(recipe));
    f(flat_mesh_of(recipe), i);
  }
}

// With edges without length, and triangles without area.
template <typename F> void for_each_surface_with_coinciding_points(const F& f) {
  for(const double cell : {0.1, 0.5, 1., 10.})
    for(unsigned seed = 0; seed < 10; ++seed) {
      Soup soup = soup_of({"random", {60, 4, seed}});
      for(auto& point : soup.points)
        for(double& x : point)
          x = cell * std::floor(x / cell);
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", points of a grid of width " << cell);
      f(flat_mesh_of(soup), seed);
    }
}

#endif // HTL_TEST_SURFACES_FOR_LOOPS_H
