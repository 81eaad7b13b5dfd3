#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Caps_in_vain.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Collar.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Divided_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_surgery.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_anew.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_around_vertex.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangulated_polygon.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Object.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_surgery {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using impl::Closed_walk;
using impl::Curve_off_vertices;
using impl::Cut_region;
using impl::Index;
using impl::no_index;
using impl::Surgery_mesh;

Recipe recipe(const char* kind, std::size_t faces, std::size_t genus) {
  Recipe recipe;
  recipe.kind = kind;
  recipe.request.faces = faces;
  recipe.request.genus = genus;
  return recipe;
}

Surgery_mesh surgery_mesh_of(Mesh& mesh) {
  const auto face_index = get(CGAL::face_index, mesh);
  const impl::Triangle_reader<Mesh, std::decay_t<decltype(face_index)>> reader(mesh, face_index);
  double unit = 1.;
  return impl::surgery_mesh_of(
      reader.read(impl::Execution(), get(CGAL::vertex_index, mesh), mesh.points()), unit);
}

// A surface, and a walk beside each loop of a basis: handle and tunnel loops in turn.
struct Surface_with_walks
{
  explicit Surface_with_walks(const Recipe& recipe)
      : input(mesh_of(recipe))
      , mesh(surgery_mesh_of(input)) {
    Pairs pairs;
    CGAL::handle_tunnel_loops(input, std::back_inserter(pairs));
    for(const auto& pair : pairs)
      for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
        std::vector<impl::Place_on_edge> places;
        for(const auto& step : loop->steps())
          places.push_back(
              {source(step.halfedge, input), target(step.halfedge, input), step.ratio});
        walks.push_back(impl::simple_part(impl::walk_beside(mesh, places)));
      }
  }

  Mesh input;
  Surgery_mesh mesh;
  std::vector<Closed_walk> walks;
};

// Classes of closed walks in homology modulo 2, by the closed curves on the dual graph that are no
// boundaries: where a walk crosses them.
class Classes_modulo_2
{
public:
  explicit Classes_modulo_2(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , parent_(mesh.face_bound(), no_index) {
    span_vertices();
    span_faces();
    for(Index h = 0; h < 3 * mesh.face_bound(); ++h)
      if(mesh.is_alive(mesh.face(h)) && h < mesh.twin(h) && in_tree_.count(edge(h)) == 0 &&
         parent_[mesh.face(h)] != mesh.twin(h) && parent_[mesh.face(mesh.twin(h))] != h)
        curves_.push_back(curve_through(h));
  }

  std::size_t rank() const { return curves_.size(); }

  std::vector<bool> of(const Closed_walk& walk) const {
    std::vector<bool> all(rank(), false);
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const Index h = mesh_.halfedge(walk[i], walk[(i + 1) % walk.size()]);
      for(std::size_t k = 0; k < rank(); ++k)
        all[k] = all[k] != (curves_[k].count(edge(h)) != 0);
    }
    return all;
  }

private:
  Index edge(Index h) const { return (std::min)(h, mesh_.twin(h)); }

  void span_vertices() {
    std::set<Index> reached;
    for(Index v = 0; v < mesh_.vertex_bound(); ++v) {
      if(mesh_.outgoing(v) == no_index || !reached.insert(v).second)
        continue;
      for(std::vector<Index> open{v}; !open.empty();) {
        const Index u = open.back();
        open.pop_back();
        mesh_.for_each_outgoing(u, [&](Index h) {
          if(reached.insert(mesh_.target(h)).second) {
            in_tree_.insert(edge(h));
            open.push_back(mesh_.target(h));
          }
        });
      }
    }
  }

  // Over edges that are not in the tree of the vertices; the way to the parent leads over the
  // halfedge whose face that is.
  void span_faces() {
    std::set<Index> reached;
    for(Index f = 0; f < mesh_.face_bound(); ++f) {
      if(!mesh_.is_alive(f) || !reached.insert(f).second)
        continue;
      for(std::vector<Index> open{f}; !open.empty();) {
        const Index g = open.back();
        open.pop_back();
        for(Index h : {3 * g, 3 * g + 1, 3 * g + 2})
          if(in_tree_.count(edge(h)) == 0 && reached.insert(mesh_.face(mesh_.twin(h))).second) {
            parent_[mesh_.face(mesh_.twin(h))] = h;
            open.push_back(mesh_.face(mesh_.twin(h)));
          }
      }
    }
  }

