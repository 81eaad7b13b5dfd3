// The same mesh has the same loops, bit for bit: called again, in parallel, with any number of
// threads. And the numbering of the vertices changes little.

#include "Number_of_cases.h"
#include "Same_events.h"
#include "Same_loops.h"
#include "with.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace test_determinism {

using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

class Loops : public testing::TestWithParam<Recipe>
{
protected:
  const Mesh mesh = mesh_of(GetParam());
  const Pairs expected = find_loops(mesh);
};

// The larger ones have more vertices than one range of a parallel loop.
INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Loops,
                         testing::Values(Recipe{"torus", {60000, 1, 0}},
                                         Recipe{"gyroid", {50000, 25, 0}},
                                         Recipe{"lattice", {6000, 12, 0}},
                                         Recipe{"sponge", {8000, 40, 1}},
                                         Recipe{"random", {2000, 60, 2}},
                                         Recipe{"random", {400, 10, 3}}),
                         [](const auto& test) {
                           return test.param.kind + "_" + std::to_string(test.param.request.faces);
                         });

TEST_P(Loops, AreTheSameAgain) { expect_same(find_loops(mesh), expected); }

TEST_P(Loops, AreTheSameWhenFrontsAreLoggedAndSoIsTheLog) {
  const auto log = CGAL::parameters::solver_options(
      with(&CGAL::Handle_tunnel_loops::Solver_options::do_log_fronts, true));
  Solver solver(mesh);
  Pairs pairs;
  solver.find_loops(std::back_inserter(pairs), log);
  expect_same(pairs, expected);
  const auto events = solver.statistics().front_events;
  EXPECT_FALSE(events.empty());
  solver.find_loops<CGAL::Parallel_if_available_tag>(CGAL::Emptyset_iterator(), log);
  EXPECT_EQ(solver.statistics().front_events, events);
}

TEST_P(Loops, AreTheSameAgainFromOneSolver) {
  Solver solver(mesh);
  for(int i = 0; i < 3; ++i) {
    Pairs pairs;
    if(i == 1) // something else in between
      solver.find_loops(CGAL::Emptyset_iterator(),
                        CGAL::parameters::seed_vertex(Mesh::Vertex_index(5)));
    solver.find_loops(std::back_inserter(pairs));
    expect_same(pairs, expected);
  }
}

TEST_P(Loops, AreTheSameForACopyOfTheMesh) {
  const Mesh copy = mesh;
  expect_same(find_loops(copy), expected);
}

TEST_P(Loops, AreTheSameForAnyNumberOfThreads) {
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1, 2, 4}) {
    SCOPED_TRACE(testing::Message() << threads << " threads");
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for(int i = 0; i < 2; ++i) {
      Pairs pairs;
      CGAL::handle_tunnel_loops<CGAL::Parallel_tag>(mesh, std::back_inserter(pairs));
      expect_same(pairs, expected);
    }
  }
#else
  GTEST_SKIP() << "built without TBB";
#endif
}

TEST_P(Loops, AreTheSameForEveryTag) {
  Pairs pairs;
  CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  expect_same(pairs, expected);
  // Preparation and computation need not be alike.
  Solver solver(CGAL::Parallel_if_available_tag(), mesh, CGAL::parameters::default_values());
  pairs.clear();
  solver.find_loops<CGAL::Sequential_tag>(std::back_inserter(pairs));
  expect_same(pairs, expected);
}

#ifdef CGAL_LINKED_WITH_TBB

using Threads = std::set<std::thread::id>;

// Those that work in an arena.
class Observer : public tbb::task_scheduler_observer
{
public:
  explicit Observer(tbb::task_arena& arena)
      : tbb::task_scheduler_observer(arena) {
    observe(true);
  }
  ~Observer() override { observe(false); }

  void on_scheduler_entry(bool) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    threads_.insert(std::this_thread::get_id());
  }

  Threads threads() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return threads_;
  }

private:
  mutable std::mutex mutex_;
  Threads threads_;
};

class Execution : public testing::Test
{
protected:
  void SetUp() override {
#ifdef HTL_TEST_WITH_THREAD_SANITIZER
    GTEST_SKIP()
        << "under the thread sanitizer threads are not those of TBB, which it cannot follow";
#endif
  }

