#ifndef HTL_TEST_SHORTEST_CUT_ORACLE_H
#define HTL_TEST_SHORTEST_CUT_ORACLE_H

#include "Homology_coordinates.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

// The length of the shortest cut of a surface of genus 1, for small meshes, slowly.
//
// A shortest cut is three arcs between two vertices p and q, which may be one, with an arc of
// length 0 then. Closed to loops, the differences of the arcs are a basis of the homology. And the
// union of any three paths like that contains a cut. So the shortest one is found by going through
// all p and q, and the shortest paths of each class between them, which are those in the universal
// abelian cover: vertices with the class of the way there.
class Shortest_cut_oracle
{
  using Class = std::pair<int, int>;
  struct Path
  {
    double length;
    Class coordinates;
  };

public:
  explicit Shortest_cut_oracle(const Flat_mesh& mesh)
      : mesh_(mesh)
      , coordinates_(mesh) {}

  // The length of the shortest cut, or `bound` if there is none that is shorter.
  double length(double bound) const {
    for(Index p = 0; p < mesh_.number_of_vertices(); ++p) {
      const std::vector<std::vector<Path>> paths = paths_from(p, bound);
      for(Index q = p; q < mesh_.number_of_vertices(); ++q)
        bound = (std::min)(bound, best_triple(paths[q], bound));
    }
    return bound;
  }

private:
  // By vertex, the shortest path of each class, short ones first.
  std::vector<std::vector<Path>> paths_from(Index p, double bound) const {
    using Place = std::pair<Index, Class>;
    using Entry = std::pair<double, Place>;
    std::vector<std::vector<Path>> paths(mesh_.number_of_vertices());
    std::map<Place, double> distance = {{{p, {0, 0}}, 0.}};
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.push({0., {p, {0, 0}}});
    while(!queue.empty()) {
      const auto [d, place] = queue.top();
      queue.pop();
      if(d > distance.at(place))
        continue;
      const auto [v, c] = place;
      paths[v].push_back({d, c});
      for(const Index u : mesh_.ring(v)) {
        const Class_vector& step = coordinates_[coordinates_.edge(v, u)];
        const Place next = {u, {c.first + step[0], c.second + step[1]}};
        const double sum = d + mesh_.edge_length(v, u);
        const auto it = distance.find(next);
        if(sum < bound && (it == distance.end() || sum < it->second)) {
          distance[next] = sum;
          queue.push({sum, next});
        }
      }
    }
    return paths;
  }

  static bool are_basis(const Class& a, const Class& b, const Class& c) {
    const int x1 = b.first - a.first, y1 = b.second - a.second, x2 = c.first - a.first,
              y2 = c.second - a.second;
    return std::abs(x1 * y2 - y1 * x2) == 1;
  }

  static double best_triple(const std::vector<Path>& paths, double bound) {
    for(std::size_t i = 0; i < paths.size() && 3. * paths[i].length < bound; ++i)
      for(std::size_t j = i + 1; j < paths.size() && paths[i].length + 2. * paths[j].length < bound;
          ++j)
        for(std::size_t k = j + 1; k < paths.size(); ++k) {
          const double sum = paths[i].length + paths[j].length + paths[k].length;
          if(sum >= bound)
            break;
          if(are_basis(paths[i].coordinates, paths[j].coordinates, paths[k].coordinates))
            bound = sum;
        }
    return bound;
  }

  const Flat_mesh& mesh_;
  Homology_coordinates coordinates_;
};

#endif // HTL_TEST_SHORTEST_CUT_ORACLE_H
