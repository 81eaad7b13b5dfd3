#ifndef HTL_TEST_RANDOM_GROWTH_H
#define HTL_TEST_RANDOM_GROWTH_H

#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using CGAL::Handle_tunnel_loops::internal::never;
using CGAL::Handle_tunnel_loops::internal::Time;

// Vertices are reached one after the other, each of them beside one that was reached before.
class Random_growth
{
public:
  Random_growth(const Flat_mesh& mesh, generators::Random& random, std::size_t width)
      : time_(mesh.number_of_vertices(), never) {
    std::vector<Index> front(1, static_cast<Index>(random.below(mesh.number_of_vertices())));
    for(Time now = 0; !front.empty();) {
      // One of the `width` oldest of the front.
      const std::size_t i = random.below((std::min)(width, front.size()));
      const Index v = front[i];
      front.erase(front.begin() + static_cast<std::ptrdiff_t>(i));
      if(time_[v] != never)
        continue;
      time_[v] = now++;
      for(const Index u : mesh.ring(v))
        if(time_[u] == never)
          front.push_back(u);
    }
  }

  const std::vector<Time>& times() const { return time_; }

private:
  std::vector<Time> time_;
};

#endif // HTL_TEST_RANDOM_GROWTH_H
