#include "generators/Shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace test_shape {

using namespace CGAL::Handle_tunnel_loops::generators;

Vector normal(const Soup& soup, const std::array<std::uint32_t, 3>& triangle) {
  std::array<Vector, 3> p;
  for(int i = 0; i < 3; ++i) {
    const auto& [x, y, z] = soup.points[triangle[i]];
    p[i] = Vector(x, y, z);
  }
  return unit(CGAL::cross_product(p[1] - p[0], p[2] - p[0]));
}

// The largest angle that the surface turns by at an edge of a mesh.
double largest_turn(const Soup& soup) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector> left;
  for(const auto& triangle : soup.triangles)
    for(int i = 0; i < 3; ++i)
      left[{triangle[i], triangle[(i + 1) % 3]}] = normal(soup, triangle);
  double least = 1.;
  for(const auto& [edge, n] : left)
    least = (std::min)(least, n * left.at({edge.second, edge.first}));
  return std::acos(least);
}

TEST(Shape, IsWhatItsTextSays) {
  for(const Kind& kind : kinds_of_shapes()) {
    SCOPED_TRACE(kind.name);
    Request request;
    request.faces = kind.default_faces;
    request.genus = kind.default_genus;
    const Soup soup = kind.make(request);
    EXPECT_EQ(genus(soup), kind.default_genus);
    EXPECT_EQ(number_of_boundaries(soup), 0u);
    EXPECT_NEAR(double(soup.triangles.size()), double(request.faces), 0.1 * request.faces);
    request.genus += 1;
    EXPECT_THROW(kind.make(request), std::invalid_argument);
  }
}

TEST(Shape, PartsAreJoinedCutRepeatedAndTurned) {
  const Shape shape("# a thing\n"
                    "block 0 0 0  4 4 1  0\n"
                    "times 2 by 2 0 0 times 2 by 0 2 0 cut cylinder 1 1 -1  1 1 2  0.5\n"
                    "times 4 around 2 2 0  0 0 1 ball 6 2 0.5 0.25\n");
  EXPECT_EQ(shape.description(), "a thing");
  EXPECT_FALSE(shape.genus());
  using V = Vector;
  EXPECT_LT(shape(V(2., 2., 0.5)), 0.);
  for(const double x : {1., 3.})
    for(const double y : {1., 3.})
      EXPECT_NEAR(shape(V(x, y, 0.5)), 0.5, 1e-12) << "in the middle of a bore";
  for(const V& middle : {V(6., 2., 0.5), V(2., 6., 0.5), V(-2., 2., 0.5), V(2., -2., 0.5)})
    EXPECT_NEAR(shape(middle), -0.25, 1e-12);
  EXPECT_LT(shape.box().low.x(), -2.25);
  EXPECT_GT(shape.box().high.y(), 6.25);
}

// Nowhere more than the distance: along any segment it changes by no more than its length.
TEST(Shape, IsNowhereMoreThanTheDistance) {
  const Shape shape("blend 0.2\nball 0 0 0 1\nrod 0 0 0 2 1 0 0.3\ncylinder 0 0 -2 0 0 2 0.4\n"
                    "ring 0 0 0 1 1 0 2 0.2\nblock 1 1 1 2 2 2 0.1\nknot 2 3 2 0.5 0.2\n"
                    "pipe 0.1 closed 2 0 0 0 2 0 -2 0 0 0 -2 0\ncut ball 1 0 0 0.5\n");
  const Shape rounded = shape.rounded(0.15);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-3., 3.);
  for(int i = 0; i < 20000; ++i) {
    const Vector p(coordinate(random), coordinate(random), coordinate(random));
    const Vector step(0.1 * coordinate(random), 0.1 * coordinate(random), 0.1 * coordinate(random));
    EXPECT_LE(std::abs(shape(p + step) - shape(p)), length(step) * (1. + 1e-9));
    EXPECT_LE(std::abs(rounded(p + step) - rounded(p)), length(step) * (1. + 1e-9));
  }
}

