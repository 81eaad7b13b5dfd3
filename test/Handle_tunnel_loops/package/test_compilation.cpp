// Everything that is documented compiles, in all its forms. The package comes first, so that it
// leans on no header that a user may or may not include before.
#include <CGAL/handle_tunnel_loops.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <iterator>
#include <list>
#include <type_traits>
#include <vector>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Loop = CGAL::Loop_on_surface<Mesh>;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

// ---- types

static_assert(std::is_same_v<Pair::Loop, Loop>);
static_assert(std::is_same_v<Solver::Pair, Pair>);
static_assert(std::is_same_v<Solver::Point, Kernel::Point_3>);
static_assert(std::is_same_v<Loop::Point, Kernel::Point_3>);
static_assert(std::is_same_v<Loop::Halfedge_descriptor, Mesh::Halfedge_index>);
static_assert(std::is_same_v<CGAL::Handle_tunnel_pair<Mesh, Kernel::Point_3>, Pair>);
static_assert(std::is_default_constructible_v<Pair> && std::is_default_constructible_v<Loop>);
static_assert(std::is_nothrow_move_constructible_v<Loop> && std::is_copy_assignable_v<Pair>);

static_assert(std::is_base_of_v<std::invalid_argument, HTL::Invalid_mesh_exception>);
static_assert(std::is_base_of_v<std::logic_error, HTL::Uncertified_loops_exception>);
static_assert(std::is_base_of_v<std::runtime_error, HTL::Interrupted_exception>);

// A certificate is no number.
static_assert(std::is_constructible_v<bool, HTL::Certificate>);
static_assert(!std::is_convertible_v<HTL::Certificate, bool>);

// The torus of three by three squares.
Mesh torus() {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 9; ++i)
    v.push_back(mesh.add_vertex({i % 3 - 1., i / 3 - 1., (i * i) % 5 - 2.}));
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j) {
      const int right = (i + 1) % 3, up = (j + 1) % 3;
      mesh.add_face(v[i + 3 * j], v[right + 3 * j], v[right + 3 * up]);
      mesh.add_face(v[i + 3 * j], v[right + 3 * up], v[i + 3 * up]);
    }
  return mesh;
}

// ---- output iterators

TEST(Output, GoesToAnyIterator) {
  const Mesh mesh = torus();

  std::vector<Pair> vector;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(vector));
  EXPECT_EQ(vector.size(), 1u);

  std::list<Pair> list;
  CGAL::handle_tunnel_loops(mesh, std::front_inserter(list));
  EXPECT_EQ(list.size(), 1u);

  std::deque<Pair> deque;
  CGAL::handle_tunnel_loops(mesh, std::inserter(deque, deque.begin()));
  EXPECT_EQ(deque.size(), 1u);

  Pair pair;
  Pair* const end = CGAL::handle_tunnel_loops(mesh, &pair);
  EXPECT_EQ(end, &pair + 1);
  EXPECT_GT(pair.handle().size(), 0u);

  std::array<Pair, 2> array;
  EXPECT_EQ(CGAL::handle_tunnel_loops(mesh, array.begin()), array.begin() + 1);

  double length = 0.;
  CGAL::handle_tunnel_loops(mesh, boost::make_function_output_iterator(
                                      [&length](const Pair& p) { length += p.tunnel().length(); }));
  EXPECT_EQ(length, pair.tunnel().length());

  CGAL::handle_tunnel_loops(mesh, CGAL::Emptyset_iterator());
}

// ---- tags

template <typename ConcurrencyTag> void use_tag() {
  const Mesh mesh = torus();
  CGAL::Handle_tunnel_loops::Solver_options options;
  options.do_tighten = options.do_refine_handles = false;
  std::vector<Pair> pairs;
  CGAL::handle_tunnel_loops<ConcurrencyTag>(mesh, std::back_inserter(pairs));
  CGAL::handle_tunnel_loops<ConcurrencyTag>(mesh, std::back_inserter(pairs),
                                            CGAL::parameters::solver_options(options));
  Solver solver(ConcurrencyTag(), mesh, CGAL::parameters::default_values());
  solver.find_loops<ConcurrencyTag>(std::back_inserter(pairs));
  solver.find_loops<ConcurrencyTag>(std::back_inserter(pairs),
                                    CGAL::parameters::solver_options(options));
  EXPECT_EQ(pairs.size(), 4u);
  EXPECT_EQ(solver.statistics().backend, "host");
}

// In which threads they run is seen in test_determinism.
TEST(Tags, AreTakenEverywhere) {
  use_tag<CGAL::Sequential_tag>();
  use_tag<CGAL::Parallel_if_available_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  use_tag<CGAL::Parallel_tag>();
#endif
}

// ---- solver

TEST(Solver, HasManyForms) {
  const Mesh mesh = torus();
  const Point_map point = get(CGAL::vertex_point, mesh);
  std::vector<Pair> pairs;

  Solver by_default(mesh);
  by_default.find_loops(std::back_inserter(pairs));

  CGAL::Handle_tunnel_loops_solver<Mesh, CGAL::Default, Kernel> with_traits(
      mesh, CGAL::parameters::geom_traits(Kernel()));
  with_traits.find_loops(std::back_inserter(pairs));

  CGAL::Handle_tunnel_loops_solver<Mesh, Point_map> with_map(
      mesh, CGAL::parameters::vertex_point_map(point));
  with_map.find_loops(std::back_inserter(pairs));

  const Solver constant(mesh);
  EXPECT_EQ(constant.genus(), 1u);
  EXPECT_EQ(constant.number_of_components(), 1u);
  EXPECT_EQ(constant.statistics().genus, 1u);
  EXPECT_EQ(pairs.size(), 3u);
}

// ---- certificate

TEST(Certificate, IsOfAnyRange) {
  const Mesh mesh = torus();
  std::vector<Pair> vector;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(vector));
  const std::list<Pair> list(vector.begin(), vector.end());
  const std::array<Pair, 1> array = {vector[0]};
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(mesh, vector)));
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(mesh, list)));
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(mesh, array)));
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(
      mesh, vector, CGAL::parameters::vertex_index_map(get(boost::vertex_index, mesh)))));
  EXPECT_TRUE(
      bool(CGAL::certify_handle_tunnel_loops(mesh, vector, CGAL::parameters::default_values())));
}

// ---- pairs and loops

TEST(Loop, IsAValue) {
  const Mesh mesh = torus();
  Pair pair;
  EXPECT_EQ(pair.handle().size(), 0u);
  CGAL::handle_tunnel_loops(mesh, &pair);
  Pair copy = pair;
  copy = Pair(pair.handle(), pair.tunnel());
  const Loop moved = std::move(copy).handle();
  EXPECT_EQ(moved.points(), pair.handle().points());
  const Loop made(moved.steps(), moved.points(), 1.5, CGAL::Loop_type::TUNNEL, 3);
  EXPECT_EQ(made.length(), 1.5);
  EXPECT_EQ(made.type(), CGAL::Loop_type::TUNNEL);
  EXPECT_EQ(made.pair_index(), 3u);
}

} // namespace
