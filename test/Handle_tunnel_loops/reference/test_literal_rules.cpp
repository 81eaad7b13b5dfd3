// The rules of the paper to the letter: an answer by them is as good as any, and where they lead
// nowhere they say so.

#include "Flat_mesh_of_soup.h"
#include "Meshes_of_soups.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Band_pass.h>
#include <CGAL/iterator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_literal_rules {

using namespace CGAL::Handle_tunnel_loops;
using namespace CGAL::Handle_tunnel_loops::internal;
namespace reference = CGAL::Handle_tunnel_loops::internal::reference;
namespace params = CGAL::parameters;

// ---- finite elements

Soup octahedron() {
  Soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return soup;
}

Soup tetrahedron() {
  Soup soup;
  soup.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  soup.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return soup;
}

TEST(Finite_element_laplacian, IsTheOtherOneOnEquilateralTriangles) {
  for(const Soup& soup : {tetrahedron(), octahedron()}) {
    const Flat_mesh mesh = flat_mesh_of(soup);
    const Eigen::MatrixXd difference = Eigen::MatrixXd(reference::finite_element_laplacian(mesh)) -
                                       Eigen::MatrixXd(reference::laplacian(mesh));
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9);
  }
}

// Of the function that is the coordinate along any direction, it is the mean curvature normal,
// which has no part along the surface where that is flat.
TEST(Finite_element_laplacian, IsZeroForWhatIsLinearOnAFlatPart) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sponge", {3000, 3, 0}});
  const auto laplacian = reference::finite_element_laplacian(mesh);
  Eigen::MatrixXd points(mesh.number_of_vertices(), 3);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(int i = 0; i < 3; ++i)
      points(v, i) = mesh.points[v][i];
  const Eigen::MatrixXd normals = laplacian * points;
  EXPECT_LT((laplacian * Eigen::VectorXd::Ones(points.rows())).cwiseAbs().maxCoeff(), 1e-9);
  std::size_t flat = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    double bend = 0.;
    for(Index i = 0; i < ring.size(); ++i) {
      const Vector a = mesh.points[ring[i]] - mesh.points[v],
                   b = mesh.points[ring[ring.next(i)]] - mesh.points[v],
                   c = mesh.points[ring[ring.next(ring.next(i))]] - mesh.points[v];
      bend = (std::max)(bend, std::abs(dot(cross(a, b), c)) / (norm(cross(a, b)) * norm(c)));
    }
    if(bend > 1e-5)
      continue;
    ++flat;
    EXPECT_LT(normals.row(v).norm(), 1e-3) << v;
  }
  EXPECT_GT(flat, mesh.number_of_vertices() / 10);
}

TEST(Finite_element_laplacian, CrossesNoWall) {
  const Flat_mesh mesh = flat_mesh_of(octahedron());
  reference::Barred_edges walls(mesh.neighbor.size(), 0);
  walls[reference::slot(mesh, 0, mesh.ring(0)[0])] =
      walls[reference::slot(mesh, mesh.ring(0)[0], 0)] = 1;
  const Eigen::MatrixXd matrix(reference::finite_element_laplacian(mesh, walls));
  EXPECT_EQ(matrix(0, mesh.ring(0)[0]), 0.);
  EXPECT_NE(matrix(0, mesh.ring(0)[1]), 0.);
  EXPECT_LT(matrix.rowwise().sum().cwiseAbs().maxCoeff(), 1e-9);
}

// ---- answers

// What the reference finds by some rules, certified; or why it does not.
struct Answer
{
  Pairs pairs;
  std::string failure;
};

Answer answer_to(const Mesh& mesh, const Literal_rules& rules) {
  Solver_options options;
  options.literal_rules = rules;
  options.do_tighten = options.do_compute_linking = false;
  Answer answer;
  try {
    CGAL::handle_tunnel_loops<CGAL::Reference_tag>(mesh, std::back_inserter(answer.pairs),
                                                   params::solver_options(options));
  } catch(const Literal_failure_exception& failure) {
    answer.failure = failure.what();
  } catch(const Uncertified_loops_exception& failure) {
    answer.failure = failure.what();
  }
  return answer;
}

std::vector<Recipe> well_shaped() {
  return {{"torus", {3100, 1, 0}}, {"multi-torus", {12000, 2, 0}}, {"knot", {10000, 1, 0}}};
}

TEST(Literal_rules, AreNoneByDefault) {
  EXPECT_FALSE(Literal_rules().any());
  EXPECT_TRUE(Literal_rules::all().any());
}

// The paper's constant and the default are one front in two units of length.
TEST(Literal_rules, CoefficientOfThePaperIsAMatterOfTheUnit) {
  for(const Recipe& recipe : well_shaped()) {
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    Literal_rules rules;
    rules.gradient_coefficient = true;
    const Pairs same = answer_to(mesh, rules).pairs, pairs = answer_to(mesh, {}).pairs;
    ASSERT_EQ(same.size(), pairs.size());
    EXPECT_NEAR(total_length(same) / total_length(pairs), 1., 1e-6);
    rules.mean_edge_length = 1.;
    const Answer answer = answer_to(mesh, rules);
    EXPECT_NE(answer.failure.find("came to rest"), std::string::npos) << answer.failure;
    EXPECT_TRUE(answer.pairs.empty());
  }
}

