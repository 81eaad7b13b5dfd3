#ifndef HTL_TEST_SHORTEST_BASIS_ORACLE_H
#define HTL_TEST_SHORTEST_BASIS_ORACLE_H

#include "Homology_coordinates.h"
#include "Integer_span.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

// Shortest bases of the first homology group by loops along edges, and of the classes in it that
// bound on one side; for small meshes, slowly.

// A class, up to its sign, and the length of a loop of it.
struct Class_length
{
  Class_vector coordinates;
  double length;
};
using Class_lengths = std::vector<Class_length>;

inline double total_length(const Class_lengths& family) {
  double sum = 0.;
  for(const Class_length& c : family)
    sum += c.length;
  return sum;
}

inline Integer_matrix matrix_of(const Class_lengths& family) {
  Integer_matrix matrix;
  for(const Class_length& c : family)
    matrix.emplace_back(c.coordinates.begin(), c.coordinates.end());
  return matrix;
}

// The classes x with x M = 0, for an integer matrix M.
class Kernel_of_matrix
{
public:
  explicit Kernel_of_matrix(const Integer_matrix& m) {
    for(const auto& row : m) {
      rows_.emplace_back();
      for(const Integer& x : row)
        rows_.back().push_back(static_cast<int>(x));
    }
  }

  Class_vector image(const Class_vector& x) const {
    Class_vector result(rows_.front().size(), 0);
    for(std::size_t i = 0; i < x.size(); ++i)
      if(x[i] != 0)
        Homology_coordinates::add(rows_[i], x[i], result);
    return result;
  }

private:
  std::vector<Class_vector> rows_;
};

inline bool is_zero(const Class_vector& x) {
  return std::all_of(x.begin(), x.end(), [](int c) { return c == 0; });
}

class Shortest_basis_oracle
{
public:
  explicit Shortest_basis_oracle(const Flat_mesh& mesh)
      : mesh_(mesh)
      , coordinates_(mesh) {}

  const Homology_coordinates& coordinates() const { return coordinates_; }
  std::size_t rank() const { return coordinates_.rank(); }

  // The optimum over a field (Erickson and Whittlesey): of all loops that go along a tree of
  // shortest paths, an edge, and back along the tree, the shortest ones that are independent. If it
  // is saturated it is the optimum over the integers.
  Class_lengths shortest_basis() const {
    Lengths all;
    for(Index root = 0; root < mesh_.number_of_vertices(); ++root)
      insert(cycles_through(root), all);
    return independent(all);
  }

  // The same, of one tree alone.
  Class_lengths basis_of_tree(Index root) const { return independent(cycles_through(root)); }

  // Of the classes of a kernel, the best found: such loops in the kernel, and one of them followed
  // by multiples of another from the same root. There may be less than a basis.
  Class_lengths best_found(const Kernel_of_matrix& kernel) const {
    Lengths all;
    for(Index root = 0; root < mesh_.number_of_vertices(); ++root) {
      std::map<Class_vector, std::vector<Multiple>> by_direction;
      for(const auto& [x, length] : cycles_through(root)) {
        Class_vector image = kernel.image(x);
        if(is_zero(image)) {
          insert(x, length, all);
          continue;
        }
        const int factor = divide_by_factor(image);
        by_direction[image].push_back({{x, length}, factor});
      }
      for(const auto& item : by_direction)
        insert_differences(item.second, all);
    }
    return independent(all);
  }

  // The optimum over the integers of the classes of a kernel, which has the given basis: by way of
  // all classes below a length that no loop of a shorter basis exceeds.
  Class_lengths optimum(const Kernel_of_matrix& kernel, const Class_lengths& basis) const {
    if(basis.empty() || !is_saturated(matrix_of(basis)))
      throw std::logic_error("an optimum is looked for below the length of a basis");
    const double longest = std::max_element(basis.begin(), basis.end(), is_shorter)->length;
    const double shortest = kernel_classes_below(kernel, longest).front().length;
    const double bound = total_length(basis) - double(basis.size() - 1) * shortest;
    const Class_lengths sorted = kernel_classes_below(kernel, bound);
    Class_lengths best = basis, chosen;
    double best_length = total_length(basis);
    choose(sorted, 0, basis.size(), 0., chosen, best_length, best);
    return best;
  }

private:
  using Lengths = std::map<Class_vector, double>; // by class with a positive first coordinate

  static bool is_shorter(const Class_length& a, const Class_length& b) {
    return a.length < b.length;
  }

  static Class_vector negative(Class_vector x) {
    for(int& c : x)
      c = -c;
    return x;
  }
  static Class_vector with_first_positive(const Class_vector& x) {
    const auto first = std::find_if(x.begin(), x.end(), [](int c) { return c != 0; });
    return first != x.end() && *first < 0 ? negative(x) : x;
  }

  static void insert(const Class_vector& x, double length, Lengths& lengths) {
    if(is_zero(x))
      return;
    const auto [it, is_new] = lengths.emplace(with_first_positive(x), length);
    if(!is_new)
      it->second = (std::min)(it->second, length);
  }
  static void insert(const Lengths& some, Lengths& lengths) {
    for(const auto& [x, length] : some)
      insert(x, length, lengths);
  }

  // A class whose image is a multiple of some vector.
  struct Multiple
  {
    Class_length item;
    int factor;
  };

  static int divide_by_factor(Class_vector& x) {
    int factor = 0;
    for(const int c : x)
      factor = std::gcd(factor, c);
    if(with_first_positive(x) != x)
      factor = -factor;
    for(int& c : x)
      c /= factor;
    return factor;
  }

