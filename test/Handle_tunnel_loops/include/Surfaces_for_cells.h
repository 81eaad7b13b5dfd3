#ifndef HTL_TEST_SURFACES_FOR_CELLS_H
#define HTL_TEST_SURFACES_FOR_CELLS_H

#include "Flat_mesh_of_soup.h"
#include "Meshes_of_soups.h"

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// Surfaces of all kinds for coarse meshes, and whether two of these are the same.

namespace surfaces_for_cells {

using namespace CGAL::Handle_tunnel_loops::internal;

// The arrays of any mesh, with caps on its holes.
class Surface
{
public:
  explicit Surface(Mesh mesh)
      : mesh_(std::move(mesh))
      , surface_(
            Execution(), mesh_, get(boost::vertex_index, mesh_), get(CGAL::vertex_point, mesh_)) {}

  const Flat_mesh& flat() const { return surface_.mesh; }

private:
  using Point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;

  const Mesh mesh_;
  const Prepared_surface<Mesh, Point_map> surface_;
};

// Removes vertices here and there, each with the faces around it, where no hole is near.
inline Mesh with_holes(Mesh mesh, std::size_t number) {
  const auto is_near_hole = [&](Mesh::Vertex_index v) {
    for(const auto u : vertices_around_target(mesh.halfedge(v), mesh))
      if(mesh.is_border(u))
        return true;
    return mesh.is_border(v);
  };
  const std::size_t n = mesh.number_of_vertices();
  for(std::size_t i = 0; i < number; ++i) {
    const Mesh::Vertex_index v(static_cast<Index>(i * n / number));
    if(!is_near_hole(v)) {
      const auto h = CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh);
      CGAL::Euler::remove_face(h, mesh);
    }
  }
  mesh.collect_garbage();
  return mesh;
}

inline std::vector<Flat_mesh> meshes() {
  std::vector<Flat_mesh> all;
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3, 10}, 1))
    all.push_back(Surface(mesh_of(recipe)).flat());
  all.push_back(Surface(mesh_of({"lattice", {20000, 20, 0}})).flat());
  all.push_back(Surface(mesh_of({"shell", {4000, 4, 0}})).flat()); // two components
  all.push_back(Surface(mesh_of({"bars", {2000, 5, 0}})).flat());  // vertices with many neighbours
  all.push_back(Surface(mesh_of({"hubs", {4000, 10, 0}})).flat());
  all.push_back(Surface(mesh_of({"fan", {200, 0, 0}})).flat());
  all.push_back(Surface(mesh_of(smallest_torus())).flat());
  all.push_back(
      Surface(mesh_of(generators::disjoint_union(
                  {soup_of({"fan", {200, 0, 0}}), soup_of({"torus", {3000, 1, 0}}),
                   soup_of({"sphere", {100, 0, 0}}), soup_of({"multi-torus", {900, 2, 0}})})))
          .flat());
  all.push_back(Surface(with_holes(mesh_of({"torus", {6000, 1, 0}}), 5)).flat());
  all.push_back(Surface(with_holes(mesh_of({"gyroid", {4000, 10, 0}}), 40)).flat());
  return all;
}

const Index spacings[] = {1, 4, 16, 64};

inline Coarse_mesh coarse_mesh_of(const Flat_mesh& mesh,
                                  Index spacing,
                                  Execution execution = {},
                                  const Find_first_cells& find_first_cells = {}) {
  return *Coarse_mesh_builder(execution, mesh, spacing, mesh.seeds, find_first_cells).build();
}

inline void expect_same(const Coarse_mesh& a, const Coarse_mesh& b) {
  EXPECT_EQ(a.centre, b.centre);
  EXPECT_EQ(a.parent, b.parent);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.neighbor, b.mesh.neighbor);
  EXPECT_EQ(a.mesh.row_begin, b.mesh.row_begin);
  EXPECT_EQ(a.stretch, b.stretch);
  const auto is_same = [](const Gate& g, const Gate& h) {
    return g.from == h.from && g.to == h.to;
  };
  EXPECT_TRUE(std::equal(a.gate.begin(), a.gate.end(), b.gate.begin(), b.gate.end(), is_same));
}

// Cells that somebody else finds first lead to the coarse mesh of the host. Returns how many of
// them were not looked at.
inline std::size_t
expect_cells_of_host(const Flat_mesh& mesh, Index spacing, const Find_first_cells& find) {
  std::size_t number = 0;
  bool have_found = false;
  const auto find_and_count = [&](First_cells& cells) {
    have_found = find(cells);
    for(const Cell_look& look : cells.looks)
      number += look.number_of_neighbors == no_index;
    return have_found;
  };
  expect_same(coarse_mesh_of(mesh, spacing, Execution(), find_and_count),
              coarse_mesh_of(mesh, spacing));
  EXPECT_TRUE(have_found);
  return number;
}

} // namespace surfaces_for_cells

#endif // HTL_TEST_SURFACES_FOR_CELLS_H