  std::set<Index> curve_through(Index h) const {
    std::set<Index> crossed{edge(h)};
    for(Index f : {mesh_.face(h), mesh_.face(mesh_.twin(h))})
      for(; parent_[f] != no_index; f = mesh_.face(parent_[f]))
        if(!crossed.insert(edge(parent_[f])).second)
          crossed.erase(edge(parent_[f])); // there and back
    return crossed;
  }

  const Surgery_mesh& mesh_;
  std::set<Index> in_tree_;
  std::vector<Index> parent_; // a halfedge of the parent, by face
  std::vector<std::set<Index>> curves_;
};

std::size_t rank_of(std::vector<std::vector<bool>> rows) {
  std::size_t rank = 0;
  for(std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + rank, rows.end(),
                                    [&](const std::vector<bool>& row) { return row[column]; });
    if(pivot == rows.end())
      continue;
    std::swap(rows[rank], *pivot);
    for(std::size_t i = rank + 1; i < rows.size(); ++i)
      if(rows[i][column])
        for(std::size_t k = 0; k < rows[i].size(); ++k)
          rows[i][k] = rows[i][k] != rows[rank][k];
    ++rank;
  }
  return rank;
}

std::vector<Recipe> surfaces() {
  return {recipe("torus", 2000, 1), recipe("gyroid", 12000, 6), recipe("lattice", 12000, 5),
          recipe("chain", 8000, 4)};
}

// Through the middle of the edges there.
Curve_off_vertices curve_around(const Surgery_mesh& mesh, Index v) {
  std::vector<impl::Place_on_edge> places;
  mesh.for_each_outgoing(v, [&](Index h) { places.push_back({v, mesh.target(h), 0.5}); });
  const std::optional<Curve_off_vertices> curve = Curve_off_vertices::beside(mesh, places);
  EXPECT_TRUE(curve);
  return *curve;
}

Curve_off_vertices curve_beside(const Surgery_mesh& mesh, const Closed_walk& walk) {
  std::optional<Curve_off_vertices> curve = Curve_off_vertices::beside(mesh, impl::places_of(walk));
  EXPECT_TRUE(curve);
  return *curve;
}

// Those beside some walks that share no vertex with one before.
std::vector<Curve_off_vertices> disjoint_curves(const Surgery_mesh& mesh,
                                                const std::vector<Closed_walk>& walks) {
  std::vector<Curve_off_vertices> curves;
  std::vector<char> is_taken(mesh.vertex_bound(), 0);
  for(const Closed_walk& walk : walks) {
    Curve_off_vertices curve = curve_beside(mesh, walk);
    const std::vector<Index> vertices = impl::vertices_of(mesh, curve.faces());
    if(std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return is_taken[v]; }))
      continue;
    for(Index v : vertices)
      is_taken[v] = 1;
    curves.push_back(std::move(curve));
  }
  return curves;
}

// The first ones, whether they cross anything or not.
impl::Patch caps_of(const Surgery_mesh& mesh, const Cut_region& region) {
  impl::Patch caps;
  impl::for_each_cap(mesh, region, [&](const impl::Patch& patch) {
    caps = patch;
    return true;
  });
  EXPECT_FALSE(caps.faces.empty());
  return caps;
}
impl::Patch membranes_of(const Surgery_mesh& mesh, const Curve_off_vertices& curve) {
  impl::Patch caps;
  impl::for_each_membrane(mesh, curve, impl::Divided_strip(mesh, curve),
                          impl::Polygon_in_space::INSIDE, [&](const impl::Patch& patch) {
                            caps = patch;
                            return true;
                          });
  EXPECT_FALSE(caps.faces.empty());
  return caps;
}

TEST(Surgery, TellsWhichWalksSeparate) {
  for(const Recipe& recipe : surfaces()) {
    const Surface_with_walks surface(recipe);
    impl::Separation separates;
    for(const Closed_walk& walk : surface.walks) {
      EXPECT_FALSE(
          separates(surface.mesh, impl::cut_along(surface.mesh, curve_beside(surface.mesh, walk))));
      if(const auto strip = Cut_region::around(surface.mesh, walk)) {
        EXPECT_FALSE(separates(surface.mesh, impl::cut_around(surface.mesh, *strip)));
      }
    }
    for(Index v = 0; v < surface.mesh.vertex_bound(); v += 97)
      EXPECT_TRUE(
          separates(surface.mesh, impl::cut_along(surface.mesh, curve_around(surface.mesh, v))));
  }
}