  static void insert_differences(const std::vector<Multiple>& multiples, Lengths& lengths) {
    for(const Multiple& a : multiples)
      for(const Multiple& b : multiples)
        if(&a != &b && a.factor % b.factor == 0) {
          const int times = a.factor / b.factor;
          Class_vector difference = a.item.coordinates;
          Homology_coordinates::add(b.item.coordinates, -times, difference);
          insert(difference, a.item.length + std::abs(times) * b.item.length, lengths);
        }
  }

  static Class_lengths sorted_by_length(const Lengths& lengths) {
    Class_lengths sorted;
    for(const auto& [x, length] : lengths)
      sorted.push_back({x, length});
    std::stable_sort(sorted.begin(), sorted.end(), is_shorter);
    return sorted;
  }

  static Class_lengths independent(const Lengths& lengths) {
    Class_lengths result;
    Independence independence;
    for(const Class_length& c : sorted_by_length(lengths))
      if(independence.add(c.coordinates))
        result.push_back(c);
    return result;
  }

  // Shortest paths from a root, with the sum of the coordinates along each.
  struct Tree
  {
    std::vector<double> distance;
    std::vector<Class_vector> sum;
    std::vector<Index> parent;
  };

  Tree tree_from(Index root) const {
    const std::size_t n = mesh_.number_of_vertices();
    Tree tree = {std::vector<double>(n, std::numeric_limits<double>::infinity()),
                 std::vector<Class_vector>(n, Class_vector(rank(), 0)),
                 std::vector<Index>(n, root)};
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    tree.distance[root] = 0.;
    queue.emplace(0., root);
    while(!queue.empty()) {
      const auto [d, u] = queue.top();
      queue.pop();
      if(d > tree.distance[u])
        continue;
      for(const Index v : mesh_.ring(u))
        if(const double length = d + mesh_.edge_length(u, v); length < tree.distance[v]) {
          tree.distance[v] = length;
          tree.parent[v] = u;
          tree.sum[v] = tree.sum[u];
          Homology_coordinates::add(coordinates_[coordinates_.edge(u, v)], 1, tree.sum[v]);
          queue.emplace(length, v);
        }
    }
    return tree;
  }

  Lengths cycles_through(Index root) const {
    const Tree tree = tree_from(root);
    Lengths lengths;
    for(Index u = 0; u < mesh_.number_of_vertices(); ++u)
      for(const Index v : mesh_.ring(u)) {
        if(v < u || tree.parent[u] == v || tree.parent[v] == u)
          continue;
        Class_vector sum = tree.sum[u];
        Homology_coordinates::add(coordinates_[coordinates_.edge(u, v)], 1, sum);
        Homology_coordinates::add(tree.sum[v], -1, sum);
        insert(sum, tree.distance[u] + mesh_.edge_length(u, v) + tree.distance[v], lengths);
      }
    return lengths;
  }

  // The shortest loop of each class of a kernel that has one so short: from each root to all places
  // in the covering surface from which there is a way back in time.
  Class_lengths kernel_classes_below(const Kernel_of_matrix& kernel, double bound) const {
    Lengths lengths;
    for(Index root = 0; root < mesh_.number_of_vertices(); ++root)
      insert_classes_through(root, (1. + 1e-9) * bound, lengths);
    Class_lengths sorted = sorted_by_length(lengths);
    sorted.erase(std::remove_if(
                     sorted.begin(), sorted.end(),
                     [&](const Class_length& c) { return !is_zero(kernel.image(c.coordinates)); }),
                 sorted.end());
    return sorted;
  }

  void insert_classes_through(Index root, double bound, Lengths& lengths) const {
    const std::vector<double> way_back = tree_from(root).distance;
    using Place = std::pair<Class_vector, Index>;
    using Entry = std::pair<double, Place>;
    std::map<Place, double> distance;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](double d, const Place& place) {
      if(d + way_back[place.second] > bound)
        return;
      const auto [it, is_new] = distance.emplace(place, d);
      if(is_new || d < it->second) {
        it->second = d;
        queue.emplace(d, place);
      }
    };
    reach(0., {Class_vector(rank(), 0), root});
    while(!queue.empty()) {
      const auto [d, place] = queue.top();
      queue.pop();
      const auto& [sum, u] = place;
      if(d > distance.at(place))
        continue;
      if(u == root)
        insert(sum, d, lengths);
      for(const Index v : mesh_.ring(u)) {
        Class_vector next = sum;
        Homology_coordinates::add(coordinates_[coordinates_.edge(u, v)], 1, next);
        reach(d + mesh_.edge_length(u, v), {std::move(next), v});
      }
    }
  }

  // All families of so many of the sorted classes that may be shorter than the best.
  static void choose(const Class_lengths& sorted,
                     std::size_t first,
                     std::size_t number,
                     double length,
                     Class_lengths& chosen,
                     double& best_length,
                     Class_lengths& best) {
    if(chosen.size() == number) {
      if(length < best_length && is_saturated(matrix_of(chosen))) {
        best_length = length;
        best = chosen;
      }
      return;
    }
    for(std::size_t i = first; i < sorted.size(); ++i) {
      if(length + double(number - chosen.size()) * sorted[i].length >= best_length)
        return;
      chosen.push_back(sorted[i]);
      choose(sorted, i + 1, number, length + sorted[i].length, chosen, best_length, best);
      chosen.pop_back();
    }
  }

  const Flat_mesh& mesh_;
  Homology_coordinates coordinates_;
};

#endif // HTL_TEST_SHORTEST_BASIS_ORACLE_H
