// What is no triangle mesh is refused, by name; what is one is accepted, however degenerate.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "with.h"

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_invalid_meshes {

using CGAL::Handle_tunnel_loops::Field_constants;
using CGAL::Handle_tunnel_loops::Invalid_mesh_exception;
using CGAL::Handle_tunnel_loops::Mesh_defect;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// What is wrong with a mesh; the message must name the vertices.
Invalid_mesh_exception defect_of(const Mesh& mesh) {
  try {
    const Solver solver(mesh);
  } catch(const Invalid_mesh_exception& e) {
    for(const std::size_t v : e.vertices())
      EXPECT_NE(std::string(e.what()).find(std::to_string(v)), std::string::npos) << e.what();
    return e;
  }
  ADD_FAILURE() << "the mesh is accepted";
  return Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "");
}

Mesh torus() { return mesh_of({"torus", {200, 1, 0}}); }

std::set<std::size_t> vertices_of_face(const Mesh& mesh, Mesh::Face_index f) {
  std::set<std::size_t> vertices;
  for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    vertices.insert(v);
  return vertices;
}

// ---- size

TEST(Large_mesh, HasAsManyHalfedgesAsIndicesHold) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  const std::size_t faces = most_halfedges / 3, vertices = faces / 2;
  EXPECT_EQ(faces, 1431655764u);
  EXPECT_LT(3 * (faces - 1) + 2, no_index); // the last halfedge
  EXPECT_NO_THROW(check_size(faces, vertices));
  EXPECT_THROW(check_size(faces + 1, vertices), Invalid_mesh_exception);
  EXPECT_THROW(check_size(faces, std::size_t(1) << 31), Invalid_mesh_exception);
}

// ---- connectivity

TEST(Empty_mesh, IsRefused) {
  Mesh mesh;
  EXPECT_EQ(defect_of(mesh).defect(), Mesh_defect::EMPTY);
  mesh.add_vertex({0., 0., 0.});
  EXPECT_EQ(defect_of(mesh).defect(), Mesh_defect::EMPTY);
  EXPECT_TRUE(defect_of(mesh).vertices().empty());
}

TEST(Boundary, IsAccepted) {
  Mesh mesh = torus();
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(37)), mesh);
  EXPECT_EQ(find_loops(mesh).size(), 1u);
}

// Two faces less at a vertex, not beside each other.
TEST(Boundary_that_comes_to_a_vertex_twice, IsRefused) {
  Mesh mesh = torus();
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(37));
  const auto next = [&](Mesh::Halfedge_index g) { return mesh.opposite(mesh.next(g)); };
  const Mesh::Face_index opposite = mesh.face(next(next(next(h))));
  CGAL::Euler::remove_face(h, mesh);
  CGAL::Euler::remove_face(mesh.halfedge(opposite), mesh);
  const Invalid_mesh_exception e = defect_of(mesh);
  EXPECT_EQ(e.defect(), Mesh_defect::NON_MANIFOLD_VERTEX);
  EXPECT_EQ(e.vertices(), std::vector<std::size_t>(1, 37));
}

TEST(Single_triangle, IsAccepted) {
  Mesh mesh;
  CGAL::make_triangle(Mesh::Point(0, 0, 0), Mesh::Point(1, 0, 0), Mesh::Point(0, 1, 0), mesh);
  EXPECT_TRUE(find_loops(mesh).empty());
}

TEST(Quadrangle, IsRefused) {
  Mesh mesh = torus();
  const Mesh::Halfedge_index h(37);
  const Mesh::Halfedge_index remaining = CGAL::Euler::join_face(h, mesh);
  const std::set<std::size_t> corners = vertices_of_face(mesh, mesh.face(remaining));
  const Invalid_mesh_exception e = defect_of(mesh);
  EXPECT_EQ(e.defect(), Mesh_defect::NOT_TRIANGULATED);
  EXPECT_FALSE(e.vertices().empty());
  for(const std::size_t v : e.vertices())
    EXPECT_EQ(corners.count(v), 1u) << v;
}