// ... as they are found one after the other.
TEST(Surgery, TellsWhichCutsSeparate) {
  for(const Recipe& recipe : surfaces()) {
    Surface_with_walks surface(recipe);
    Surgery_mesh& mesh = surface.mesh;
    std::vector<Closed_walk> walks = surface.walks;
    for(const Closed_walk& walk : surface.walks)
      if(std::optional<Cut_region> strip = Cut_region::around(mesh, walk)) {
        for(int ring = 0; strip && ring < 3; ++ring)
          strip = strip->wider(mesh, 0);
        if(strip) // a walk beside the other one
          walks.push_back(strip->vertices_of(mesh, 0));
      }
    const std::vector<Curve_off_vertices> curves = disjoint_curves(mesh, walks);
    std::vector<impl::Surface_cut> cuts;
    for(const Curve_off_vertices& curve : curves)
      cuts.push_back(impl::cut_along(mesh, curve));
    const std::vector<char> separates = impl::separating_cuts(impl::Execution(), mesh, cuts);
    impl::Separation separation;
    for(std::size_t i = 0; i < curves.size(); ++i) {
      ASSERT_EQ(bool(separates[i]), separation(mesh, impl::cut_along(mesh, curves[i])));
      if(!separates[i])
        impl::put_in_place(mesh, curves[i].faces(), membranes_of(mesh, curves[i]));
    }
    EXPECT_GT(std::count(separates.begin(), separates.end(), 0), 0);
    EXPECT_GT(std::count(separates.begin(), separates.end(), 1), 0);
  }
}

// ... and has gaps where something was taken out.
TEST(Surgery, MakesGraphsOfWhatIsThere) {
  for(const Recipe& recipe : surfaces()) {
    Surface_with_walks surface(recipe);
    Surgery_mesh& mesh = surface.mesh;
    const Curve_off_vertices curve = curve_beside(mesh, surface.walks.front());
    impl::put_in_place(mesh, curve.faces(), membranes_of(mesh, curve));
    ASSERT_LT(mesh.number_of_faces(), mesh.face_bound());
    const impl::Surgery_graph graph(mesh);
    const auto all_vertices = vertices(graph);
    const auto all_halfedges = halfedges(graph);
    const auto all_faces = faces(graph);
    EXPECT_EQ(std::size_t(std::distance(all_halfedges.begin(), all_halfedges.end())),
              num_halfedges(graph));
    EXPECT_EQ(std::size_t(std::distance(all_faces.begin(), all_faces.end())), num_faces(graph));
    for(Index v : all_vertices)
      ASSERT_EQ(target(halfedge(v, graph), graph), v);
    for(const auto h : all_halfedges) {
      ASSERT_EQ(source(opposite(h, graph), graph), target(h, graph));
      ASSERT_EQ(opposite(opposite(h, graph), graph), h);
      ASSERT_EQ(prev(next(h, graph), graph), h);
      ASSERT_EQ(face(next(h, graph), graph), face(h, graph));
      ASSERT_EQ(halfedge(source(h, graph), target(h, graph), graph), std::make_pair(h, true));
    }
    // V - E + F = 2 c - 2 g, and a handle is gone.
    const std::size_t number_left = surface.walks.size() / 2 - 1;
    const auto number_of_vertices = std::distance(all_vertices.begin(), all_vertices.end());
    const std::size_t components = impl::count_surface(impl::Execution(), mesh).components;
    EXPECT_EQ(std::size_t(number_of_vertices) + 2 * number_left,
              2 * components + num_faces(graph) / 2);
    EXPECT_EQ(impl::Loops_under_surgery(mesh).find(impl::Execution()).size(), number_left);
  }
}

