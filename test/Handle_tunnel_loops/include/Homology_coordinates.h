#ifndef HTL_TEST_HOMOLOGY_COORDINATES_H
#define HTL_TEST_HOMOLOGY_COORDINATES_H

#include "Flat_mesh_of_soup.h"

#include <cstddef>
#include <vector>

// An integer vector for each homology class, by a tree of edges and a tree of faces: the edges that
// are in the one and not crossed by the other are 2g. Each of them closes a loop through the faces,
// and these loops are a basis. The coordinates of a closed walk are how often it crosses them.

using Class_vector = std::vector<int>;

class Homology_coordinates
{
public:
  explicit Homology_coordinates(const Flat_mesh& mesh)
      : mesh_(mesh)
      , face_at_left_(mesh.neighbor.size())
      , is_in_tree_(mesh.neighbor.size(), 0)
      , rank_(2 * mesh.genus)
      , classes_(mesh.neighbor.size(), Class_vector(rank_, 0)) {
    number_faces();
    grow_tree();
    grow_cotree();
    std::size_t number = 0;
    for(Index u = 0; u < mesh.number_of_vertices(); ++u)
      for(Index h = mesh.row_begin[u]; h < mesh.row_begin[u + 1]; ++h)
        if(u < mesh.neighbor[h] && !is_in_tree_[h] && !is_in_cotree(h) &&
           !is_in_cotree(opposite(h)))
          add_dual_loop(h, number++);
  }

  std::size_t rank() const { return rank_; }

  // The number of the directed edge from u to v.
  Index edge(Index u, Index v) const { return mesh_.row_begin[u] + mesh_.ring(u).position(v); }

  const Class_vector& operator[](Index edge) const { return classes_[edge]; }

  Class_vector of(const std::vector<Index>& closed_walk) const {
    Class_vector sum(rank_, 0);
    for(std::size_t i = 0; i < closed_walk.size(); ++i)
      add(classes_[edge(closed_walk[i], closed_walk[(i + 1) % closed_walk.size()])], 1, sum);
    return sum;
  }

  static void add(const Class_vector& a, int factor, Class_vector& sum) {
    for(std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += factor * a[i];
  }

private:
  Index opposite(Index h) const { return opposite_[h]; }

  void number_faces() {
    opposite_.resize(mesh_.neighbor.size());
    for(Index u = 0; u < mesh_.number_of_vertices(); ++u)
      for(Index h = mesh_.row_begin[u]; h < mesh_.row_begin[u + 1]; ++h) {
        const Index v = mesh_.neighbor[h], w = mesh_.ring(u).after(v);
        opposite_[h] = edge(v, u);
        if(u < v && u < w) {
          face_at_left_[h] = face_at_left_[edge(v, w)] = face_at_left_[edge(w, u)] =
              number_of_faces_++;
        }
      }
  }

  void grow_tree() {
    std::vector<char> is_reached(mesh_.number_of_vertices(), 0);
    std::vector<Index> queue(1, 0);
    is_reached[0] = 1;
    for(std::size_t q = 0; q < queue.size(); ++q)
      for(const Index v : mesh_.ring(queue[q]))
        if(!is_reached[v]) {
          is_reached[v] = 1;
          is_in_tree_[edge(queue[q], v)] = is_in_tree_[edge(v, queue[q])] = 1;
          queue.push_back(v);
        }
  }

  // By face, the edge with this face to its left through which it was reached.
  void grow_cotree() {
    std::vector<std::vector<Index>> edges_around(number_of_faces_);
    for(Index h = 0; h < face_at_left_.size(); ++h)
      edges_around[face_at_left_[h]].push_back(h);
    entrance_.assign(number_of_faces_, no_edge);
    std::vector<char> is_reached(number_of_faces_, 0);
    std::vector<Index> queue(1, 0);
    is_reached[0] = 1;
    for(std::size_t q = 0; q < queue.size(); ++q)
      for(const Index h : edges_around[queue[q]]) {
        const Index f = face_at_left_[opposite(h)];
        if(is_in_tree_[h] || is_reached[f])
          continue;
        is_reached[f] = 1;
        entrance_[f] = opposite(h);
        queue.push_back(f);
      }
  }

  bool is_in_cotree(Index h) const { return entrance_[face_at_left_[h]] == h; }

  // From the root to the right of h, across h, and back.
  void add_dual_loop(Index h, std::size_t number) {
    cross(h, 1, number);
    add_path(face_at_left_[opposite(h)], 1, number);
    add_path(face_at_left_[h], -1, number);
  }
  void add_path(Index face, int factor, std::size_t number) {
    for(; entrance_[face] != no_edge; face = face_at_left_[opposite(entrance_[face])])
      cross(entrance_[face], factor, number);
  }
  void cross(Index h, int factor, std::size_t number) {
    classes_[h][number] += factor;
    classes_[opposite(h)][number] -= factor;
  }

  static constexpr Index no_edge = Index(-1);

  const Flat_mesh& mesh_;
  std::vector<Index> opposite_, face_at_left_, entrance_;
  std::vector<char> is_in_tree_;
  Index number_of_faces_ = 0;
  std::size_t rank_;
  std::vector<Class_vector> classes_; // by directed edge
};

#endif // HTL_TEST_HOMOLOGY_COORDINATES_H
