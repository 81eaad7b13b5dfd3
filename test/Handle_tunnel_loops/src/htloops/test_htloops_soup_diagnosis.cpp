#include "Number_of_cases.h"

#include "app/read/soup_diagnosis.h"
#include "generators/Random.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <limits>

namespace test_htloops_soup_diagnosis {

using namespace htloops;
using htloops::Mesh;
using htloops::Soup;

using Faces = std::vector<std::vector<std::uint32_t>>;

const Faces tetrahedron = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

Soup soup_of(const Faces& faces, std::size_t number_of_points) {
  Soup soup;
  for(std::size_t i = 0; i < number_of_points; ++i)
    soup.points.emplace_back(double(i % 3), double(i * i), double(i));
  for(const auto& face : faces) {
    Soup_face& soup_face = soup.faces.emplace_back();
    soup_face.resize(face.size());
    for(std::size_t i = 0; i < face.size(); ++i)
      soup_face[i] = face[i];
  }
  return soup;
}

// A torus of n times n squares, each cut in two; vertex n * i + j; `twist` makes it a Klein bottle.
Faces grid_surface(std::uint32_t n, bool twist = false) {
  const auto vertex = [n, twist](std::uint32_t i, std::uint32_t j) {
    return i < n || !twist ? n * (i % n) + j % n : (2 * n - j) % n;
  };
  Faces faces;
  for(std::uint32_t i = 0; i < n; ++i)
    for(std::uint32_t j = 0; j < n; ++j) {
      faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return faces;
}

Faces without(Faces faces, std::size_t index) {
  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(index));
  return faces;
}

Faces with(Faces faces, const std::vector<std::uint32_t>& face) {
  faces.push_back(face);
  return faces;
}

struct Expected
{
  Mesh_defect kind;
  std::size_t count;
  std::string words;
};

void expect_defects(const Faces& faces,
                    std::size_t number_of_points,
                    const std::vector<Expected>& expected) {
  const Built_mesh built = build_mesh(soup_of(faces, number_of_points));
  ASSERT_EQ(built.defects.size(), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i) {
    const Defect& defect = built.defects[i];
    EXPECT_EQ(defect.kind, expected[i].kind) << defect.message;
    EXPECT_EQ(defect.count, expected[i].count) << defect.message;
    EXPECT_NE(defect.message.find(expected[i].words), std::string::npos) << defect.message;
  }
  if(expected.empty()) {
    EXPECT_EQ(built.mesh.number_of_faces(), faces.size());
  }
}

TEST(Soup_diagnosis, accepts_closed_manifolds) {
  expect_defects(tetrahedron, 4, {});
  expect_defects(tetrahedron, 6, {}); // two isolated vertices
  expect_defects(grid_surface(5), 25, {});
}

TEST(Soup_diagnosis, names_what_is_no_triangle) {
  expect_defects({}, 3, {{Mesh_defect::EMPTY, 1, "no face"}});
  expect_defects({{0, 1, 2, 3}, {0, 1, 2}}, 4,
                 {{Mesh_defect::NOT_TRIANGULATED, 1, "face 0 with 4 vertices"}});
  expect_defects({{0, 1, 2}, {0, 1, 2, 3}, {0, 1, 2, 3, 4}}, 5,
                 {{Mesh_defect::NOT_TRIANGULATED, 2,
                   "2 faces are not triangles, first: face 1 with 4 vertices"}});
  expect_defects({{0, 1}, {0, 1, 2}}, 4,
                 {{Mesh_defect::NOT_TRIANGULATED, 1, "face 0 with 2 vertices"}});
  expect_defects(with(tetrahedron, {2, 0, 2}), 4, {{Mesh_defect::DEGENERATE_FACE, 1, "face 4"}});
}

TEST(Soup_diagnosis, names_a_point_that_is_nowhere) {
  for(const double bad :
      {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
  {
    Soup soup = soup_of(tetrahedron, 4);
    soup.points[2] = Point(0., bad, 0.);
    const std::vector<Defect> defects = build_mesh(soup).defects;
    ASSERT_EQ(defects.size(), 1u);
    EXPECT_EQ(defects[0].kind, Mesh_defect::NON_FINITE_COORDINATE);
    EXPECT_EQ(defects[0].message,
              "1 vertex has a coordinate that is infinite or not a number: vertex 2");
  }
}

TEST(Soup_diagnosis, accepts_boundaries) {
  expect_defects({{0, 1, 2}}, 3, {});
  expect_defects(without(grid_surface(6), 0), 36, {});
  expect_defects(without(without(grid_surface(6), 40), 0), 36, {});
}

// As programs write a mesh that have no vertices of their own: each face has its points.
TEST(Soup_diagnosis, recognizes_faces_that_share_no_vertex) {
  const Soup welded = soup_of(tetrahedron, 4);
  Soup soup = soup_of({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}, 12);
  for(std::uint32_t h = 0; h < 12; ++h)
    soup.points[h] = welded.points[welded.source(h)];
  const std::vector<Defect> defects = build_mesh(soup).defects;
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Mesh_defect::BOUNDARY_EDGE);
  EXPECT_EQ(defects[0].message,
            "12 boundary edges, in 4 loops of three edges: no two faces share a vertex (merging "
            "equal points would leave 4 of 12 vertices), first: edge 0-1 of face 0");
}

// Such faces are surfaces of their own, if no edge lies on one of another face.
TEST(Soup_diagnosis, accepts_faces_that_are_apart_or_touch_in_a_point) {
  Soup soup = soup_of({{0, 1, 2}, {3, 4, 5}}, 6);
  EXPECT_TRUE(build_mesh(soup).defects.empty());
  soup.points[3] = soup.points[0];
  EXPECT_TRUE(build_mesh(soup).defects.empty());
  soup.points[4] = soup.points[0]; // all edges of the second face lie at the same two places
  EXPECT_TRUE(build_mesh(soup).defects.empty());
  soup.points[4] = soup.points[1];
  const std::vector<Defect> defects = build_mesh(soup).defects;
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Mesh_defect::BOUNDARY_EDGE);
}

TEST(Soup_diagnosis, names_edges_with_too_many_faces) {
  expect_defects(with(tetrahedron, {0, 1, 4}), 5,
                 {{Mesh_defect::NON_MANIFOLD_EDGE, 1, "edge 0-1 with 3 faces"}});
}

TEST(Soup_diagnosis, names_duplicate_faces) {
  for(const std::vector<std::uint32_t>& duplicate : Faces{{2, 0, 1}, {1, 0, 2}})
    expect_defects(with(tetrahedron, duplicate), 4,
                   {{Mesh_defect::NON_MANIFOLD_EDGE, 1, "face 4 with the vertices of face 0"},
                    {Mesh_defect::NON_MANIFOLD_EDGE, 3, "edges have more than two faces"}});
}

// Whatever the order of their vertices.
TEST(Soup_diagnosis, names_the_smallest_number_of_a_duplicate) {
  expect_defects(with(with(tetrahedron, tetrahedron[3]), tetrahedron[0]), 4,
                 {{Mesh_defect::NON_MANIFOLD_EDGE, 2,
                   "2 faces are duplicates, first: face 4 with the vertices of face 3"},
                  {Mesh_defect::NON_MANIFOLD_EDGE, 5, "edges have more than two faces"}});
}

TEST(Soup_diagnosis, counts_all_duplicates_of_a_face) {
  const std::vector<std::uint32_t> face = tetrahedron[0], flipped = {1, 0, 2};
  for(const Faces& duplicates : {Faces{face, face}, Faces{face, flipped}, Faces{flipped, flipped}})
    expect_defects(with(with(tetrahedron, duplicates[0]), duplicates[1]), 4,
                   {{Mesh_defect::NON_MANIFOLD_EDGE, 2, "2 faces are duplicates"},
                    {Mesh_defect::NON_MANIFOLD_EDGE, 3, "edges have more than two faces"}});
  for(const Faces& three : {Faces{face, face, face}, Faces{face, flipped, face}})
    expect_defects(three, 3,
                   {{Mesh_defect::NON_MANIFOLD_EDGE, 2, "2 faces are duplicates"},
                    {Mesh_defect::NON_MANIFOLD_EDGE, 3, "edges have more than two faces"}});
}

TEST(Soup_diagnosis, names_pinched_vertices) {
  Faces two_tetrahedra = tetrahedron;
  for(auto face : tetrahedron) {
    for(std::uint32_t& vertex : face)
      vertex = vertex == 0 ? 0 : vertex + 3;
    two_tetrahedra.push_back(face);
  }
  expect_defects(two_tetrahedra, 7,
                 {{Mesh_defect::NON_MANIFOLD_VERTEX, 1, "vertex 0 with 2 fans"}});
}

TEST(Soup_diagnosis, tells_a_flipped_face_from_a_surface_without_orientation) {
  Faces flipped = grid_surface(5);
  std::swap(flipped[7][0], flipped[7][1]);
  expect_defects(flipped, 25, {{Mesh_defect::INCONSISTENT_ORIENTATION, 3, "would fix it"}});
  expect_defects(grid_surface(6, true), 36,
                 {{Mesh_defect::INCONSISTENT_ORIENTATION, 6, "not orientable"}});
}

TEST(Soup_diagnosis, finds_all_defects_at_once) {
  Faces faces = without(grid_surface(6), 0);
  std::swap(faces[40][0], faces[40][1]);
  expect_defects(
      with(with(with(faces, {40, 41, 42}), {43, 44, 45}), {40, 46, 47}), 48,
      {{Mesh_defect::INCONSISTENT_ORIENTATION, 3, ""}, {Mesh_defect::NON_MANIFOLD_VERTEX, 1, ""}});
}

// What is built without a diagnosis has no defect, and what has none is built.
TEST(Mesh_builder, refuses_what_has_defects) {
  CGAL::Handle_tunnel_loops::generators::Random random(1);
  std::size_t number_built = 0;
  for(int i = 0; i < number_of_cases(20000); ++i) {
    const std::size_t n = 3 + random.below(5);
    Faces faces;
    for(std::size_t f = 0; f < 1 + random.below(5); ++f) {
      std::vector<std::uint32_t> face(random.below(40) == 0 ? 4 : 3);
      for(std::uint32_t& v : face)
        v = static_cast<std::uint32_t>(random.below(n));
      faces.push_back(face);
    }
    const Soup soup = soup_of(faces, n);
    const Built_mesh built = build_mesh(soup);
    const std::vector<Defect> defects = diagnose(soup);
    ASSERT_EQ(built.defects.size(), defects.size());
    for(std::size_t d = 0; d < defects.size(); ++d)
      EXPECT_EQ(built.defects[d].message, defects[d].message);
    number_built += defects.empty() ? 1 : 0;
  }
  EXPECT_GT(number_built, 20u);
}

TEST(Mesh_builder, keeps_the_numbers_of_vertices_and_faces) {
  const Soup soup = soup_of(grid_surface(5), 26); // the last vertex is isolated
  const Mesh mesh = build_mesh(soup).mesh;
  EXPECT_TRUE(CGAL::is_closed(mesh));
  ASSERT_EQ(mesh.number_of_vertices(), 26u);
  ASSERT_EQ(mesh.number_of_faces(), 50u);
  EXPECT_TRUE(mesh.is_isolated(Mesh::Vertex_index(25)));
  for(std::uint32_t v = 0; v < 26; ++v)
    EXPECT_EQ(mesh.point(Mesh::Vertex_index(v)), soup.points[v]);
  for(std::uint32_t f = 0; f < 50; ++f) {
    const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(f));
    EXPECT_EQ(mesh.source(h).idx(), soup.faces[f][0]);
    EXPECT_EQ(mesh.target(h).idx(), soup.faces[f][1]);
    EXPECT_EQ(mesh.target(mesh.next(h)).idx(), soup.faces[f][2]);
  }
}

} // namespace test_htloops_soup_diagnosis