TEST(Literal_rules, FindTheLoopsOfTubes) {
  Literal_rules finite_elements, covered_area, first_reached, refined_always;
  finite_elements.finite_elements = true;
  covered_area.covered_area = true;
  first_reached.first_reached = true;
  refined_always.refined_always = true;
  for(const Recipe& recipe : well_shaped()) {
    const Mesh mesh = mesh_of(recipe);
    const double length = total_length(answer_to(mesh, {}).pairs);
    for(const Literal_rules& rules : {finite_elements, covered_area, first_reached, refined_always})
    {
      SCOPED_TRACE(recipe);
      const Answer answer = answer_to(mesh, rules);
      EXPECT_EQ(answer.failure, "");
      EXPECT_EQ(answer.pairs.size(), recipe.request.genus);
      EXPECT_LT(total_length(answer.pairs), 2. * length);
    }
  }
}

// Layers that have just split still overlap, and this is no handle.
TEST(Literal_rules, OfBandsDependOnWhenTheyTouch) {
  const Mesh mesh = mesh_of(Recipe{"knot", {10000, 1, 0}});
  Literal_rules rules;
  rules.bands = true;
  EXPECT_NE(answer_to(mesh, rules).failure, "");
  rules.contact_threshold = 0.1;
  const Answer answer = answer_to(mesh, rules);
  EXPECT_EQ(answer.failure, "");
  EXPECT_EQ(answer.pairs.size(), 1u);
}

TEST(Literal_rules, TellHowFarTheyCame) {
  const Mesh mesh = mesh_of(Recipe{"knot", {10000, 1, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  solver.find_loops<CGAL::Reference_tag>(CGAL::Emptyset_iterator());
  const Statistics& s = solver.statistics();
  EXPECT_EQ(s.swept_handles, 1u);
  EXPECT_EQ(s.traced_tunnels + s.kept_sweep_tunnels, 1u);
  EXPECT_EQ(s.refined_handles + s.kept_sweep_handles, 1u);
  Solver_options options;
  options.literal_rules.bands = true;
  EXPECT_THROW(solver.find_loops<CGAL::Reference_tag>(CGAL::Emptyset_iterator(),
                                                      params::solver_options(options)),
               Literal_failure_exception);
  EXPECT_NE(s.swept_handles, 1u);
  EXPECT_EQ(s.traced_tunnels, 0u);
}

// On a mesh of any kind there is an answer, which was certified, or a reason, and then nothing
// else.
TEST(Literal_rules, GiveAnAnswerOrAReason) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 1)) {
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe); // small: what comes to rest takes its time
    for(const double contact : {0., 0.1}) {
      Literal_rules rules = Literal_rules::all();
      rules.finite_elements = contact == 0.;
      rules.contact_threshold = contact;
      const Answer answer = answer_to(mesh, rules);
      EXPECT_EQ(answer.failure.empty(), !answer.pairs.empty());
    }
  }
}

TEST(Literal_rules, AllButThoseOfTheFieldHaveAnswers) {
  Literal_rules rules = Literal_rules::all();
  rules.bands = rules.finite_elements = false;
  for(const Recipe& recipe : well_shaped()) {
    SCOPED_TRACE(recipe);
    const Answer answer = answer_to(mesh_of(recipe), rules);
    EXPECT_EQ(answer.failure, "");
    EXPECT_EQ(answer.pairs.size(), recipe.request.genus);
  }
}

// In whatever unit the mesh is.
TEST(Literal_rules, OffsetsNameTheLoopsOfTubes) {
  Literal_rules rules;
  rules.finite_offset = true;
  const Soup torus = soup_of({"torus", {3100, 1, 0}});
  for(const double scale : {1e-3, 1., 1e3}) {
    const Pairs named = find_loops(mesh_of(transformed(torus, scale, 0.)));
    for(const double offset : {0.1, 1.}) {
      rules.offset = offset;
      const Pairs pairs = answer_to(mesh_of(transformed(torus, scale, 0.)), rules).pairs;
      ASSERT_EQ(pairs.size(), 1u);
      EXPECT_NEAR(pairs[0].handle().length() / named[0].handle().length(), 1., 0.1);
    }
  }
}

TEST(Literal_rules, AreRefusedOutOfTheirRanges) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  for(double Literal_rules::*const number :
      {&Literal_rules::mean_edge_length, &Literal_rules::band_threshold,
       &Literal_rules::contact_threshold, &Literal_rules::offset})
    for(const double value :
        {-1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
      Literal_rules rules;
      rules.*number = value;
      EXPECT_THROW(answer_to(mesh, rules), std::invalid_argument);
    }
}

// ---- bands

TEST(Band_components, AreRingsAroundALayer) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {3100, 1, 0}});
  reference::Band_components bands(mesh, 0.3);
  std::vector<double> values(mesh.number_of_vertices(), 0.);
  EXPECT_EQ(bands.find(values), 0u);
  values.assign(values.size(), 1.);
  EXPECT_EQ(bands.find(values), 0u);
  // A disc with a rim, and another one far from it.
  const auto set_disc = [&](Index center) {
    for(const Index u : mesh.ring(center))
      for(const Index w : mesh.ring(u))
        values[w] = 0.5;
    for(const Index u : mesh.ring(center))
      values[u] = 1.;
    values[center] = 1.;
  };
  values.assign(values.size(), 0.);
  set_disc(0);
  EXPECT_EQ(bands.find(values), 1u);
  bands.take([&](Index, Index component) { EXPECT_EQ(component, 0u); });
  Index far = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(norm(mesh.points[v] - mesh.points[0]) > norm(mesh.points[far] - mesh.points[0]))
      far = v;
  set_disc(far);
  EXPECT_EQ(bands.find(values), 2u);
}

} // namespace test_literal_rules