TEST(Shape, ATextThatIsNoneIsRefusedWithItsLine) {
  const std::pair<const char*, const char*> wrong[] = {
      {"# nothing\n", "no parts"},
      {"ball 0 0 0\n", "line 1"},
      {"ball 0 0 0 1\nbox 0 0 0 1 1 1\n", "line 2"},
      {"ball 0 0 0 1 1\n", "unexpected '1'"},
      {"ball 0 0 0 -1\n", "positive"},
      {"rod 0 0 0 0 0 0 1\n", "length"},
      {"ring 0 0 0 0 0 0 1 1\n", "direction"},
      {"times 3 ball 0 0 0 1\n", "times"},
      {"times nan by 0 0 1 ball 0 0 0 1\n", "line 1"},
      {"", "the shape has no parts"},
      {"ball 0 0 0 1e300\n", "too large"},
      {"ball 0 0 0 1e-200\n", "too small"},
      {"ball 1e15 0 0 1\n", "too far"},
      {"times 200 by 1 0 0 cut ball 0 0 0 1\n", "empty"},
      {"pipe 0.1 0 0 0\n", "two points"},
      {"times 101 by 1 0 0 times 100 by 0 1 0 ball 0 0 0 1\n", "more than 10000"},
      {"times 9999 by 1 0 0 ball 0 0 0 1\nball 0 0 0 1\nball 0 0 0 1\n", "line 3"},
      {"genus -1\nball 0 0 0 1\n", "whole number"},
      {"faces 1e30\nball 0 0 0 1\n", "whole number"},
      {"cut\n", "must be followed by a part"}};
  for(const auto& [text, words] : wrong)
    try {
      const Shape shape(text);
      ADD_FAILURE() << text;
    } catch(const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

// Where there is no surface, or none that a lattice of such a size meets, the search for the right
// size ends.
TEST(Shape, WithoutASurfaceIsRefused) {
  const std::pair<const char*, const char*> wrong[] = {
      {"ball 0 0 0 1\ncut ball 0 0 0 2\n", "the shape is empty"},
      {"ball 0 0 0 1\ncut ball 0 0 0 1.0001\n", "2000 faces"},
      {"ball 0 0 0 0.001\nball 100 0 0 0.001\n", "2000 faces"},
      {"ball 0 0 0 0.001\nball 100 100 100 0.001\n", "2000 faces"},
      // For these the search would go on for hours.
      {"times 100 by 10 0 0 times 100 by 0 10 0 ball 0 0 0 0.001\n", "too thin for 2000 faces"},
      {"times 100 by 9 0 0 times 100 by 0 9 0 rod 0 0 0 5 0 0 0.001\n", "too thin for 2000 faces"}};
  Request request;
  request.faces = 2000;
  for(const auto& [text, words] : wrong)
    try {
      mesh_of_shape(Shape(text), request, "shape");
      ADD_FAILURE() << text;
    } catch(const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(Shape, TooFewFacesAreRefusedWithANumberThatIsEnough) {
  const Shape mug(
      "genus 1\npipe 0.13  0.9 0 1.8  1.45 0 1.78  1.75 0 1.25  1.5 0 0.62  0.9 0 0.42\n"
      "cylinder 0 0 0  0 0 2.2  1\ncut cylinder 0 0 0.2  0 0 3  0.84\n");
  for(const std::size_t faces : {1, 100, 2000}) {
    Request request;
    request.faces = faces;
    std::string message;
    try {
      mesh_of_shape(mug, request, "mug");
    } catch(const std::invalid_argument& error) {
      message = error.what();
    }
    EXPECT_EQ(message.find(std::to_string(faces) + " face"), 0u) << message;
    const std::size_t at = message.rfind("; ");
    ASSERT_NE(at, std::string::npos) << message;
    request.faces = std::stoul(message.substr(at + 2));
    EXPECT_EQ(genus(mesh_of_shape(mug, request, "mug")), 1u) << message;
  }
}

TEST(Shape, AGenusThatNoNumberOfFacesShowsIsRefused) {
  Request request;
  request.faces = 50000;
  try {
    mesh_of_shape(Shape("genus 2\nball 0 0 0 1\n"), request, "shape");
    ADD_FAILURE();
  } catch(const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("up to 400000, gives genus 2"), std::string::npos)
        << error.what();
  }
}

TEST(Shape, RoundedEdgesLoseLittle) {
  const Shape shape("cylinder 0 0 0  0 0 2  1\ncut cylinder 0 0 -1  0 0 3  0.5\n");
  const Shape rounded = shape.rounded(0.1);
  EXPECT_LT(shape(Vector(0.99, 0., 0.01)), 0.) << "at an edge";
  EXPECT_GT(rounded(Vector(0.99, 0., 0.01)), 0.) << "at an edge";
  EXPECT_GT(rounded(Vector(0.51, 0., 0.01)), 0.) << "at an edge of what is cut out";
  for(const Vector& p : {Vector(1., 0., 1.), Vector(0.5, 0., 1.), Vector(0.75, 0., 0.)})
    EXPECT_NEAR(rounded(p), 0., 1e-12) << "away from the edges";
}

// The mesh of a cup with flat ends: nowhere does it turn by a right angle at once.
TEST(Shape, EdgesAreNoSaws) {
  Request request;
  request.faces = 20000;
  const Soup soup = mesh_of_shape(
      Shape("cylinder 0 0 0  0 0 2  1\ncut cylinder 0 0 0.3  0 0 3  0.7\n"), request, "shape");
  EXPECT_EQ(genus(soup), 0u);
  EXPECT_LT(largest_turn(soup), 1.);
}

} // namespace test_shape
