// The file that `htloops cut -o` writes, judged by what is in it: faces as numbers of vertices; and
// cuts as `--seams` wants them, which spare polygons and open spheres.

#include "app/draw/meshes.h"

#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"
#include "Temporary_folder.h"

#include "app/mend/mesh_reader.h"
#include "app/read/input_file.h"
#include "app/read/meshes/mesh_formats.h"
#include "app/solve/cut_solver.h"
#include "app/write/mesh_writer.h"
#include "generators/generators.h"

#include <gtest/gtest.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_opened_mesh {

using Vertex_number = std::size_t;
using Side = std::pair<Vertex_number, Vertex_number>;

struct Piece
{
  std::set<Vertex_number> vertices;
  std::set<Side> edges;
  long faces = 0;
  std::map<Vertex_number, Vertex_number> boundary; ///< where its boundary goes on from a vertex
};

// The pieces into which the faces of a file fall, by the vertices that they share.
std::vector<Piece> pieces_of(const htloops::Soup& soup) {
  boost::disjoint_sets_with_storage<> sets(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    sets.make_set(v);
  std::set<Side> sides;
  for(const auto& face : soup.faces)
    for(std::size_t i = 0; i < face.size(); ++i) {
      const Side side(face[i], face[(i + 1) % face.size()]);
      sets.union_set(side.first, side.second);
      EXPECT_TRUE(sides.insert(side).second) << "two faces on one side of an edge";
    }
  std::map<Vertex_number, Piece> pieces;
  for(const auto& face : soup.faces)
    ++pieces[sets.find_set(face[0])].faces;
  for(const auto& [a, b] : sides) {
    Piece& piece = pieces[sets.find_set(a)];
    piece.vertices.insert(a);
    piece.edges.insert(std::minmax(a, b));
    if(sides.count({b, a}) == 0) {
      EXPECT_TRUE(piece.boundary.emplace(a, b).second) << "two boundaries pass vertex " << a;
    }
  }
  std::vector<Piece> result;
  for(const auto& [representative, piece] : pieces)
    result.push_back(piece);
  return result;
}

std::size_t number_of_boundary_curves(const Piece& piece) {
  std::set<Vertex_number> seen;
  std::size_t number = 0;
  for(const auto& [start, next] : piece.boundary) {
    number += seen.count(start) == 0;
    for(Vertex_number v = start; seen.insert(v).second;)
      v = piece.boundary.at(v);
  }
  return number;
}

void expect_disks(const htloops::Soup& soup) {
  std::size_t number_of_vertices = 0;
  for(const Piece& piece : pieces_of(soup)) {
    number_of_vertices += piece.vertices.size();
    EXPECT_EQ(long(piece.vertices.size()) - long(piece.edges.size()) + piece.faces, 1);
    EXPECT_EQ(number_of_boundary_curves(piece), 1u);
  }
  EXPECT_EQ(number_of_vertices, soup.points.size()) << "vertices of no face";
}

class Opened_mesh : public testing::Test
{
protected:
  // What is read of the file that is written of a mesh cut open.
  htloops::Soup written(const htloops::Mesh& mesh,
                        const std::string& name,
                        const htloops::Cut_options& options = {}) {
    htloops::Progress progress;
    const auto cut = htloops::find_cut(mesh, options, progress).edges;
    htloops::write_mesh(folder_.path(name), htloops::opened_mesh(mesh, cut));
    return htloops::read_soup(folder_.path(name));
  }

  Temporary_folder folder_;
};

htloops::Mesh holed_mesh(const Recipe& recipe, std::size_t number, bool is_ragged) {
  generators::Hole_request holes;
  holes.number = number;
  holes.is_ragged = is_ragged;
  holes.seed = recipe.request.seed;
  return mesh_of<htloops::Mesh>(generators::with_holes(soup_of(recipe), holes));
}

TEST_F(Opened_mesh, is_a_disk_where_there_is_no_boundary) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    expect_disks(written(mesh_of<htloops::Mesh>(soup_of(recipe)), "open.off"));
  }
}

TEST_F(Opened_mesh, is_a_disk_where_there_is_a_boundary) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2}, 2))
    for(const std::size_t number : {1, 2, 7}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << number << " holes");
      expect_disks(written(holed_mesh(recipe, number, number == 2), "open.obj"));
    }
}

