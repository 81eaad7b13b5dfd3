// Meshes on the same surface with shorter edges, and what stands on the mesh for their vertices.

#include "Crossing_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/classes/Search_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Handle_tunnel_loops::internal;

using Face = std::array<Index, 3>;

std::vector<Face> faces_of(const Flat_mesh& mesh) {
  std::vector<Face> faces;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(Index p = 0; p < mesh.ring(v).size(); ++p) {
      const Index a = mesh.ring(v)[p], b = mesh.ring(v)[mesh.ring(v).next(p)];
      if(v < a && v < b)
        faces.push_back({v, a, b});
    }
  return faces;
}

Vector normal(const Flat_mesh& mesh, const Face& f) {
  return cross(mesh.points[f[1]] - mesh.points[f[0]], mesh.points[f[2]] - mesh.points[f[0]]);
}

double longest_edge(const Flat_mesh& mesh) {
  double longest = 0.;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(const Index u : mesh.ring(v))
      longest = (std::max)(longest, norm(mesh.points[u] - mesh.points[v]));
  return longest;
}

// Each edge has a triangle at its left that is the same from each of its corners.
void expect_closed_manifold(const Flat_mesh& mesh) {
  const Index n = static_cast<Index>(mesh.number_of_vertices());
  ASSERT_EQ(mesh.row_begin.size(), n + std::size_t(1));
  ASSERT_EQ(mesh.neighbor.size() % 3, 0u);
  for(Index v = 0; v < n; ++v) {
    const Ring ring = mesh.ring(v);
    ASSERT_GE(ring.size(), 3u);
    EXPECT_EQ(std::set<Index>(ring.begin(), ring.end()).size(), ring.size());
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      ASSERT_LT(a, n);
      ASSERT_NE(a, v);
      ASSERT_LT(mesh.ring(a).position(b), mesh.ring(a).size());
      EXPECT_EQ(mesh.ring(a).after(b), v);
      EXPECT_EQ(mesh.ring(b).after(v), a);
    }
  }
}

std::size_t genus_of(const Flat_mesh& mesh) {
  return (2 + mesh.neighbor.size() / 2 - mesh.number_of_vertices() - mesh.neighbor.size() / 3) / 2;
}

// The triangles on each face of the first mesh have its normal and its area together. A triangle
// is on a face if all its points are; it is known by the corners.
class Refinement
{
public:
  Refinement(const Flat_mesh& mesh, const Flat_mesh& finer, const std::vector<Index>& corners)
      : mesh_(mesh)
      , finer_(finer)
      , corners_(corners) {
    for(const Face& f : faces_of(mesh)) {
      for(const Index v : f)
        faces_at_[v].push_back(faces_.size());
      faces_.push_back(f);
    }
  }

  void expect_on_same_surface() const {
    const double size = longest_edge(mesh_);
    std::vector<double> area(faces_.size(), 0.);
    for(const Face& t : faces_of(finer_)) {
      const std::vector<std::size_t> on = faces_under(t, 1e-9 * size);
      ASSERT_FALSE(on.empty()) << "a triangle lies on no face of which its vertices have corners";
      const Vector n = normal(finer_, t), m = normal(mesh_, faces_[on.front()]);
      EXPECT_GT(dot(n, m), 0.);
      area[on.front()] += norm(n);
    }
    for(std::size_t f = 0; f < faces_.size(); ++f)
      EXPECT_NEAR(area[f], norm(normal(mesh_, faces_[f])), 1e-9 * size * size);
  }

private:
  bool is_corner(std::size_t f, Index v) const {
    return std::find(faces_[f].begin(), faces_[f].end(), v) != faces_[f].end();
  }

  bool is_on(std::size_t f, const Vector& p, double tolerance) const {
    const Face& face = faces_[f];
    const Vector n = normal(mesh_, face);
    const double area = norm(n);
    if(std::abs(dot(n, p - mesh_.points[face[0]])) > tolerance * area)
      return false;
    for(int i = 0; i < 3; ++i) {
      const Vector &a = mesh_.points[face[i]], &b = mesh_.points[face[(i + 1) % 3]];
      if(dot(cross(b - a, p - a), n) < -tolerance * area * norm(b - a))
        return false;
    }
    return true;
  }

  std::vector<std::size_t> faces_under(const Face& t, double tolerance) const {
    std::vector<std::size_t> found;
    for(const std::size_t f : faces_at_.at(corners_[t[0]]))
      if(std::all_of(t.begin(), t.end(), [&](Index v) {
           return is_corner(f, corners_[v]) && is_on(f, finer_.points[v], tolerance);
         }))
        found.push_back(f);
    return found;
  }