TEST(Two_surfaces_with_a_common_vertex, AreRefused) {
  const Soup sphere = soup_of({"sphere", {100, 0, 0}});
  Mesh mesh = mesh_of(generators::disjoint_union({sphere, sphere}));
  const Mesh::Vertex_index kept(3), removed(static_cast<Mesh::size_type>(sphere.points.size()) + 5);
  std::vector<Mesh::Halfedge_index> halfedges;
  for(const Mesh::Halfedge_index h : CGAL::halfedges_around_target(removed, mesh))
    halfedges.push_back(h);
  for(const Mesh::Halfedge_index h : halfedges)
    mesh.set_target(h, kept);
  mesh.remove_vertex(removed);
  const Invalid_mesh_exception e = defect_of(mesh);
  EXPECT_EQ(e.defect(), Mesh_defect::NON_MANIFOLD_VERTEX);
  EXPECT_EQ(e.vertices(), std::vector<std::size_t>(1, kept));
}

// The torus of a grid that is periodic both ways. Its edges are known by their place, not by their
// ends, so that the grid may be small enough to have several edges between two vertices.
class Grid_torus
{
public:
  Grid_torus(unsigned columns, unsigned rows)
      : columns_(columns)
      , rows_(rows) {
    for(unsigned i = 0; i < columns * rows; ++i)
      mesh_.add_vertex({double(i % columns), double(i / columns), double(i % 2)});
    for(unsigned i = 0; i < 3 * columns * rows; ++i)
      mesh_.add_edge();
    for(unsigned i = 0; i < columns; ++i)
      for(unsigned j = 0; j < rows; ++j) {
        add_face({right(i, j), up(i + 1, j), mesh_.opposite(diagonal(i, j))},
                 {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        add_face({diagonal(i, j), mesh_.opposite(right(i, j + 1)), mesh_.opposite(up(i, j))},
                 {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }

  const Mesh& mesh() const { return mesh_; }

private:
  unsigned cell(unsigned i, unsigned j) const { return i % columns_ + columns_ * (j % rows_); }
  Mesh::Vertex_index vertex(unsigned i, unsigned j) const { return Mesh::Vertex_index(cell(i, j)); }
  Mesh::Halfedge_index halfedge(unsigned edge) const {
    return mesh_.halfedge(Mesh::Edge_index(edge));
  }
  Mesh::Halfedge_index right(unsigned i, unsigned j) const { return halfedge(3 * cell(i, j)); }
  Mesh::Halfedge_index up(unsigned i, unsigned j) const { return halfedge(3 * cell(i, j) + 1); }
  Mesh::Halfedge_index diagonal(unsigned i, unsigned j) const {
    return halfedge(3 * cell(i, j) + 2);
  }

  // Halfedge k leaves vertex k.
  void add_face(const std::array<Mesh::Halfedge_index, 3>& halfedges,
                const std::array<Mesh::Vertex_index, 3>& vertices) {
    const Mesh::Face_index f = mesh_.add_face();
    mesh_.set_halfedge(f, halfedges[0]);
    for(int k = 0; k < 3; ++k) {
      const Mesh::Vertex_index target = vertices[(k + 1) % 3];
      mesh_.set_face(halfedges[k], f);
      mesh_.set_next(halfedges[k], halfedges[(k + 1) % 3]);
      mesh_.set_target(halfedges[k], target);
      mesh_.set_halfedge(target, halfedges[k]);
    }
  }

  unsigned columns_, rows_;
  Mesh mesh_;
};

TEST(Smallest_grid, IsAccepted) {
  const Grid_torus torus(3, 3);
  ASSERT_TRUE(torus.mesh().is_valid());
  expect_handle_tunnel_pairs(torus.mesh(), find_loops(torus.mesh()), 1);
}

TEST(Parallel_edges, AreRefused) {
  // A grid of one column has loops, a grid of two columns has two edges between two vertices.
  for(const auto& [columns, rows] :
      std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {1, 5}, {2, 2}, {2, 7}, {5, 2}, {4, 1}})
  {
    SCOPED_TRACE(testing::Message() << columns << " columns, " << rows << " rows");
    const Grid_torus torus(columns, rows);
    const Invalid_mesh_exception e = defect_of(torus.mesh());
    EXPECT_EQ(e.defect(), Mesh_defect::PARALLEL_EDGES);
    ASSERT_FALSE(e.vertices().empty());
    for(const std::size_t v : e.vertices())
      EXPECT_LT(v, torus.mesh().number_of_vertices());
  }
}

// Edges at vertices with many neighbours are looked through in another way.
TEST(Parallel_edges, AreRefusedAtVerticesOfHighDegree) {
  const Grid_torus torus(2, 5);
  Mesh mesh = torus.mesh();
  for(int round = 0; round < 2; ++round) {
    const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
    for(const Mesh::Face_index f : faces)
      CGAL::Euler::add_center_vertex(mesh.halfedge(f), mesh);
  }
  ASSERT_EQ(mesh.degree(Mesh::Vertex_index(0)), 24u);
  EXPECT_EQ(defect_of(mesh).defect(), Mesh_defect::PARALLEL_EDGES);
}

// ---- coordinates

TEST(Coordinate_that_is_not_finite, IsRefused) {
  for(const double x : {infinity, -infinity, not_a_number})
    for(int axis = 0; axis < 3; ++axis) {
      Soup soup = soup_of({"torus", {200, 1, 0}});
      soup.points[17][axis] = x;
      const Invalid_mesh_exception e = defect_of(mesh_of(soup));
      EXPECT_EQ(e.defect(), Mesh_defect::NON_FINITE_COORDINATE);
      EXPECT_EQ(e.vertices(), std::vector<std::size_t>(1, 17));
    }
}

TEST(Coordinate_that_is_not_finite, DoesNotMatterAtAnIsolatedVertex) {
  Mesh mesh = torus();
  mesh.add_vertex({not_a_number, 0., infinity});
  expect_handle_tunnel_pairs(mesh, find_loops(mesh), 1);
}

class Degenerate_mesh : public testing::Test
{
protected:
  // Of all small meshes.
  template <typename Change> static void expect_loops_after(const Change& change) {
    for(const Recipe& recipe : {Recipe{"torus", {300, 1, 0}}, Recipe{"multi-torus", {1000, 3, 0}},
                                Recipe{"lattice", {2000, 4, 1}}, Recipe{"random", {400, 9, 1}},
                                Recipe{"random", {60, 4, 2}}})
    {
      SCOPED_TRACE(testing::PrintToString(recipe));
      Soup soup = soup_of(recipe);
      change(soup);
      const Mesh mesh = mesh_of(soup);
      expect_handle_tunnel_pairs(mesh, find_loops(mesh), recipe.request.genus);
    }
  }
};

TEST_F(Degenerate_mesh, MayBeAPoint) {
  for(const double x : {0., -5., 1e300})
    expect_loops_after([x](Soup& soup) { soup = transformed(soup, 0., x); });
}

TEST_F(Degenerate_mesh, MayBeALine) {
  for(int axis = 0; axis < 3; ++axis)
    expect_loops_after([axis](Soup& soup) {
      for(auto& point : soup.points)
        point[axis] = point[(axis + 1) % 3] = 2.;
    });
}

TEST_F(Degenerate_mesh, MayBeFlat) {
  expect_loops_after([](Soup& soup) {
    for(auto& point : soup.points)
      point[2] = 0.;
  });
}

// Triangles without area, and edges without length.
TEST_F(Degenerate_mesh, MayHaveCoincidentPoints) {
  for(const double cell : {0.05, 0.3, 1.})
    expect_loops_after([cell](Soup& soup) {
      for(auto& point : soup.points)
        for(double& x : point)
          x = cell * std::floor(x / cell);
    });
}

TEST_F(Degenerate_mesh, MayHaveAllButOnePointInOnePlace) {
  expect_loops_after([](Soup& soup) {
    for(auto& point : soup.points)
      point = {1., 1., 1.};
    soup.points[soup.points.size() / 2] = {2., 3., 4.};
  });
}

TEST_F(Degenerate_mesh, MayHaveNeedles) {
  expect_loops_after([](Soup& soup) {
    for(auto& point : soup.points) {
      point[0] *= 1e12;
      point[1] *= 1e-12;
    }
  });
}

TEST_F(Degenerate_mesh, MayBeOfAnySize) {
  for(const double scale : {1e-300, 1e-150, 1e-9, 1e9, 1e150, 1e300}) {
    SCOPED_TRACE(scale);
    expect_loops_after([scale](Soup& soup) { soup = transformed(soup, scale, 0.); });
  }
}

// Some or all of the digits of the shape are lost.
TEST_F(Degenerate_mesh, MayBeFarAway) {
  for(const double shift : {1e6, -1e12, 1e16, 1e200}) {
    SCOPED_TRACE(shift);
    expect_loops_after([shift](Soup& soup) { soup = transformed(soup, 1., shift); });
  }
}

TEST(Scale, ChangesNothingButTheLength) {
  const Soup soup = soup_of({"multi-torus", {1000, 3, 0}});
  const Pairs expected = find_loops(mesh_of(soup));
  double largest = 0.;
  for(const auto& p : soup.points)
    for(double x : p)
      largest = (std::max)(largest, std::abs(x));
  // With the last one, the box of the mesh is wider than all doubles.
  for(const double scale :
      {0x1p-400, 0x1p-30, 0x1p30, 0x1p400, std::ldexp(1., 1023 - std::ilogb(largest))})
  {
    const Pairs pairs = find_loops(mesh_of(transformed(soup, scale, 0.)));
    ASSERT_EQ(pairs.size(), expected.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      for(const auto type : {CGAL::Loop_type::HANDLE, CGAL::Loop_type::TUNNEL}) {
        const auto &loop = pairs[k].loop(type), &other = expected[k].loop(type);
        EXPECT_EQ(loop.length(), scale * other.length());
        ASSERT_EQ(loop.size(), other.size());
        for(std::size_t i = 0; i < loop.size(); ++i) {
          EXPECT_EQ(loop.steps()[i].halfedge, other.steps()[i].halfedge);
          EXPECT_EQ(loop.steps()[i].ratio, other.steps()[i].ratio);
        }
      }
  }
}

// ---- genus 0

TEST(Sphere, HasNoLoops) {
  for(const std::size_t faces : {4u, 10u, 1000u})
    for(const char* kind : {"sphere", "random"})
      EXPECT_TRUE(find_loops(mesh_of({kind, {faces, 0, 1}})).empty());
  const Soup sphere = soup_of({"sphere", {100, 0, 0}});
  const Mesh mesh = mesh_of(generators::disjoint_union({sphere, sphere, sphere}));
  const Solver solver(mesh);
  EXPECT_EQ(solver.genus(), 0u);
  EXPECT_EQ(solver.number_of_components(), 3u);
  EXPECT_TRUE(find_loops(mesh).empty());
}

// ---- parameters

class Invalid_parameters : public testing::TestWithParam<Recipe>
{
protected:
  Mesh mesh = mesh_of(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Invalid_parameters,
                         testing::Values(Recipe{"torus", {200, 1, 0}},
                                         Recipe{"sphere", {200, 0, 0}}),
                         [](const auto& test) { return test.param.kind; });

TEST_P(Invalid_parameters, AreSeedsThatAreNotOnTheSurface) {
  const Mesh::Vertex_index isolated = mesh.add_vertex({0., 0., 0.});
  const Mesh::Vertex_index missing(isolated + 1);
  for(const Mesh::Vertex_index v : {isolated, missing})
    EXPECT_THROW(find_loops(mesh, CGAL::parameters::seed_vertex(v)), std::invalid_argument);
}

TEST_P(Invalid_parameters, AreFieldConstantsWithoutSense) {
  const Field_constants good;
  std::vector<Field_constants> bad;
  for(double Field_constants::*constant :
      {&Field_constants::mobility, &Field_constants::driving_force,
       &Field_constants::gradient_coefficient, &Field_constants::penalty, &Field_constants::step})
    for(const double x : {0., -1., infinity, -infinity, not_a_number}) {
      bad.push_back(good);
      bad.back().*constant = x;
    }
  bad.push_back(good);
  bad.back().step = 1.01;
  bad.push_back(good);
  bad.back().penalty = good.driving_force;

  for(const Field_constants& c : bad) {
    SCOPED_TRACE(testing::Message() << c.mobility << ' ' << c.driving_force << ' '
                                    << c.gradient_coefficient << ' ' << c.penalty << ' ' << c.step);
    EXPECT_THROW(
        find_loops(mesh, CGAL::parameters::solver_options(
                             with(&CGAL::Handle_tunnel_loops::Solver_options::field_constants, c))),
        std::invalid_argument);
  }
}

TEST(Exceptions, TellWhatTheyAreAbout) {
  const Invalid_mesh_exception e(Mesh_defect::BOUNDARY_EDGE, {3, 4}, "words");
  EXPECT_EQ(e.defect(), Mesh_defect::BOUNDARY_EDGE);
  EXPECT_EQ(e.vertices(), (std::vector<std::size_t>{3, 4}));
  EXPECT_STREQ(e.what(), "words");
}

} // namespace test_invalid_meshes
