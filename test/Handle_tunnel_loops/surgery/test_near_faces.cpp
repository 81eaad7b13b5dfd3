#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index_table.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Growing_faces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangulated_polygon.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/near_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_near_faces {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using impl::Index;
using impl::Surgery_mesh;

Surgery_mesh surgery_mesh_of(Mesh& mesh) {
  const auto face_index = get(CGAL::face_index, mesh);
  const impl::Triangle_reader<Mesh, std::decay_t<decltype(face_index)>> reader(mesh, face_index);
  double unit = 1.;
  return impl::surgery_mesh_of(
      reader.read(impl::Execution(), get(CGAL::vertex_index, mesh), mesh.points()), unit);
}

Surgery_mesh surgery_mesh_of(const char* kind, std::size_t faces, std::size_t genus) {
  Mesh mesh = mesh_of({kind, {faces, genus, 0}});
  return surgery_mesh_of(mesh);
}

TEST(Index_table, IsAMap) {
  generators::Random random(1);
  impl::Index_table table;
  std::map<Index, Index> map;
  EXPECT_EQ(table.find(0), nullptr);
  for(int i = 0; i < 5000; ++i) {
    const auto index = static_cast<Index>(random.uniform(0., 1.) < 0.5 ? random.uniform(0., 1000.)
                                                                       : random.uniform(0., 4e9));
    const auto number = static_cast<Index>(random.uniform(0., 100.));
    const auto [place, is_new] = table.insert(index, number);
    EXPECT_EQ(is_new, map.insert({index, number}).second);
    EXPECT_EQ(*place, map.at(index));
    *place = map[index] = number;
  }
  for(const auto& [index, number] : map)
    EXPECT_EQ(*table.find(index), number);
  for(Index i = 0; i < 2000; ++i)
    EXPECT_EQ(table.find(i) != nullptr, map.count(i) == 1) << i;
}

// ---- faces that grow, by definition

using Faces = std::vector<Index>; // in ascending order

// Of vertices with at least so many halfedges of the border.
Faces with_faces_at_border(const Surgery_mesh& mesh, const Faces& faces, int least, bool& is_any) {
  std::map<Index, int> number;
  for(Index f : faces)
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      if(!impl::is_in(mesh.face(mesh.twin(h)), faces))
        ++number[mesh.source(h)];
  std::vector<Index> vertices;
  for(const auto& [v, n] : number)
    if(n >= least)
      vertices.push_back(v);
  is_any = !vertices.empty();
  return impl::united(faces, impl::Cut_region::faces_at(mesh, vertices));
}

TEST(Growing_faces, GrowByRingsAndWhereTheyTouch) {
  generators::Random random(2);
  const Surgery_mesh meshes[] = {surgery_mesh_of("random", 1200, 12),
                                 surgery_mesh_of("hubs", 1000, 4)};
  int number_of_pinches = 0;
  for(int run = 0; run < 40; ++run) {
    const Surgery_mesh& mesh = meshes[run % 2];
    std::vector<Index> vertices;
    for(int i = 0; i < 1 + run % 7; ++i)
      vertices.push_back(static_cast<Index>(random.uniform(0., double(mesh.vertex_bound()))));
    impl::Face_marks marks(mesh);
    impl::Growing_faces grown(mesh, marks, vertices);
    Faces faces = impl::Cut_region::faces_at(mesh, vertices);
    for(int step = 0; step < 12; ++step) {
      const auto before = grown.stage(); // what comes and goes leaves nothing
      grown.add_ring();
      grown.add_faces_at_pinches();
      grown.return_to(before);
      Faces now = grown.faces();
      std::sort(now.begin(), now.end());
      ASSERT_EQ(now, faces) << "run " << run << ", step " << step;
      bool is_any = false;
      if(step % 4 == 3) {
        faces = with_faces_at_border(mesh, faces, 1, is_any);
        grown.add_ring();
      } else {
        faces = with_faces_at_border(mesh, faces, 2, is_any);
        EXPECT_EQ(grown.add_faces_at_pinches(), is_any);
        number_of_pinches += is_any;
      }
    }
  }
  EXPECT_GT(number_of_pinches, 20);
}

