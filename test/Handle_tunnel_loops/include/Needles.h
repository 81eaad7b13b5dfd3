#ifndef HTL_TEST_NEEDLES_H
#define HTL_TEST_NEEDLES_H

#include "generators/Random.h"
#include "generators/generators.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// The soup with a point on a side of some pairs of triangles, very near to its end.
inline CGAL::Handle_tunnel_loops::generators::Soup
with_needles(CGAL::Handle_tunnel_loops::generators::Soup soup,
             CGAL::Handle_tunnel_loops::generators::Random& random) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> left; // triangle of a side
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
    for(int k = 0; k < 3; ++k)
      left[{soup.triangles[t][k], soup.triangles[t][(k + 1) % 3]}] = t;
  std::vector<bool> is_used(soup.triangles.size(), false);
  for(std::size_t t = 0; t < is_used.size(); ++t) {
    if(is_used[t] || random.below(4) != 0)
      continue;
    const auto [a, b, c] = soup.triangles[t];
    const auto other = left.find({b, a});
    if(other == left.end() || is_used[other->second])
      continue;
    is_used[t] = is_used[other->second] = true;
    std::uint32_t d = 0;
    for(const std::uint32_t v : soup.triangles[other->second])
      if(v != a && v != b)
        d = v;
    const double ratio = std::ldexp(1., -1 - static_cast<int>(random.below(20)));
    const auto m = static_cast<std::uint32_t>(soup.points.size());
    std::array<double, 3> point;
    for(int i = 0; i < 3; ++i)
      point[i] = (1. - ratio) * soup.points[a][i] + ratio * soup.points[b][i];
    soup.points.push_back(point);
    soup.triangles[t] = {a, m, c};
    soup.triangles[other->second] = {m, a, d};
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({b, m, d});
  }
  return soup;
}

#endif // HTL_TEST_NEEDLES_H