  const Flat_mesh &mesh_, &finer_;
  const std::vector<Index>& corners_;
  std::vector<Face> faces_;
  std::map<Index, std::vector<std::size_t>> faces_at_;
};

std::vector<Recipe> recipes() {
  std::vector<Recipe> recipes = {
      {"torus", {100, 1, 0}},    {"knot", {200, 1, 0}},   {"multi-torus", {600, 2, 0}},
      {"lattice", {1200, 3, 1}}, {"sponge", {100, 1, 0}}, {"sponge", {200, 4, 0}},
      {"random", {200, 2, 0}},   {"random", {60, 3, 1}},  {"torus-link", {800, 1, 0}}};
  recipes.back().request.p = 1; // one component
  return recipes;
}

// Closed walks at random keep their intersection numbers, hence their classes.
void expect_same_classes(const Flat_mesh& mesh,
                         const Flat_mesh& finer,
                         const std::vector<Index>& corners,
                         Random& random) {
  std::vector<Crossing_loop> loops, loops_of_corners;
  while(loops.size() < 8) {
    const Vertex_walk walk = random_walk_without_spurs(finer, random);
    Vertex_walk of_corners;
    for(const Index v : walk) {
      const Index c = corners[v];
      if(!of_corners.empty() && of_corners.back() != c) {
        ASSERT_LT(mesh.ring(of_corners.back()).position(c), mesh.ring(of_corners.back()).size());
      }
      if(of_corners.empty() || of_corners.back() != c)
        of_corners.push_back(c);
    }
    remove_spurs(of_corners);
    loops.push_back(pushed_left(finer, walk));
    loops_of_corners.push_back(of_corners.size() < 3 ? Crossing_loop()
                                                     : pushed_left(mesh, of_corners));
  }
  EXPECT_EQ(
      intersection_matrix(loops, Crossing_index(finer, loops), loops.size()),
      intersection_matrix(loops_of_corners, Crossing_index(mesh, loops_of_corners), loops.size()));
}

TEST(Edge_splitting, FitsTheSameSurface) {
  Random random(1);
  for(const Recipe& recipe : recipes())
    for(const double part : {0.7, 0.3, 0.15}) {
      SCOPED_TRACE(testing::PrintToString(recipe));
      const Flat_mesh mesh = flat_mesh_of(recipe);
      const double longest = part * longest_edge(mesh);
      Edge_splitting splitting(mesh);
      splitting.split(longest, 1000000);
      const Flat_mesh finer = splitting.mesh();
      const std::vector<Index>& corners = splitting.corners();
      ASSERT_EQ(corners.size(), finer.number_of_vertices());
      EXPECT_GT(finer.number_of_vertices(), mesh.number_of_vertices());
      EXPECT_LE(longest_edge(finer), longest);
      ASSERT_NO_FATAL_FAILURE(expect_closed_manifold(finer));
      EXPECT_EQ(genus_of(finer), mesh.genus);
      // The first vertices are those of the mesh.
      for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
        EXPECT_EQ(corners[v], v);
        EXPECT_EQ(norm(finer.points[v] - mesh.points[v]), 0.);
      }
      // Random surfaces have faces without area, and faces in one place.
      if(recipe.kind != "random") {
        ASSERT_NO_FATAL_FAILURE(Refinement(mesh, finer, corners).expect_on_same_surface());
      }
      for(int i = 0; i < 3; ++i)
        expect_same_classes(mesh, finer, corners, random);
    }
}

TEST(Edge_splitting, StopsAtSoManyVertices) {
  for(const Recipe& recipe : recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(const std::size_t more : {0, 1, 2, 10, 100}) {
      const std::size_t n = mesh.number_of_vertices() + more;
      Edge_splitting splitting(mesh);
      splitting.split(0., n);
      const Flat_mesh finer = splitting.mesh();
      EXPECT_EQ(finer.number_of_vertices(), n);
      expect_closed_manifold(finer);
      EXPECT_EQ(genus_of(finer), mesh.genus);
      if(recipe.kind != "random")
        Refinement(mesh, finer, splitting.corners()).expect_on_same_surface();
    }
    Edge_splitting splitting(mesh);
    splitting.split(longest_edge(mesh), 1000000);
    EXPECT_EQ(splitting.corners().size(), mesh.number_of_vertices());
    EXPECT_EQ(faces_of(splitting.mesh()).size(), mesh.number_of_faces());
  }
}