// The same by exact constructions: whether triangles with an area have more in common than the
// corners that they share, and the side between two of these.
bool meet_elsewhere(const impl::Placed_triangle& a, const impl::Placed_triangle& b) {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const Surgery_mesh::Point& p) {
    return Exact::Point_3(p.x(), p.y(), p.z());
  };
  const auto triangle = [&](const impl::Placed_triangle& t) {
    return Exact::Triangle_3(exact(t.points[0]), exact(t.points[1]), exact(t.points[2]));
  };
  std::vector<Exact::Point_3> shared;
  for(std::size_t i = 0; i < 3; ++i)
    if(std::count(b.vertices.begin(), b.vertices.end(), a.vertices[i]) > 0)
      shared.push_back(exact(a.points[i]));
  const CGAL::Object common = CGAL::intersection(triangle(a), triangle(b));
  if(common.empty())
    return false;
  if(const auto* point = CGAL::object_cast<Exact::Point_3>(&common))
    return shared.size() != 1 || *point != shared[0];
  if(const auto* side = CGAL::object_cast<Exact::Segment_3>(&common))
    return shared.size() != 2 || (*side != Exact::Segment_3(shared[0], shared[1]) &&
                                  *side != Exact::Segment_3(shared[1], shared[0]));
  return true;
}

// On a small grid, where all cases come up: in a plane, at a corner, along a side.
TEST(Surgery, FindsContactsOfTriangles) {
  generators::Random random(3);
  const auto triangle = [&](bool is_flat) {
    impl::Placed_triangle t;
    for(std::size_t i = 0; i < 3; ++i) {
      std::array<std::size_t, 3> at = {random.below(3), random.below(3), random.below(3)};
      if(is_flat)
        at[2] = 2 - at[0];
      t.vertices[i] = static_cast<Index>(at[0] + 3 * at[1] + 9 * at[2]);
      t.points[i] = {double(at[0]), double(at[1]), double(at[2])};
    }
    return t;
  };
  std::array<std::size_t, 2> number = {0, 0};
  for(int k = 0; k < 20000; ++k) {
    const bool is_flat = k % 2 == 0;
    const impl::Placed_triangle a = triangle(is_flat), b = triangle(is_flat);
    const bool meet = impl::are_in_contact(a, b);
    ASSERT_EQ(meet, impl::are_in_contact(b, a)); // also if corners are named twice
    if(a.is_degenerate() || b.is_degenerate())
      continue;
    ASSERT_EQ(meet, meet_elsewhere(a, b)) << k;
    ++number[meet];
  }
  EXPECT_GT(number[0], 1000u);
  EXPECT_GT(number[1], 1000u);
}

// Puts the same face into the place of one, which is gone then.
void renew(Surgery_mesh& mesh, Index f) {
  const Surgery_mesh::Face corners = mesh.corners(f);
  mesh.replace({f}, {corners});
}

// ... by the numbers of faces.
impl::Caps_in_vain tried_with(Index out, Index around, Index met) {
  impl::Caps_in_vain tried{{out}, {}, {around}, {true, true, 1.}};
  tried.met = {met};
  return tried;
}

TEST(Caps_in_vain, HoldAsLongAsAllFacesThatSaySoAreThere) {
  Mesh input = mesh_of(recipe("torus", 200, 1));
  const Surgery_mesh before = surgery_mesh_of(input);
  const impl::Caps_in_vain tried = tried_with(1, 3, 5);
  EXPECT_TRUE(tried.holds(before));
  for(Index f = 0; f < 8; ++f) {
    Surgery_mesh mesh = before;
    renew(mesh, f);
    EXPECT_EQ(tried.holds(mesh), f != 1 && f != 3 && f != 5) << f;
  }
}

// What came after a copy was made is known to that copy by its number only, which may be taken.
TEST(Caps_in_vain, AreForgottenWhereTheirFacesNeverWere) {
  Mesh input = mesh_of(recipe("torus", 200, 1));
  const Surgery_mesh before = surgery_mesh_of(input);
  Surgery_mesh changed = before;
  renew(changed, 7);
  const Index late = changed.face_bound() - 1;
  impl::Removal_task task;
  *task.in_vain = {tried_with(late, 3, 5), tried_with(1, late, 5), tried_with(1, 3, late),
                   tried_with(1, 3, 5)};
  impl::Removal_task other = task;
  other.forget_what_is_not_of(changed);
  EXPECT_EQ(task.in_vain->size(), 4u);
  other.forget_what_is_not_of(before);
  ASSERT_EQ(task.in_vain->size(), 1u);
  EXPECT_EQ(task.in_vain->front().met, std::vector<Index>(1, 5));
}

// ... of a surface, with what is known from before.
void look_for_caps(impl::Handle_surgery& surgery,
                   const Surgery_mesh& mesh,
                   const impl::Intended_change& intended,
                   const std::vector<impl::Caps_in_vain>& known = {}) {
  impl::Mesh_contacts contacts(mesh);
  contacts.update(impl::Execution());
  surgery.find_caps(mesh, contacts, impl::Shape_judge(mesh, false), intended, known);
}