  // More threads than one, even on one processor.
  template <typename Function> static Threads threads_of(const Function& f) {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(4);
    const Observer observer(arena);
    arena.execute(f);
    return observer.threads();
  }

  // A busy processor may let one thread do everything for a while, but not for half a minute.
  template <typename Function> static std::size_t most_threads_of(const Function& f) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(30);
    std::size_t most = 0;
    do {
      most = (std::max)(most, threads_of(f).size());
    } while(most < 2 && Clock::now() < end);
    return most;
  }

  const Threads this_thread = {std::this_thread::get_id()};
};

TEST_F(Execution, IsThatOfTheTagOfTheSolver) {
  const Mesh mesh = mesh_of(Recipe{"torus", {60000, 1, 0}});
  Solver solver(mesh);
  EXPECT_EQ(threads_of([&] { solver.find_loops(CGAL::Emptyset_iterator()); }), this_thread);
  EXPECT_EQ(threads_of([&] { solver.find_loops<CGAL::Sequential_tag>(CGAL::Emptyset_iterator()); }),
            this_thread);
  EXPECT_EQ(solver.statistics().backend, "host");
  EXPECT_GT(
      most_threads_of([&] { solver.find_loops<CGAL::Parallel_tag>(CGAL::Emptyset_iterator()); }),
      1u);
  EXPECT_EQ(solver.statistics().backend, "host");
  EXPECT_GT(most_threads_of([&] {
              solver.find_loops<CGAL::Parallel_if_available_tag>(CGAL::Emptyset_iterator());
            }),
            1u);
}

TEST_F(Execution, IsThatOfTheTagOfThePreparation) {
  const Mesh mesh = mesh_of(Recipe{"torus", {60000, 1, 0}});
  const auto np = CGAL::parameters::default_values();
  EXPECT_EQ(threads_of([&] { Solver solver(mesh); }), this_thread);
  EXPECT_EQ(threads_of([&] { Solver solver(CGAL::Sequential_tag(), mesh, np); }), this_thread);
  EXPECT_GT(most_threads_of([&] { Solver solver(CGAL::Parallel_tag(), mesh, np); }), 1u);
}

TEST_F(Execution, IsThatOfTheTagOfTheCertificate) {
  const Mesh mesh = mesh_of(Recipe{"gyroid", {50000, 25, 0}}); // many loops
  const Pairs pairs = find_loops(mesh);
  EXPECT_EQ(threads_of([&] { CGAL::certify_handle_tunnel_loops(mesh, pairs); }), this_thread);
  EXPECT_GT(
      most_threads_of([&] { CGAL::certify_handle_tunnel_loops<CGAL::Parallel_tag>(mesh, pairs); }),
      1u);
}

#endif

// From the same place, on meshes of which the loops are as short as a person would draw them.
class Numbering : public testing::TestWithParam<Recipe>
{};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Numbering,
                         testing::Values(Recipe{"torus", {3000, 1, 0}},
                                         Recipe{"knot", {3000, 1, 0}},
                                         Recipe{"multi-torus", {8000, 6, 0}},
                                         Recipe{"lattice", {8000, 9, 0}},
                                         Recipe{"gyroid", {12000, 9, 0}}),
                         [](const auto& test) {
                           std::string name = test.param.kind;
                           return name.substr(0, name.find('-'));
                         });

TEST_P(Numbering, ChangesTheLengthsLittle) {
  const Soup soup = soup_of(GetParam());
  const auto find_from_first_point = [&](const Soup& permuted) {
    const auto it = std::find(permuted.points.begin(), permuted.points.end(), soup.points[0]);
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(it - permuted.points.begin()));
    return find_loops(mesh_of(permuted), CGAL::parameters::seed_vertex(v));
  };
  const Pairs expected = find_from_first_point(soup);
  for(unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << GetParam() << ", permutation " << seed);
    const Pairs pairs = find_from_first_point(generators::permute_vertices(soup, seed));
    EXPECT_EQ(pairs.size(), expected.size());
    EXPECT_NEAR(total_length(pairs), total_length(expected), 0.25 * total_length(expected));
  }
}

} // namespace test_determinism