// The least angle of all triangles.
double least_angle(const Flat_mesh& mesh) {
  double least = 4.;
  for(const Face& f : faces_of(mesh))
    for(int i = 0; i < 3; ++i) {
      const Vector u = mesh.points[f[(i + 1) % 3]] - mesh.points[f[i]],
                   v = mesh.points[f[(i + 2) % 3]] - mesh.points[f[i]];
      least = (std::min)(least, std::atan2(norm(cross(u, v)), dot(u, v)));
    }
  return least;
}

// Rivara proves it of triangles of which the longest edge is split. That an edge is the longest of
// all is more than that.
TEST(Edge_splitting, HalvesAnglesAtMost) {
  for(const Recipe& recipe : recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    if(recipe.kind == "random")
      continue;
    Edge_splitting splitting(mesh);
    splitting.split(0.2 * longest_edge(mesh), 1000000);
    EXPECT_GE(least_angle(splitting.mesh()), 0.5 * (1. - 1e-9) * least_angle(mesh)) << recipe;
  }
}

// ---- the mesh to search on

void expect_steps(const Flat_mesh& mesh, const Search_mesh& search_mesh) {
  for(Index v = 0; v < search_mesh.number_of_vertices(); ++v)
    for(Index p = 0; p < search_mesh.ring(v).size(); ++p) {
      const Index u = search_mesh.ring(v)[p], step = search_mesh.step(v, p);
      const Index from = search_mesh.corner(v), to = search_mesh.corner(u);
      if(from == to) {
        EXPECT_EQ(step, no_index);
        continue;
      }
      ASSERT_LT(step, mesh.ring(from).size());
      EXPECT_EQ(mesh.ring(from)[step], to);
      EXPECT_NEAR(search_mesh.edge_length(v, p), norm(search_mesh.point(u) - search_mesh.point(v)),
                  1e-6 * search_mesh.edge_length(v, p));
    }
}

TEST(Search_mesh, IsTheMeshAtFirst) {
  for(const Recipe& recipe : recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Search_mesh search_mesh(mesh);
    EXPECT_EQ(search_mesh.number_of_vertices(), mesh.number_of_vertices());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      EXPECT_EQ(search_mesh.corner(v), v);
    expect_steps(mesh, search_mesh);
    search_mesh.measure();
    expect_steps(mesh, search_mesh);
  }
}

TEST(Search_mesh, CanBeRefined) {
  for(const Recipe& recipe : recipes())
    for(const std::size_t n : {0, 500, 3000}) {
      SCOPED_TRACE(testing::PrintToString(recipe));
      const Flat_mesh mesh = flat_mesh_of(recipe);
      Search_mesh search_mesh(mesh);
      const double area = search_mesh.area();
      search_mesh.refine(n);
      EXPECT_LE(search_mesh.number_of_vertices(), 2 * (std::max)(n, mesh.number_of_vertices()) + 1);
      EXPECT_GE(2 * search_mesh.number_of_vertices(), n);
      EXPECT_NEAR(search_mesh.area(), area, 1e-9 * area);
      expect_steps(mesh, search_mesh);
      std::vector<float> lengths;
      for(Index p = 0; p < search_mesh.ring(0).size(); ++p)
        lengths.push_back(search_mesh.edge_length(0, p));
      search_mesh.measure();
      expect_steps(mesh, search_mesh);
      for(Index p = 0; p < search_mesh.ring(0).size(); ++p)
        EXPECT_EQ(lengths[p], search_mesh.edge_length(0, p));
    }
}

// By steps towards a place one comes near it, and to the place itself if it is a vertex beside.
TEST(Search_mesh, LeadsTowardsPlaces) {
  Random random(2);
  for(const Recipe& recipe : recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Search_mesh search_mesh(mesh);
    search_mesh.refine(1000);
    for(int i = 0; i < 100; ++i) {
      const Index v = static_cast<Index>(random.below(search_mesh.number_of_vertices()));
      const Vector place = search_mesh.point(v);
      const Index found = search_mesh.vertex_near(place, search_mesh.corner(v));
      const double distance = norm(search_mesh.point(found) - place);
      EXPECT_LE(distance, norm(search_mesh.point(search_mesh.corner(v)) - place));
      for(const Index u : search_mesh.ring(found))
        EXPECT_LE(distance, norm(search_mesh.point(u) - place));
      for(const Index u : search_mesh.ring(v))
        EXPECT_EQ(norm(search_mesh.point(search_mesh.vertex_near(place, v)) - place), 0.) << u;
    }
  }
}

} // namespace