// Once all caps are in vain, because of faces that they meet among others.
void expect_not_made_again(impl::Handle_surgery& surgery,
                           const Surgery_mesh& mesh,
                           const impl::Intended_change& intended) {
  const impl::Caps_in_vain tried = *surgery.in_vain();
  const std::string why = surgery.obstacle().why;
  look_for_caps(surgery, mesh, intended, {tried});
  EXPECT_FALSE(surgery.has_caps() || surgery.in_vain());
  EXPECT_EQ(surgery.obstacle().why, why);
  impl::Intended_change other = intended;
  other.length *= 2.;
  look_for_caps(surgery, mesh, other, {tried});
  EXPECT_TRUE(surgery.has_caps() || surgery.in_vain());
  for(Index met : {tried.met.front(), tried.met.back()}) {
    Surgery_mesh changed = mesh;
    renew(changed, met);
    look_for_caps(surgery, changed, intended, {tried});
    EXPECT_TRUE(surgery.has_caps() || surgery.in_vain());
  }
}

TEST(Caps_in_vain, AreNotMadeAgainUntilSomethingIsOutOfTheirWay) {
  const Surface_with_walks surface(recipe("chain", 2000, 2));
  std::size_t number = 0;
  for(const Closed_walk& walk : surface.walks) {
    const std::optional<Cut_region> strip = Cut_region::around(surface.mesh, walk);
    ASSERT_TRUE(strip);
    const impl::Intended_change intended = {true, true, impl::length(surface.mesh, walk)};
    impl::Handle_surgery surgery(surface.mesh, *strip);
    look_for_caps(surgery, surface.mesh, intended);
    ASSERT_TRUE(surgery.has_caps() || surgery.in_vain());
    if(surgery.has_caps() || surgery.in_vain()->met.empty())
      continue;
    ++number;
    expect_not_made_again(surgery, surface.mesh, intended);
  }
  EXPECT_GT(number, 0u);
}

TEST(Caps_in_vain, AreNotMadeAgainWhereTheSurfaceCrossesItselfAllOver) {
  const Surface_with_walks surface(recipe("random", 2000, 10));
  impl::Mesh_contacts contacts(surface.mesh);
  contacts.update(impl::Execution());
  std::size_t number = 0;
  for(const Closed_walk& walk : surface.walks) {
    if(walk.size() < 3)
      continue;
    const auto curve = Curve_off_vertices::beside(surface.mesh, impl::places_of(walk));
    if(!curve)
      continue;
    const std::vector<Index> out = curve->faces();
    if(!impl::Former_contacts(surface.mesh, contacts, out).are_too_many())
      continue;
    const impl::Intended_change intended = {true, true, impl::length(surface.mesh, walk), false,
                                            true};
    impl::Handle_surgery surgery(surface.mesh, *curve);
    look_for_caps(surgery, surface.mesh, intended);
    ASSERT_TRUE(surgery.in_vain());
    if(surgery.in_vain()->met.empty())
      continue; // all caps would meet each other
    ++number;
    expect_not_made_again(surgery, surface.mesh, intended);
  }
  EXPECT_GT(number, 0u);
}

// Pieces of memory, so that what is allocated later is in an order of its own.
std::vector<std::vector<char>> scattered_memory(unsigned seed) {
  generators::Random random(seed);
  std::vector<std::vector<char>> pieces;
  for(std::size_t i = 0; i < 4000; ++i)
    pieces.emplace_back(16 + random.below(5000));
  for(std::vector<char>& piece : pieces)
    if(random.below(2) == 0)
      std::vector<char>().swap(piece);
  return pieces;
}

