// Meshes on the same surface with shorter edges, and what stands on the mesh for their vertices.

#include "Crossing_loops.h"
#include "Walks_of_steps.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_search.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace test_search_mesh {

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

double longest_split(const Flat_mesh& mesh) { return 0.3 * longest_edge(mesh); }

TEST(Intrinsic_triangulation, SubdividesTheFaces) {
  for(const Recipe& recipe : recipes()) {
    if(recipe.kind == "random")
      continue; // faces may lie on each other
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Intrinsic_triangulation triangulation(mesh);
    triangulation.split(longest_split(mesh), 100000);
    const Flat_mesh finer = triangulation.subdivision();
    expect_closed_manifold(finer);
    EXPECT_EQ(genus_of(finer), genus_of(mesh));
    EXPECT_LE(longest_edge(finer), longest_split(mesh));
    Refinement(mesh, finer, triangulation.corners()).expect_on_same_surface();
    Intrinsic_triangulation limited(mesh);
    limited.split(0., mesh.number_of_vertices() + 10);
    EXPECT_EQ(limited.number_of_vertices(), mesh.number_of_vertices() + 10);
  }
}

TEST(Intrinsic_triangulation, KnowsWhichVerticesLieOnEdges) {
  for(const Recipe& recipe : recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Intrinsic_triangulation triangulation(mesh);
    triangulation.split(longest_split(mesh), 100000);
    const Flat_mesh finer = triangulation.subdivision();
    std::map<std::pair<Index, Index>, std::vector<double>> ratios; // by edge
    for(Index v = 0; v < finer.number_of_vertices(); ++v) {
      const auto& place = triangulation.places()[v];
      if(place.source == no_index)
        continue;
      const Vector p = mesh.points[place.source] +
                       place.ratio * (mesh.points[place.target] - mesh.points[place.source]);
      EXPECT_LE(norm(finer.points[v] - p), 1e-12);
      if(place.source == place.target)
        EXPECT_EQ(v, place.source);
      else {
        ASSERT_LT(mesh.ring(place.source).position(place.target), mesh.ring(place.source).size());
        ratios[std::minmax(place.source, place.target)].push_back(
            place.source < place.target ? place.ratio : 1. - place.ratio);
      }
    }
    // As many as it takes for an edge of this length to fall to pieces that are short enough.
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(const Index u : mesh.ring(v))
        if(v < u) {
          std::vector<double> all = ratios[{v, u}];
          all.insert(all.end(), {0., 1.});
          std::sort(all.begin(), all.end());
          for(std::size_t i = 1; i < all.size(); ++i)
            EXPECT_LE((all[i] - all[i - 1]) * norm(mesh.points[u] - mesh.points[v]),
                      (1. + 1e-12) * longest_split(mesh));
        }
  }
}

// The sum of the walks around each triangle is a point, so that the walk of each closed way in the
// triangulation is in the class of the way.
TEST(Intrinsic_triangulation, LeadsAroundNothing) {
  Random random(5);
  std::size_t flipped = 0;
  for(const Recipe& recipe : recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Crossing_index index(mesh, random_loops(mesh, random, 8));
    Intrinsic_triangulation t(mesh);
    t.split(longest_split(mesh), 2 * mesh.number_of_vertices());
    const Flat_mesh finer = t.subdivision();
    t.make_delaunay();
    ASSERT_EQ(t.number_of_halfedges(), finer.neighbor.size());
    for(Index h = 0; h < t.number_of_halfedges(); h += 3) {
      Sparse_numbers numbers;
      for(Index e = h; e < h + 3; ++e) {
        ASSERT_EQ(t.target(e), t.source(e == h + 2 ? h : e + 1));
        Index from = t.source(e);
        flipped += t.walk(e).size() > 1;
        for(const Index to : t.walk(e)) {
          ASSERT_LT(finer.ring(from).position(to), finer.ring(from).size());
          const Index u = t.corners()[from], w = t.corners()[to];
          if(u != w) {
            ASSERT_LT(mesh.ring(u).position(w), mesh.ring(u).size());
            index.add_crossings(u, w, numbers);
          }
          from = to;
        }
        EXPECT_EQ(from, t.target(e));
        EXPECT_GE(t.length(e),
                  (1. - 1e-9) * norm(finer.points[t.target(e)] - finer.points[t.source(e)]) -
                      1e-12);
      }
      for(const auto& number : numbers)
        EXPECT_EQ(number.second, 0);
    }
  }
  EXPECT_GT(flipped, 100u);
}

// No vertex comes where edges are short enough already; the shorter they are to be, the more come.
TEST(Search_mesh, IsAsFineAsItIsToBe) {
  for(const Recipe& recipe : recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const double longest = longest_edge(mesh);
    std::size_t before = mesh.number_of_vertices();
    for(const double fine_enough : {1.001 * longest, 0.5 * longest, 0.1 * longest}) {
      Search_mesh search_mesh(mesh);
      search_mesh.refine(5000, fine_enough);
      if(fine_enough > longest) {
        EXPECT_EQ(search_mesh.number_of_vertices(), before);
      }
      EXPECT_GE(search_mesh.number_of_vertices(), before);
      EXPECT_LE(search_mesh.number_of_vertices(), 5000 + (std::max)(std::size_t(5000), before));
      before = search_mesh.number_of_vertices();
    }
    EXPECT_GT(before, mesh.number_of_vertices());
  }
}