// Cones may lie inside, on a boundary curve, and side by side.
TEST_F(Opened_mesh, is_a_disk_with_cones) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 2}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const htloops::Mesh mesh = holed_mesh(recipe, 3, true);
    htloops::Cut_options options;
    for(const auto h : mesh.halfedges())
      if(mesh.is_border(h) && options.cones.size() < 2)
        options.cones.push_back(mesh.target(h));
    options.cones.insert(options.cones.end(),
                         {htloops::Mesh::Vertex_index(0), htloops::Mesh::Vertex_index(5)});
    std::sort(options.cones.begin(), options.cones.end());
    options.cones.erase(std::unique(options.cones.begin(), options.cones.end()),
                        options.cones.end());
    expect_disks(written(mesh, "open.ply", options));
  }
}

TEST_F(Opened_mesh, is_a_disk_on_scans_with_boundary) {
  for(const char* name : {"eight_hole.off", "cgal_elephant-with-holes.off",
                          "cgal_double-torus-3-holes.off", "gebco_open.off"})
  {
    const auto file = mesh_corpus() / "difficult" / name;
    if(!std::filesystem::exists(file))
      GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
    SCOPED_TRACE(name);
    expect_disks(written(htloops::read_mesh(file.string()), "open.obj"));
  }
}

// A torus of n by n quadrangles, some of them joined to hexagons, whose points are shaken.
std::string torus_of_polygons(unsigned n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-0.1, 0.1);
  std::ostringstream text;
  for(unsigned i = 0; i < n; ++i)
    for(unsigned j = 0; j < n; ++j) {
      const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / n;
      text << "v " << (3. + std::cos(b)) * std::cos(a) + shake(random) << ' '
           << (3. + std::cos(b)) * std::sin(a) + shake(random) << ' ' << std::sin(b) + shake(random)
           << '\n';
    }
  const auto vertex = [n](unsigned i, unsigned j) { return i % n * n + j % n + 1; };
  for(unsigned i = 0; i < n; ++i)
    for(unsigned j = 0; j < n; ++j) {
      const bool is_joined = j + 2 < n && random() % 4 == 0;
      text << "f " << vertex(i, j) << ' ' << vertex(i + 1, j) << ' ' << vertex(i + 1, j + 1);
      if(is_joined)
        text << ' ' << vertex(i + 1, j + 2) << ' ' << vertex(i, j + 2);
      text << ' ' << vertex(i, j + 1) << '\n';
      j += is_joined;
    }
  return text.str();
}

TEST_F(Opened_mesh, is_a_disk_where_polygons_stay_whole) {
  for(unsigned seed = 0; seed < 4; ++seed) {
    folder_.write("polygons.obj", torus_of_polygons(6 + 2 * seed, seed));
    htloops::Remedies remedies;
    remedies.do_triangulate = true;
    const htloops::Mended_mesh mended = htloops::read_mesh(folder_.path("polygons.obj"), remedies);
    ASSERT_EQ(mended.cuts.size(), mended.mesh.number_of_halfedges());
    htloops::Cut_options options;
    options.avoided = mended.cuts;
    htloops::Progress progress;
    for(const auto e : htloops::find_cut(mended.mesh, options, progress).edges)
      EXPECT_EQ(mended.cuts[e.idx()], 0) << "a cut across a face";
    expect_disks(written(mended.mesh, "open.obj", options));
  }
}

// A cut along a single edge opens nothing: that of a tetrahedron, where all vertices are neighbors.
TEST_F(Opened_mesh, is_a_disk_of_each_sphere_if_these_are_cut) {
  htloops::Cut_options options;
  options.do_cut_spheres = true;
  std::vector<generators::Soup> soups;
  for(const unsigned seed : {0, 1, 2})
    for(const char* kind : {"sphere", "torus"})
      soups.push_back(soup_of({kind, {200 + 100 * seed, kind[0] == 't' ? 1u : 0u, seed}}));
  generators::Soup tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  soups.push_back(tetrahedron);
  const auto mesh = mesh_of<htloops::Mesh>(generators::disjoint_union(soups));
  const htloops::Soup opened = written(mesh, "open.off", options);
  EXPECT_EQ(pieces_of(opened).size(), soups.size());
  expect_disks(opened);
}

} // namespace test_htloops_opened_mesh