// Where a hole has several best triangulations, as on symmetric surfaces.
TEST(Surgery, MakesTheSameCapsWhereverTheyAreInMemory) {
  for(const Recipe& recipe : {recipe("torus", 2000, 1), recipe("knot", 1500, 1)}) {
    const Surface_with_walks surface(recipe);
    for(const Closed_walk& walk : surface.walks) {
      const std::optional<Cut_region> strip = Cut_region::around(surface.mesh, walk);
      ASSERT_TRUE(strip);
      const Curve_off_vertices curve = curve_beside(surface.mesh, walk);
      const auto all_caps = [&] {
        std::vector<impl::Patch> all;
        const auto take = [&](const impl::Patch& patch) {
          all.push_back(patch);
          return false;
        };
        impl::for_each_cap(surface.mesh, *strip, take);
        impl::for_each_membrane(surface.mesh, curve, impl::Divided_strip(surface.mesh, curve),
                                impl::Polygon_in_space::INSIDE, take);
        return all;
      };
      const std::vector<impl::Patch> expected = all_caps();
      ASSERT_GE(expected.size(), 4u);
      for(unsigned seed = 0; seed < 8; ++seed) {
        const auto memory = scattered_memory(seed);
        const std::vector<impl::Patch> caps = all_caps();
        ASSERT_EQ(caps.size(), expected.size());
        for(std::size_t i = 0; i < caps.size(); ++i) {
          EXPECT_EQ(caps[i].points, expected[i].points);
          EXPECT_EQ(caps[i].faces, expected[i].faces);
        }
      }
    }
  }
}

// In a ball that holds a loop, all classes; in one that holds none, none.
TEST(Surgery, FindsLoopsAroundVertices) {
  for(const Recipe& recipe : surfaces()) {
    const Surface_with_walks surface(recipe);
    const Surgery_mesh& mesh = surface.mesh;
    impl::Loops_around_vertex loops_around(mesh);
    const Classes_modulo_2 classes(mesh);
    const auto classes_of = [&](const std::vector<Closed_walk>& walks) {
      std::vector<std::vector<bool>> rows;
      for(const Closed_walk& walk : walks) {
        EXPECT_TRUE(impl::is_intact(mesh, walk) && impl::is_simple(walk));
        rows.push_back(classes.of(walk));
      }
      return rows;
    };
    for(const Closed_walk& lost : surface.walks) {
      std::vector<std::vector<bool>> rows = classes_of(
          loops_around(lost.front(), 0.7 * impl::length(mesh, lost), mesh.vertex_bound()));
      const std::size_t rank = rank_of(rows);
      EXPECT_GT(rank, 0);
      rows.push_back(classes.of(lost));
      EXPECT_EQ(rank_of(rows), rank);
    }
    const std::vector<Closed_walk> all = loops_around(0, 1e9, mesh.vertex_bound());
    const std::size_t rank = rank_of(classes_of(all));
    EXPECT_LE(all.size(), 3 * rank - 3); // a cut graph of nodes with three chains has as many
    if(impl::number_of_pieces(impl::Execution(), mesh) == 1) {
      EXPECT_EQ(rank, classes.rank());
    }
    const double shortest = impl::distance(mesh, 0, mesh.target(mesh.outgoing(0)));
    EXPECT_TRUE(loops_around(0, 3. * shortest, mesh.vertex_bound()).empty());
  }
}

// A basis stays a basis of what is left when one handle after the other is removed.
TEST(Surgery, LeadsWalksAroundHandlesThatAreGone) {
  for(const Recipe& recipe : surfaces()) {
    Surface_with_walks surface(recipe);
    Surgery_mesh& mesh = surface.mesh;
    std::size_t genus = surface.walks.size() / 2;
    for(std::size_t i = 0; i + 1 < surface.walks.size(); i += 2) {
      const std::optional<Cut_region> strip = Cut_region::around(mesh, surface.walks[i]);
      if(!strip || strip->number_of_borders() != 2)
        continue;
      // In turn, strips of faces and divided ones.
      const bool is_divided = i % 4 == 0;
      const Curve_off_vertices curve = curve_beside(mesh, surface.walks[i]);
      const impl::Patch caps = is_divided ? membranes_of(mesh, curve) : caps_of(mesh, *strip);
      const Index first_vertex = mesh.vertex_bound();
      const Index first_face =
          impl::put_in_place(mesh, is_divided ? curve.faces() : strip->faces(), caps) +
          static_cast<Index>(caps.parents.size());
      ASSERT_EQ(impl::count_surface(impl::Execution(), mesh).genus, --genus);
      const impl::Detour detour(mesh, first_face, first_vertex, surface.walks[i + 1]);
      surface.walks.erase(surface.walks.begin() + i, surface.walks.begin() + i + 2);
      i -= 2; // those that came after it are there now
      const Classes_modulo_2 classes(mesh);
      ASSERT_EQ(classes.rank(), 2 * genus);
      std::vector<std::vector<bool>> rows;
      for(Closed_walk& walk : surface.walks) {
        if(!impl::is_intact(mesh, walk))
          walk = detour.around(walk);
        ASSERT_FALSE(walk.empty());
        ASSERT_TRUE(impl::is_intact(mesh, walk));
        rows.push_back(classes.of(walk));
        EXPECT_EQ(classes.of(impl::shortened(mesh, walk)), rows.back());
      }
      EXPECT_EQ(rank_of(rows), 2 * genus);
    }
  }
}