TEST(Search_mesh, HandsOnLoopsOfTheSameClass) {
  Random random(6);
  for(const Recipe& recipe : recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Crossing_index index(mesh, random_loops(mesh, random, 8));
    for(const std::size_t more : {0, 500}) {
      Search_mesh search_mesh(mesh);
      if(more > 0)
        search_mesh.refine(more);
      for(int i = 0; i < 20; ++i) {
        // Somewhere, along a random way, and back along another.
        std::vector<Index> walk(1, static_cast<Index>(random.below(mesh.number_of_vertices())));
        Sparse_numbers numbers;
        const auto go = [&](Index step) {
          const Index v = walk.back();
          for_each_edge(search_mesh, v, step, [&](Index from, Index to) {
            const Index u = search_mesh.corner(from), w = search_mesh.corner(to);
            if(u != w)
              index.add_crossings(u, w, numbers);
            walk.push_back(to);
          });
          ASSERT_EQ(walk.back(), search_mesh.head(step));
        };
        for(int n = 0; n < 60; ++n) {
          const Index v = walk.back();
          go(search_mesh.begin(v) +
             static_cast<Index>(random.below(search_mesh.end(v) - search_mesh.begin(v))));
        }
        for(int n = 0; walk.back() != walk.front() && n < 100000; ++n) {
          const Index v = walk.back();
          go(search_mesh.begin(v) +
             static_cast<Index>(random.below(search_mesh.end(v) - search_mesh.begin(v))));
        }
        if(walk.back() != walk.front())
          continue;
        remove_spurs(walk);
        if(walk.size() < 3)
          continue;
        const Crossing_loop loop = search_mesh.loop_along(walk);
        EXPECT_TRUE(loop.empty() || are_consecutive(mesh, loop));
        for(auto it = numbers.begin(); it != numbers.end();)
          it = it->second == 0 ? numbers.erase(it) : std::next(it);
        EXPECT_EQ(index.intersections(loop), numbers);
      }
    }
  }
}

// What steps cross is what their walks cross: by step, and by loop. Returns how many cross any.
std::size_t expect_walks_counted(const Search_mesh& mesh, const std::vector<Crossing_loop>& loops) {
  std::vector<std::map<std::pair<Index, Index>, int>> wanted(loops.size()); // by vertex and step
  std::size_t crossed = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(Index step = mesh.begin(v); step != mesh.end(v); ++step) {
      for_each_edge(mesh, v, step, [&](Index from, Index to) {
        mesh.for_each_term(from, to, [&](Index loop, int n) { wanted[loop][{v, step}] += n; });
      });
      crossed += !mesh.sums_from(v)[step].is_zero();
    }
  Steps_across across(mesh);
  for(Index loop = 0; loop < loops.size(); ++loop) {
    across.find(loops[loop], loop);
    std::set<std::pair<Index, Index>> found;
    across.for_each([&](const Steps_across::Step& s, int number) {
      found.insert({s.from, s.name});
      EXPECT_NE(number, 0);
    });
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index step = mesh.begin(v); step != mesh.end(v); ++step) {
        const auto w = wanted[loop].find({v, step});
        const int number = w == wanted[loop].end() ? 0 : w->second;
        EXPECT_EQ(across(v, step), number);
        EXPECT_EQ(found.count({v, mesh.name(step)}), number != 0);
      }
  }
  return crossed;
}

// The sums of a step are those of the loops that its walk crosses.
void expect_sums(const Search_mesh& mesh) {
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(Index step = mesh.begin(v); step != mesh.end(v); ++step) {
      Class_sums sums;
      for_each_edge(mesh, v, step, [&](Index from, Index to) {
        mesh.for_each_term(from, to, [&](Index loop, int n) { sums.add(n, mesh.weight(loop)); });
      });
      EXPECT_EQ(mesh.sums_from(v)[step], sums);
    }
}

// Also where it is counted backwards, or by steps of a finer mesh.
TEST(Search_mesh, CountsWhatItsWalksCross) {
  Random random(7);
  for(const Recipe& recipe : recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> loops = random_loops(mesh, random, 8);
    const Crossing_index index(mesh, loops);
    const Edge_classes classes(std::make_shared<const Edge_crossings>(Execution(), mesh, index),
                               random_weights({1, 0, 1, 0}));
    for(const std::size_t more : {0, 500}) {
      Search_mesh finer(mesh);
      if(more > 0)
        finer.refine(more);
      finer.count(classes);
      Search_mesh coarser(finer, 4. * std::sqrt(finer.area() / double(finer.number_of_vertices())));
      coarser.count(classes);
      for(const Search_mesh* searched : {&finer, &coarser}) {
        EXPECT_GT(expect_walks_counted(*searched, loops), 0u);
        expect_sums(*searched);
      }
    }
  }
}

} // namespace test_search_mesh
