// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classes of closed walks on surfaces with boundary, told exactly and by numbers, as another way of
// collapsing the surface tells them.

#include "Changed_loops.h"
#include "Homology_by_collapse.h"
#include "Number_of_cases.h"

#include "generators/Random.h"
#include "generators/generators.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Class_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Cover_places.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace test_class_numbers {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;

// Through a few places.
Walk random_walk(const Mesh& mesh, Random& random) {
  const auto any = [&] {
    return Mesh::Vertex_index(
        static_cast<Mesh::size_type>(random.below(mesh.number_of_vertices())));
  };
  const Mesh::Vertex_index first = any();
  Mesh::Vertex_index last = first;
  Walk walk;
  for(int i = 0; i < 4; ++i) {
    const Mesh::Vertex_index next = i == 3 ? first : any();
    const Walk part = path(mesh, last, next);
    walk.insert(walk.end(), part.begin(), part.end());
    last = next;
  }
  return walk;
}

TEST(Class_numbers, AreOfClasses) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 2)) {
    SCOPED_TRACE(recipe);
    generators::Hole_request holes;
    holes.number = 1 + random.below(5);
    holes.faces = 1 + random.below(60);
    holes.may_be_fewer = true;
    const Mesh mesh = mesh_of(generators::with_holes(soup_of(recipe), holes));
    const Prepared_surface surface(Execution(), mesh, get(boost::vertex_index, mesh),
                                   get(CGAL::vertex_point, mesh));
    const Class_numbers numbers(Execution(), surface.mesh);
    const Homology_by_collapse<Mesh> homology(mesh);
    const auto on_arrays = [&](const Walk& walk) {
      std::vector<Index> vertices;
      for(const Mesh::Halfedge_index h : walk)
        vertices.push_back(surface.index_of(mesh.source(h)));
      return vertices;
    };
    for(int i = 0; i < number_of_cases(50); ++i) {
      const Walk a = random_walk(mesh, random), b = random_walk(mesh, random);
      if(a.empty() || b.empty())
        continue;
      const std::pair<Walk, Walk> pairs[] = {{a, b}, {sum(mesh, a, b), sum(mesh, b, a)}};
      for(const auto& [x, y] : pairs) {
        const bool are_equal = homology.coordinates(x) == homology.coordinates(y);
        EXPECT_EQ(numbers.are_homologous(on_arrays(x), on_arrays(y)), are_equal);
        EXPECT_EQ(numbers.of_walk(on_arrays(x)) == numbers.of_walk(on_arrays(y)), are_equal);
      }
    }
  }
}

TEST(Cover_places, AreFoundAsTheyWereAdded) {
  Random random(2);
  Cover_places places(8);
  for(int round = 0; round < 20; ++round) {
    std::map<std::pair<Index, std::uint64_t>, Index> expected;
    while(expected.size() < 256) {
      const auto vertex = static_cast<Index>(random.below(20));
      const std::uint64_t number = random.below(30) - std::uint64_t(15);
      const auto [it, is_new] = expected.emplace(std::make_pair(vertex, number), no_index);
      EXPECT_EQ(places.find({vertex, number}), it->second);
      if(is_new) {
        it->second = static_cast<Index>(places.size());
        places.add({vertex, number});
      }
    }
    places.clear();
    EXPECT_EQ(places.find({expected.begin()->first.first, expected.begin()->first.second}),
              no_index);
  }
}

} // namespace test_class_numbers