// The faces that are divided, and the two rims of the strip, which are closed curves on them.
TEST(Surgery, DividesFacesAlongACurve) {
  for(const Recipe& recipe : surfaces()) {
    const Surface_with_walks surface(recipe);
    const Surgery_mesh& mesh = surface.mesh;
    for(const Closed_walk& walk : surface.walks) {
      const Curve_off_vertices curve = curve_beside(mesh, walk);
      const impl::Divided_strip strip(mesh, curve);
      const impl::Patch& parts = strip.parts();
      double area = 0., area_of_parts = 0.;
      for(Index f : curve.faces())
        area += impl::placed_triangle(mesh, f).area();
      std::set<std::pair<Index, Index>> sides;
      for(std::size_t i = 0; i < parts.faces.size(); ++i) {
        EXPECT_FALSE(parts.placed(mesh, i).is_degenerate());
        EXPECT_TRUE(impl::is_in(parts.parents[i], curve.faces()));
        area_of_parts += parts.placed(mesh, i).area();
        for(std::size_t k = 0; k < 3; ++k)
          EXPECT_TRUE(sides.insert({parts.faces[i][k], parts.faces[i][(k + 1) % 3]}).second);
      }
      EXPECT_LT(area_of_parts, area);
      EXPECT_GT(area_of_parts, 0.5 * area); // the strip is narrow
      for(bool is_left : {true, false}) {
        const std::vector<Index> rim = strip.rim(is_left);
        EXPECT_EQ(rim.size(), curve.size());
        for(std::size_t i = 0; i < rim.size(); ++i) {
          EXPECT_TRUE(sides.count({rim[(i + 1) % rim.size()], rim[i]}) == 1);
          EXPECT_TRUE(sides.count({rim[i], rim[(i + 1) % rim.size()]}) == 0);
        }
      }
    }
  }
}

// Each diagonal is used twice, each side once; the triangles of a flat polygon have its area.
TEST(Surgery, TriangulatesPolygons) {
  generators::Random random(7);
  for(std::size_t n : {3, 4, 9, 50, 150, 700})
    for(double bump : {0., 0.3}) {
      impl::Polygon_in_space polygon;
      for(std::size_t i = 0; i < n; ++i) {
        const double angle = 2. * CGAL_PI * double(i) / double(n),
                     radius = 1. + bump * random.uniform(-0.5, 0.5),
                     height = n > 3 ? bump * std::sin(3. * angle) : 0.;
        polygon.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
      }
      const impl::Triangulated_polygon filling(polygon);
      ASSERT_TRUE(filling.is_good());
      ASSERT_EQ(filling.triangles().size(), n - 2);
      std::set<std::pair<std::size_t, std::size_t>> sides;
      double area = 0.;
      for(const auto& t : filling.triangles()) {
        for(std::size_t k = 0; k < 3; ++k)
          EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
        area += std::sqrt(
            CGAL::squared_area(polygon.points[t[0]], polygon.points[t[1]], polygon.points[t[2]]));
      }
      for(std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(sides.count({i, (i + 1) % n}), 1u);
        EXPECT_EQ(sides.count({(i + 1) % n, i}), 0u);
      }
      if(bump == 0.) {
        EXPECT_NEAR(area, 0.5 * double(n) * std::sin(2. * CGAL_PI / double(n)), 1e-9);
      }
    }
}

// A ring of bumpy faces around a cylinder.
impl::Polygon_in_space bumpy_ring(std::size_t n, double bump, generators::Random& random) {
  impl::Polygon_in_space ring;
  for(std::size_t i = 0; i < n; ++i) {
    const double angle = 2. * CGAL_PI * double(i) / double(n);
    ring.points.emplace_back(std::cos(angle), std::sin(angle), bump * random.uniform(-0.1, 0.1));
    const double tilt = angle + CGAL_PI / double(n) + bump * random.uniform(-1., 1.);
    ring.normals_beyond.emplace_back(std::cos(tilt), std::sin(tilt),
                                     bump * random.uniform(-1., 1.));
  }
  return ring;
}