// ---- contacts where boxes say nothing

// A patch that fills a circle, of which triangles are chords; turned, as boxes would tell parallel
// ones apart.
impl::Patch disc(std::size_t n) {
  impl::Polygon_in_space polygon;
  for(std::size_t i = 0; i < n; ++i) {
    const double angle = 2. * CGAL_PI * double(i) / double(n);
    polygon.points.push_back({std::cos(angle), std::sin(angle), 0.});
  }
  const impl::Triangulated_polygon filling(polygon);
  EXPECT_TRUE(filling.is_good());
  impl::Patch patch;
  patch.points = polygon.points;
  patch.caps = {0};
  for(const auto& t : filling.triangles())
    patch.faces.push_back({impl::Patch::first_own + static_cast<Index>(t[0]),
                           impl::Patch::first_own + static_cast<Index>(t[1]),
                           impl::Patch::first_own + static_cast<Index>(t[2])});
  return patch;
}

bool meets_itself_by_definition(const impl::Placed_patch& patch) {
  const auto& t = patch.triangles();
  for(std::size_t i = 0; i < t.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(impl::are_in_contact(t[i], t[j]))
        return true;
  return false;
}

TEST(Near_pairs, TellWhetherCapsMeetThemselves) {
  generators::Random random(3);
  const Surgery_mesh none;
  int number_of_contacts = 0;
  for(int run = 0; run < 12; ++run) {
    impl::Patch patch = disc(600);
    for(int i = 0; i < run % 4; ++i) { // a dent, which is harmless or not
      const auto v = static_cast<std::size_t>(random.uniform(0., 600.));
      const double factor = random.uniform(0.99, 1.0001);
      const auto& p = patch.points[v];
      patch.points[v] = {factor * p.x(), factor * p.y(), random.uniform(-1., 1.) < 0. ? 0. : 1e-3};
    }
    const impl::Placed_patch placed(none, patch);
    const auto never = [](Index, Index) { return false; };
    const bool meets = meets_itself_by_definition(placed);
    EXPECT_EQ(placed.meets_itself(never), meets) << run;
    EXPECT_EQ(placed.meets_itself(never, impl::Pair_budget::unlimited()), meets) << run;
    number_of_contacts += meets;
  }
  EXPECT_GT(number_of_contacts, 0);
  EXPECT_LT(number_of_contacts, 12);
}

// Flags around a pole, which is a vertex of all, and scattered triangles; some meet.
std::vector<impl::Placed_triangle> flags_and_others(generators::Random& random) {
  const auto anywhere = [&] {
    const double x = random.uniform(-1., 1.), y = random.uniform(-1., 1.);
    return Surgery_mesh::Point(x, y, random.uniform(-1., 1.));
  };
  std::vector<impl::Placed_triangle> triangles;
  for(Index i = 0; i < 300; ++i) {
    const bool is_flag = i % 2 == 0;
    impl::Placed_triangle t{{is_flag ? 0 : 3 * i + 1, 3 * i + 2, 3 * i + 3},
                            {Surgery_mesh::Point(0., 0., 0.), anywhere(), anywhere()}};
    if(!is_flag)
      for(auto& p : t.points)
        p = Surgery_mesh::Point(0.3 * p.x(), 0.3 * p.y(), 0.3 * p.z() + 0.01 * double(i % 100));
    triangles.push_back(t);
  }
  return triangles;
}

TEST(Near_pairs, AreOfBothPartsOnly) {
  generators::Random random(5);
  std::size_t number_of_contacts = 0;
  for(const std::size_t number_of_first : {1u, 80u, 150u, 299u, 300u}) {
    const auto triangles = flags_and_others(random);
    const auto pairs = *impl::near_pairs(triangles, number_of_first);
    const std::set<std::pair<Index, Index>> found(pairs.begin(), pairs.end());
    for(const auto& [i, j] : found)
      EXPECT_TRUE(i >= number_of_first && j < number_of_first);
    for(Index i = static_cast<Index>(number_of_first); i < triangles.size(); ++i)
      for(Index j = 0; j < number_of_first; ++j)
        if(impl::are_in_contact(triangles[i], triangles[j])) {
          EXPECT_EQ(found.count({i, j}), 1u) << i << ' ' << j;
          ++number_of_contacts;
        }
  }
  EXPECT_GT(number_of_contacts, 100u);
}

TEST(Near_pairs, AreFewWhereAllBoxesMeet) {
  const auto number_of_pairs = [](std::size_t n) {
    return impl::near_pairs(impl::Placed_patch(Surgery_mesh(), disc(n)).triangles())->size();
  };
  const std::size_t few = number_of_pairs(250), many = number_of_pairs(2000);
  EXPECT_GT(few, 248u);
  EXPECT_LT(many, 12 * few);
  std::vector<impl::Placed_triangle> flat =
      impl::Placed_patch(Surgery_mesh(), disc(10)).triangles();
  flat.back().points[0] = flat.back().points[1];
  EXPECT_FALSE(impl::near_pairs(flat)); // one has no area
}

// ---- boxes along other axes

// Of their sides, against the area of the surface, as each mesh has a unit of its own.
double mean_size_of_boxes(const Surgery_mesh& mesh) {
  double sum = 0., area = 0.;
  for(Index f = 0; f < mesh.face_bound(); ++f) {
    const impl::Placed_triangle t = impl::placed_triangle(mesh, f);
    area += t.area();
    const impl::Box<3> b = mesh.box_axes().box(t.corners());
    for(int i = 0; i < 3; ++i)
      sum += (b.high[i] - b.low[i]) * (b.high[(i + 1) % 3] - b.low[(i + 1) % 3]);
  }
  return sum / area;
}

TEST(Box_axes, AreAlongLongFacesHoweverTheyLie) {
  for(const char* kind : {"plates", "bars"}) {
    const Soup soup = soup_of({kind, {4000, 4, 0}});
    Mesh mesh = mesh_of(soup), other = mesh_of(generators::askew(soup));
    const Surgery_mesh straight = surgery_mesh_of(mesh), turned = surgery_mesh_of(other);
    EXPECT_LT(mean_size_of_boxes(turned), 1.5 * mean_size_of_boxes(straight)) << kind;
    const impl::Vector p = {0.1, 0.2, 0.3};
    EXPECT_EQ(straight.box_axes().turned(p), p) << kind; // nothing is clearly better
    EXPECT_NE(turned.box_axes().turned(p), p) << kind;
  }
}

// Slivers have no normal to speak of.
TEST(Box_axes, AreATurn) {
  using impl::operator+;
  using impl::operator*;
  generators::Random random(7);
  std::size_t number_turned = 0;
  for(int run = 0; run < 100; ++run) {
    std::vector<impl::Corner_points> slivers;
    const impl::Vector d = {0.6, 0.61, 0.52};
    for(int i = 0; i < 20; ++i) {
      const impl::Vector p = {random.uniform(0., 1.), random.uniform(0., 1.), 1.};
      slivers.push_back({p, p + random.uniform(0., 1.) * d, p + d});
    }
    const impl::Box_axes axes(slivers);
    const impl::Vector e[] = {axes.turned({1., 0., 0.}), axes.turned({0., 1., 0.}),
                              axes.turned({0., 0., 1.})};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        EXPECT_NEAR(impl::dot(e[i], e[j]), i == j ? 1. : 0., 1e-14);
    EXPECT_NEAR(impl::dot(e[0], impl::cross(e[1], e[2])), 1., 1e-14);
    number_turned += e[0][0] != 1.;
  }
  EXPECT_GT(number_turned, 90u);
}

// A corner of one triangle is in the middle of a side of another one, which is across one of the
// axes, and the triangles are on both sides of it.
TEST(Box_axes, LoseNoContact) {
  using Point = Surgery_mesh::Point;
  Mesh mesh = mesh_of(generators::askew(soup_of({"plates", {2000, 2, 0}})));
  const impl::Box_axes axes = surgery_mesh_of(mesh).box_axes();
  const auto height = [&](const Point& p) { return axes.turned(Surgery_mesh::place_of(p))[0]; };
  const Surgery_mesh::Kernel::Vector_3 up(height({1., 0., 0.}), height({0., 1., 0.}),
                                          height({0., 0., 1.}));
  const auto rounded = [](const Point& p) { // so that middles are exact
    const auto round = [](double x) { return std::ldexp(std::round(std::ldexp(x, 42)), -42); };
    return Point(round(p.x()), round(p.y()), round(p.z()));
  };
  generators::Random random(6);
  const auto anywhere = [&] {
    const double x = random.uniform(1000., 1001.), y = random.uniform(1000., 1001.);
    return rounded(Point(x, y, random.uniform(1000., 1001.)));
  };
  std::size_t number_lost = 0;
  for(int i = 0; i < 5000; ++i) {
    const Point p = anywhere(), other = anywhere(),
                q = rounded(other + (height(p) - height(other)) * up),
                middle = CGAL::midpoint(p, q);
    const impl::Placed_triangle below{{0, 1, 2}, {p, q, p - up}},
        above{{3, 4, 5}, {middle, middle + up, q + 2. * up}};
    if(below.is_degenerate() || above.is_degenerate())
      continue;
    ASSERT_TRUE(impl::are_in_contact(below, above));
    ASSERT_TRUE(axes.box(below.corners()).meets(axes.box(above.corners())));
    number_lost += (std::max)(height(p), height(q)) < height(middle);
  }
  EXPECT_GT(number_lost, 10u); // if boxes were not as large as rounding
}

// How many pairs are looked at with so many triangles done.
std::size_t number_of_pairs(impl::Pair_budget& budget, std::size_t done) {
  std::size_t number = 0;
  while(!budget.is_spent(done))
    ++number;
  return number;
}

TEST(Pair_budget, GrowsWithWhatIsDone) {
  impl::Pair_budget of_many(10000), halfway(10000), of_few(8);
  const std::size_t at_once = number_of_pairs(of_many, 0);
  EXPECT_GT(at_once, 10000u);
  EXPECT_NEAR(double(number_of_pairs(halfway, 5000) - at_once), 64. * 10000., 1.);
  // All of a few are done at once, so that a closer look at a million costs as many pairs of them.
  number_of_pairs(of_few, 8);
  EXPECT_TRUE(of_few.is_over());
  of_few.extend(1000000);
  EXPECT_FALSE(of_few.is_over());
  EXPECT_NEAR(double(number_of_pairs(of_few, 8)), 128. * 1000000., 2.);
}

// A disc in an end of a drum, which the faces at the hub are around, and where it is moved to.
TEST(Near_pairs, TellWhetherCapsMeetASurface) {
  generators::Random random(4);
  const Surgery_mesh mesh = surgery_mesh_of("hubs", 8000, 4);
  impl::Mesh_contacts contacts(mesh);
  contacts.update(impl::Execution());
  int number_of_contacts = 0;
  for(int run = 0; run < 10; ++run) {
    impl::Patch patch = disc(400);
    const double size = random.uniform(0.1, 0.4), x = random.uniform(-0.7, 0.7),
                 y = random.uniform(-0.7, 0.7), z = run % 2 == 0 ? 0. : random.uniform(-0.2, 0.);
    for(auto& p : patch.points)
      p = {x + size * p.x(), y + size * p.y(), z + 0.1 * p.x()};
    const impl::Placed_patch placed(mesh, patch);
    bool meets = false;
    for(Index f = 0; f < mesh.face_bound() && !meets; ++f)
      for(std::size_t i = 0; i < placed.triangles().size() && !meets; ++i)
        meets = placed.meets(i, impl::placed_triangle(mesh, f));
    const auto never = [](Index) { return false; };
    EXPECT_EQ(contacts.meets(placed, {}, never), meets) << run;
    EXPECT_EQ(contacts.meets(placed, {}, never, impl::Pair_budget::unlimited()), meets) << run;
    // Each pair that meets is found as often as by boxes alone.
    std::vector<Index> found, others;
    contacts.meets(
        placed, {}, [&](Index f) { return found.push_back(f), true; },
        impl::Pair_budget::unlimited());
    contacts.meets(
        placed, {}, [&](Index f) { return others.push_back(f), true; }, impl::Pair_budget(0));
    impl::make_set(found);
    impl::make_set(others);
    EXPECT_EQ(found, others) << run;
    number_of_contacts += meets;
  }
  EXPECT_GT(number_of_contacts, 2);
}

// ---- what caps may cross

// ... by definition, of some faces and all others; pairs are counted for each of the faces.
struct Contacts_by_definition
{
  Contacts_by_definition(const Surgery_mesh& mesh, const Faces& faces)
      : most(1024 + 8 * faces.size()) {
    for(Index f = 0; f < mesh.face_bound(); ++f)
      for(Index g : faces)
        if(f != g && impl::are_in_contact(placed_triangle(mesh, f), placed_triangle(mesh, g))) {
          const bool is_own = impl::is_in(f, faces);
          met.insert(f);
          ++(is_own ? number_of_own : number_of_others);
        }
  }

  bool are_too_many() const { return number_of_own > most || number_of_others > most; }

  const std::size_t most;
  std::size_t number_of_own = 0, number_of_others = 0; // own ones count for either face
  std::set<Index> met;
};

// Faces that go to and fro in a cube, so that most boxes meet.
Surgery_mesh scattered_mesh(std::size_t faces, generators::Random& random) {
  Mesh mesh = mesh_of({"torus", {faces, 1, 0}});
  for(const auto v : mesh.vertices())
    mesh.point(v) = {random.uniform(0., 1.), random.uniform(0., 1.), random.uniform(0., 1.)};
  return surgery_mesh_of(mesh);
}

TEST(Former_contacts, AreThoseOfEachFace) {
  generators::Random random(5);
  int number_with_own = 0, number_with_too_many = 0;
  const Surgery_mesh meshes[] = {surgery_mesh_of("random", 600, 5), scattered_mesh(3000, random)};
  for(int run = 0; run < 24; ++run) {
    const Surgery_mesh& mesh = meshes[run % 2];
    Faces faces, all;
    for(std::size_t i = 0; i < 1 + random.below(run < 12 ? 6 : 30); ++i)
      faces.push_back(static_cast<Index>(random.below(mesh.face_bound())));
    impl::make_set(faces);
    for(Index f = 0; f < mesh.face_bound(); ++f)
      all.push_back(f);
    random.shuffle(all);
    impl::Mesh_contacts contacts(mesh);
    contacts.update(impl::Execution());
    const Contacts_by_definition expected(mesh, faces);
    impl::Former_contacts former(mesh, contacts, faces);
    std::size_t number_met = 0;
    for(Index f : all)
      if(!impl::is_in(f, faces)) {
        const bool meets = former.are_with(f);
        number_met += meets;
        EXPECT_EQ(meets, expected.met.count(f) == 1 && !former.are_known_to_be_too_many());
      }
    EXPECT_LE(number_met, expected.most);
    EXPECT_EQ(former.are_too_many(), expected.are_too_many()) << run;
    EXPECT_EQ(former.are_known_to_be_too_many(), expected.are_too_many()) << run;
    if(expected.number_of_own <= expected.most) {
      EXPECT_EQ(former.are_own(), expected.number_of_own > 0) << run;
      for(Index f : faces)
        EXPECT_EQ(former.are_of_own(f), expected.met.count(f) == 1) << run;
    }
    number_with_own += expected.number_of_own > 0;
    number_with_too_many += expected.are_too_many();
  }
  EXPECT_GT(number_with_own, 0);
  EXPECT_GT(number_with_too_many, 0);
  EXPECT_LT(number_with_too_many, 24);
}

} // namespace test_near_faces