// A band from one polygon to the other, on the side that was asked for.
TEST(Surgery, PutsACollarOnTheSurface) {
  generators::Random random(5);
  for(int repetition = 0; repetition < 100; ++repetition) {
    const std::size_t n = 8 + random.below(200);
    impl::Polygon_in_space ring = bumpy_ring(n, random.uniform(0., 0.6), random);
    const bool is_outside = random.below(2) == 0;
    ring.at_sides = is_outside ? impl::Polygon_in_space::OUTSIDE : impl::Polygon_in_space::INSIDE;
    const double height = random.uniform(0.01, 0.3);
    const impl::Collar collar(ring, height);
    ASSERT_TRUE(collar.is_good());
    const std::size_t inner = collar.inner().size();
    EXPECT_EQ(collar.triangles().size(), n + inner);
    std::set<std::pair<std::size_t, std::size_t>> sides;
    for(const auto& t : collar.triangles())
      for(std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
    std::size_t number_open = 0;
    for(const auto& [i, j] : sides)
      number_open += sides.count({j, i}) == 0;
    EXPECT_EQ(number_open, n + inner);
    for(std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(sides.count({i, (i + 1) % n}), 1u);
    for(std::size_t k = 0; k < inner; ++k)
      EXPECT_EQ(sides.count({n + (k + 1) % inner, n + k}), 1u);
    for(const Surgery_mesh::Point& p : collar.inner().points) {
      const double radius = std::hypot(p.x(), p.y());
      EXPECT_TRUE(is_outside ? radius > 1. : radius < 1.) << radius;
      EXPECT_LT(std::abs(radius - 1.), 1.1 * height + 0.05);
    }
  }
}

// A spire is exchanged for its base: the base is as far from its sides as its points are, and its
// tip as far from the base, wherever that is.
TEST(Surgery, MeasuresHowFarTheSurfaceMoves) {
  using Triangle = CGAL::Simple_cartesian<double>::Triangle_3;
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  constexpr double tolerance = 0.02; // of a length of 1
  generators::Random random(3);
  for(int repetition = 0; repetition < 50; ++repetition) {
    std::vector<Point> p;
    for(double angle : {0., 2., 4.})
      p.emplace_back(std::cos(angle + random.uniform(-0.4, 0.4)),
                     std::sin(angle + random.uniform(-0.4, 0.4)), random.uniform(-0.2, 0.2));
    p.emplace_back(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(0.7, 2.));
    Mesh spire;
    for(const Point& q : p)
      spire.add_vertex({q.x(), q.y(), q.z()});
    const auto v = [](Index i) { return Mesh::Vertex_index(i); };
    for(const auto& f : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      spire.add_face(v(f[0]), v(f[1]), v(f[2]));
    const Surgery_mesh mesh = surgery_mesh_of(spire);
    const impl::Patch base{{}, {{0, 1, 2}}, {}, {0}};
    const impl::Intended_change anything{true, true, 1., true};
    impl::Judged_change change =
        impl::Shape_judge(mesh, true).change(mesh, {1, 2, 3}, base, anything);
    double largest = 0., most = 0.;
    for(const Point& q : p)
      largest = (std::max)({largest, std::abs(q.x()), std::abs(q.y()), std::abs(q.z())});
    const double unit = std::exp2(std::ilogb(largest)); // the mesh's own
    change.displacement *= unit;
    change.burial *= unit;
    constexpr int n = 50;
    for(int i = 0; i <= n; ++i)
      for(int k = 0; k <= n - i; ++k) {
        const Point q = CGAL::barycenter(p[0], double(i) / n, p[1], double(k) / n, p[2]);
        double least = 10.;
        for(std::size_t s = 0; s < 3; ++s)
          least =
              (std::min)(least, CGAL::squared_distance(q, Triangle(p[s], p[(s + 1) % 3], p[3])));
        most = (std::max)(most, std::sqrt(least));
      }
    EXPECT_GE(change.displacement, most - tolerance);
    EXPECT_LE(change.displacement, most + 2. / n);
    const double height = std::sqrt(CGAL::squared_distance(p[3], Triangle(p[0], p[1], p[2])));
    EXPECT_LE(change.burial, height * (1. + 1e-12));
    EXPECT_GE(change.burial, height - tolerance);
  }
}

} // namespace test_surgery
