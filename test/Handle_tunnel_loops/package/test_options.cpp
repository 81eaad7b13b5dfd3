// The named parameters do what they are documented to do, alone and together.

#include "Loop_definitions.h"
#include "Same_loops.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_options {

namespace HTL = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using HTL::Stage;
using Options = HTL::Solver_options;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

auto with_passes(bool refine, bool tighten) {
  Options options;
  options.do_refine_handles = refine;
  options.do_tighten = tighten;
  return params::solver_options(options);
}

auto with_constants(const HTL::Field_constants& constants, bool tighten = true) {
  Options options;
  options.field_constants = constants;
  options.do_tighten = tighten;
  return params::solver_options(options);
}

const Recipe small_recipe = {"lattice", {3000, 6, 0}};
constexpr std::size_t small_genus = 6;

// ---- callback

template <typename ConcurrencyTag> void expect_monotone_progress(const Mesh& mesh) {
  std::vector<double> reported;
  const auto callback = [&reported](double progress) {
    reported.push_back(progress);
    return true;
  };
  CGAL::handle_tunnel_loops<ConcurrencyTag>(mesh, CGAL::Emptyset_iterator(),
                                            params::callback(callback));
  ASSERT_FALSE(reported.empty());
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GE(reported.front(), 0.);
  EXPECT_LT(reported.front(), 0.5);
  EXPECT_EQ(reported.back(), 1.);
}

TEST(Callback, IsToldOfTheProgress) {
  const Mesh mesh = mesh_of(small_recipe);
  expect_monotone_progress<CGAL::Sequential_tag>(mesh);
  expect_monotone_progress<CGAL::Parallel_if_available_tag>(mesh);
}

TEST(Callback, IsToldTheEndWhereThereIsNothingToDo) {
  double last = -1.;
  const auto callback = [&last](double progress) {
    last = progress;
    return true;
  };
  find_loops(mesh_of({"sphere", {100, 0, 0}}), params::callback(callback));
  EXPECT_EQ(last, 1.);
}

// Stops wherever it was called in another run; nothing is written, and the solver is as good as
// new.
TEST(Callback, StopsTheComputation) {
  const Mesh mesh = mesh_of(small_recipe);
  Solver solver(mesh);
  Pairs expected;
  std::vector<double> reported;
  solver.find_loops(std::back_inserter(expected), params::callback([&reported](double progress) {
                      reported.push_back(progress);
                      return true;
                    }));
  ASSERT_GT(reported.size(), 10u);
  for(const double end : reported) {
    SCOPED_TRACE(testing::Message() << "stopped at " << end);
    Pairs pairs;
    bool is_stopped = false;
    const auto callback = [&](double progress) {
      EXPECT_FALSE(is_stopped) << "asked again";
      is_stopped = progress >= end;
      return !is_stopped;
    };
    EXPECT_THROW(solver.find_loops(std::back_inserter(pairs), params::callback(callback)),
                 HTL::Interrupted_exception);
    EXPECT_TRUE(pairs.empty());
  }
  Pairs pairs;
  solver.find_loops(std::back_inserter(pairs));
  expect_same(pairs, expected);
}

TEST(Callback, StopsAParallelComputation) {
  const Mesh mesh = mesh_of(small_recipe);
  for(int stop = 1; stop < 20; ++stop) {
    Pairs pairs;
    int calls = 0;
    const auto callback = [&calls, stop](double) { return ++calls < stop; };
    EXPECT_THROW(CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(
                     mesh, std::back_inserter(pairs), params::callback(callback)),
                 HTL::Interrupted_exception);
    EXPECT_TRUE(pairs.empty());
  }
}

TEST(Callback, MayThrow) {
  struct My_exception
  {};
  const Mesh mesh = mesh_of(small_recipe);
  const auto callback = [](double progress) -> bool {
    if(progress > 0.5)
      throw My_exception();
    return true;
  };
  Pairs pairs;
  EXPECT_THROW(
      CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs), params::callback(callback)),
      My_exception);
  EXPECT_TRUE(pairs.empty());
}

TEST(Callback, MayBeEmpty) {
  const Mesh mesh = mesh_of(small_recipe);
  EXPECT_EQ(find_loops(mesh, params::callback(std::function<bool(double)>())).size(), small_genus);
}

// ---- visitor

using Log = std::vector<std::string>;

struct Logging_visitor
{
  void start_stage(Stage stage) { log.push_back(std::string("start ") + HTL::stage_name(stage)); }
  void end_stage(Stage stage) { log.push_back(std::string("end ") + HTL::stage_name(stage)); }

  Log log;
};

Log log_of(const std::vector<Stage>& stages) {
  Logging_visitor visitor;
  for(const Stage stage : stages) {
    visitor.start_stage(stage);
    visitor.end_stage(stage);
  }
  return visitor.log;
}

TEST(Visitor, IsToldOfTheStagesInOrder) {
  const Mesh mesh = mesh_of(small_recipe);
  Logging_visitor visitor;
  find_loops(mesh, params::visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.log,
            log_of({Stage::INITIAL, Stage::TUNNEL, Stage::REFINE, Stage::SHORTEN, Stage::CLASSES,
                    Stage::CONVERT, Stage::CERTIFICATE, Stage::CLASSIFY}));
}

TEST(Visitor, IsNotToldOfWhatIsLeftOut) {
  const Mesh mesh = mesh_of(small_recipe);
  Logging_visitor visitor;
  find_loops(mesh, with_passes(false, true).visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.log, log_of({Stage::INITIAL, Stage::TUNNEL, Stage::SHORTEN, Stage::CLASSES,
                                 Stage::CONVERT, Stage::CERTIFICATE, Stage::CLASSIFY}));
}

TEST(Visitor, IsCopied) {
  struct Sharing_visitor : HTL::Default_visitor
  {
    void start_stage(Stage) { ++*number_of_stages; }
    std::shared_ptr<int> number_of_stages = std::make_shared<int>(0);
  };
  const Mesh mesh = mesh_of(small_recipe);
  const Sharing_visitor sharing;
  find_loops(mesh, params::visitor(sharing));
  EXPECT_EQ(*sharing.number_of_stages, 8);

  const Logging_visitor logging;
  find_loops(mesh, params::visitor(logging));
  EXPECT_TRUE(logging.log.empty());
}

TEST(Visitor, SeesAStageBeginThatIsNotEnded) {
  const Mesh mesh = mesh_of(small_recipe);
  Logging_visitor visitor;
  const auto stop = [](double) { return false; };
  EXPECT_THROW(find_loops(mesh, params::visitor(std::ref(visitor)).callback(stop)),
               HTL::Interrupted_exception);
  EXPECT_EQ(visitor.log, Log{"start initial"});
}

TEST(Stages, HaveNames) {
  EXPECT_STREQ(HTL::stage_name(Stage::ADAPTOR), "adaptor");
  EXPECT_STREQ(HTL::stage_name(Stage::CERTIFICATE), "certificate");
  EXPECT_EQ(static_cast<std::size_t>(Stage::DIFFUSION) + 1, HTL::number_of_stages);
}

// ---- refinement and tightening

std::vector<Recipe> recipes() {
  return {{"torus", {2000, 1, 0}},   {"knot", {2000, 1, 0}},   {"multi-torus", {4000, 5, 0}},
          {"lattice", {6000, 9, 1}}, {"gyroid", {6000, 8, 0}}, {"sponge", {5000, 30, 0}},
          {"random", {1000, 30, 0}}, {"random", {300, 4, 7}}};
}

TEST(Every_choice_of_passes, GivesPairedBases) {
  for(const Recipe& recipe : recipes()) {
    const Mesh mesh = mesh_of(recipe);
    for(const bool refine : {false, true})
      for(const bool tighten : {false, true}) {
        SCOPED_TRACE(testing::Message()
                     << recipe << ", refine " << refine << ", tighten " << tighten);
        expect_handle_tunnel_pairs(mesh, find_loops(mesh, with_passes(refine, tighten)),
                                   recipe.request.genus);
      }
  }
}

// Compared over all meshes: on one of them, other loops may happen to be better.
TEST(Every_pass, MakesTheLoopsShorter) {
  double none = 0., only_tightened = 0., only_refined = 0., all = 0.;
  for(const Recipe& recipe : recipes()) {
    const Mesh mesh = mesh_of(recipe);
    const double unit = total_length(find_loops(mesh));
    const auto relative_length = [&](bool refine, bool tighten) {
      const auto np = with_passes(refine, tighten);
      return total_length(find_loops(mesh, np)) / unit;
    };
    none += relative_length(false, false);
    only_refined += relative_length(true, false);
    only_tightened += relative_length(false, true);
    all += 1.;
  }
  EXPECT_LT(only_tightened, none);
  EXPECT_LT(only_refined, none);
  EXPECT_LT(all, only_refined);
  EXPECT_LT(all, 1.01 * only_tightened); // on small meshes the search in classes sees as much
}

// ---- seed vertex and field constants

TEST(Seed_vertex, IsThatOfItsComponent) {
  const Soup first = soup_of({"random", {60, 3, 1}}), second = soup_of({"random", {80, 2, 2}});
  const Mesh mesh = mesh_of(generators::disjoint_union({first, second}));
  for(const Mesh::Vertex_index v : vertices(mesh)) {
    SCOPED_TRACE(testing::Message() << "seed vertex " << v);
    expect_handle_tunnel_pairs(mesh, find_loops(mesh, params::seed_vertex(v)), 5);
  }
}

TEST(Seed_vertex, IsTheFirstVertexByDefault) {
  const Mesh mesh = mesh_of(small_recipe);
  expect_same(find_loops(mesh, params::seed_vertex(Mesh::Vertex_index(0))), find_loops(mesh));
  expect_same(find_loops(mesh, params::seed_vertex(Mesh::null_vertex())), find_loops(mesh));
}

TEST(Field_constants, AreThoseOfThePaperByDefault) {
  const HTL::Field_constants c;
  EXPECT_DOUBLE_EQ(c.mobility, 1. / 4.);
  EXPECT_DOUBLE_EQ(c.driving_force, 1. / 30.);
  EXPECT_DOUBLE_EQ(c.gradient_coefficient, 1. / 25.);
  EXPECT_DOUBLE_EQ(c.penalty, c.gradient_coefficient / 5.);
  const Mesh mesh = mesh_of(small_recipe);
  expect_same(find_loops(mesh, with_constants(c)), find_loops(mesh));
}

// How the field moves is a matter of quality, never of the count.
TEST(Field_constants, MayBeAnythingThatIsValid) {
  generators::Random random(9);
  const auto number = [&](double low, double high) {
    return std::pow(10., random.uniform(low, high));
  };
  for(int i = 0; i < 60; ++i) {
    HTL::Field_constants c;
    c.mobility = number(-6., 6.);
    c.gradient_coefficient = number(-6., 6.);
    c.penalty = number(-6., 3.);
    c.driving_force = c.penalty * (1. + number(-3., 6.));
    c.step = number(-1., 0.);
    SCOPED_TRACE(testing::Message() << c.mobility << ' ' << c.gradient_coefficient << ' '
                                    << c.penalty << ' ' << c.driving_force << ' ' << c.step);
    for(const Recipe& recipe : {Recipe{"multi-torus", {1200, 4, 0}}, Recipe{"random", {200, 8, 1}}})
    {
      const Mesh mesh = mesh_of(recipe);
      expect_handle_tunnel_pairs(mesh, find_loops(mesh, with_constants(c)), recipe.request.genus);
    }
  }
}

// With small steps, fronts have to be given more of them.
TEST(Field_constants, MayHaveSmallSteps) {
  const Mesh mesh = mesh_of({"multi-torus", {20000, 4, 0}});
  HTL::Field_constants c;
  const auto length = [&] { return total_length(find_loops(mesh, with_constants(c, false))); };
  const double expected = length();
  c.step = 1. / 64.;
  EXPECT_LT(length(), 1.1 * expected);
}

TEST(Field_constants, AreRefusedIfTheStepIsTooSmall) {
  const Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  HTL::Field_constants c;
  for(const double step : {-1., 0., 1e-9, 0.99 / 1024., 1.01}) {
    c.step = step;
    EXPECT_THROW(find_loops(mesh, with_constants(c)), std::invalid_argument) << step;
  }
  c.step = 1. / 1024.;
  EXPECT_EQ(find_loops(mesh, with_constants(c)).size(), 1u);
}

// ---- index maps

// Other numbers than those of the mesh, and how often they are asked for.
template <typename Descriptor> struct Counting_map
{
  using key_type = Descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  explicit Counting_map(std::size_t n)
      : number(n)
      , count(std::make_shared<std::size_t>(0)) {}

  friend std::size_t get(const Counting_map& map, Descriptor d) {
    ++*map.count;
    return map.number - 1 - d.idx();
  }

  std::size_t number;
  std::shared_ptr<std::size_t> count;
};

TEST(Index_maps, AreThoseGivenToTheSolver) {
  const Mesh mesh = mesh_of(small_recipe);
  const Counting_map<Mesh::Vertex_index> vertex_index(mesh.number_of_vertices());
  const Counting_map<Mesh::Face_index> face_index(mesh.number_of_faces());
  Solver solver(mesh, params::vertex_index_map(vertex_index).face_index_map(face_index));
  EXPECT_GE(*vertex_index.count, mesh.number_of_vertices());
  *vertex_index.count = *face_index.count = 0;
  Pairs pairs;
  Solver copy = solver;
  copy.find_loops(std::back_inserter(pairs));
  EXPECT_GE(*vertex_index.count, mesh.number_of_vertices());
  EXPECT_GE(*face_index.count, mesh.number_of_faces());
  expect_handle_tunnel_pairs(mesh, pairs, small_genus);
}

// ---- how long to search

// Of many handles, so that there is something to search for.
const Recipe long_search = {"gyroid", {12000, 15, 0}};

template <typename ConcurrencyTag> void expect_certified_in_no_time(const Mesh& mesh) {
  Solver solver(mesh);
  for(const auto kind : {HTL::Basis_kind::PURE, HTL::Basis_kind::SHORTEST}) {
    Pairs pairs;
    solver.find_loops<ConcurrencyTag>(std::back_inserter(pairs),
                                      params::basis_kind(kind, params::maximum_running_time(0.)));
    EXPECT_TRUE(solver.certificate());
    EXPECT_TRUE(solver.statistics().was_ended_by_time);
    if(kind == HTL::Basis_kind::PURE) {
      expect_handle_tunnel_pairs(mesh, pairs, long_search.request.genus);
      EXPECT_EQ(solver.certificate().handles_bound_inside, long_search.request.genus);
      EXPECT_EQ(solver.certificate().tunnels_bound_outside, long_search.request.genus);
    }
  }
}

TEST(Maximum_running_time, MayBeNone) {
  const Mesh mesh = mesh_of(long_search);
  expect_certified_in_no_time<CGAL::Sequential_tag>(mesh);
  expect_certified_in_no_time<CGAL::Parallel_if_available_tag>(mesh);
}

// Wherever the search ends there is a basis, no longer than the one that it began with.
TEST(Maximum_running_time, EndsTheSearchAnywhere) {
  const Mesh mesh = mesh_of(long_search);
  Solver solver(mesh);
  const auto length_after = [&](double seconds) {
    Pairs pairs;
    solver.find_loops(std::back_inserter(pairs), params::maximum_running_time(seconds));
    EXPECT_TRUE(solver.certificate()) << seconds;
    EXPECT_EQ(solver.certificate().handles_bound_inside, pairs.size()) << seconds;
    return total_length(pairs);
  };
  const double longest = length_after(0.);
  const double begin = solver.statistics().total_seconds();
  const double shortest = length_after(1e9);
  EXPECT_LT(shortest, longest);
  EXPECT_FALSE(solver.statistics().was_ended_by_time);
  const double end = solver.statistics().total_seconds();
  for(int i = 1; i < 8; ++i)
    EXPECT_LE(length_after(begin + (end - begin) * i / 8.), longest * (1. + 1e-9));
}

// Loops that were put together of hundreds of others are not kept for want of time.
TEST(Maximum_running_time, DoesNotKeepLoopsThatAreWoundUp) {
  const Mesh mesh = mesh_of({"bars", {6000, 150, 0}});
  EXPECT_LE(total_length(find_loops(mesh, params::maximum_running_time(0.))),
            1.1 * total_length(find_loops(mesh)));
}

TEST(Maximum_running_time, ChangesNothingIfItIsLong) {
  const Mesh mesh = mesh_of(long_search);
  const Pairs expected = find_loops(mesh);
  for(const double seconds : {1e9, std::numeric_limits<double>::infinity()})
    expect_same(find_loops(mesh, params::maximum_running_time(seconds)), expected);
  expect_same(find_loops(mesh, params::maximum_running_time(1000000)), expected); // no double
}

TEST(Maximum_running_time, IsNotAskedForWhereThereIsNothingToSearch) {
  const Mesh mesh = mesh_of({"sphere", {100, 0, 0}});
  Solver solver(mesh);
  solver.find_loops(CGAL::Emptyset_iterator(), params::maximum_running_time(0.));
  EXPECT_FALSE(solver.statistics().was_ended_by_time);
}

TEST(Maximum_running_time, IsRefusedIfItIsNegative) {
  const Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  for(const double seconds : {-1., -1e-300, std::nan(""), -std::numeric_limits<double>::infinity()})
    EXPECT_THROW(find_loops(mesh, params::maximum_running_time(seconds)), std::invalid_argument)
        << seconds;
}

TEST(Search_effort, IsRefusedIfThereIsNoSuch) {
  const Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  Options options;
  const auto find = [&](double effort) {
    options.search_effort = effort;
    return find_loops(mesh, params::solver_options(options)).size();
  };
  for(const double effort :
      {-1., -1e-300, 1000.1, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(find(effort), std::invalid_argument) << effort;
  for(const double effort : {0., 1e-300, 1000.})
    EXPECT_EQ(find(effort), 1u) << effort;
}

// ---- statistics

TEST(Statistics, TellOfTheMesh) {
  const Soup soup =
      generators::disjoint_union({soup_of(small_recipe), soup_of({"torus", {200, 1, 0}})});
  const Mesh mesh = mesh_of(soup);
  const Solver solver(mesh);
  const HTL::Statistics& s = solver.statistics();
  EXPECT_EQ(s.number_of_vertices, soup.points.size());
  EXPECT_EQ(s.number_of_faces, soup.triangles.size());
  EXPECT_EQ(s.number_of_components, 2u);
  EXPECT_EQ(s.genus, small_genus + 1);
  EXPECT_GT(s.seconds_of(Stage::ADAPTOR), 0.);
  EXPECT_EQ(s.seconds_of(Stage::INITIAL), 0.);
}

TEST(Statistics, TellOfTheStages) {
  const Mesh mesh = mesh_of(small_recipe);
  Solver solver(mesh);
  solver.find_loops(CGAL::Emptyset_iterator());
  const HTL::Statistics& s = solver.statistics();
  double sum = 0.;
  for(std::size_t i = 0; i < HTL::number_of_stages; ++i) {
    EXPECT_EQ(s.seconds[i] > 0., static_cast<Stage>(i) != Stage::DIFFUSION)
        << HTL::stage_name(static_cast<Stage>(i));
    sum += s.seconds_of(static_cast<Stage>(i));
  }
  EXPECT_DOUBLE_EQ(s.total_seconds(), sum);
  EXPECT_EQ(s.swept_handles, small_genus);
  EXPECT_EQ(s.traced_tunnels + s.kept_sweep_tunnels, small_genus);
  EXPECT_LE(s.refined_handles + s.kept_sweep_handles, small_genus);
}

TEST(Statistics, AreThoseOfTheLastRun) {
  const Mesh mesh = mesh_of(small_recipe);
  Solver solver(mesh);
  solver.find_loops(CGAL::Emptyset_iterator());
  solver.find_loops(CGAL::Emptyset_iterator(), with_passes(false, true));
  EXPECT_EQ(solver.statistics().seconds_of(Stage::REFINE), 0.);
  EXPECT_EQ(solver.statistics().kept_sweep_handles, 0u);
  EXPECT_EQ(solver.statistics().refined_handles, 0u);
  EXPECT_GT(solver.statistics().seconds_of(Stage::ADAPTOR), 0.);
}

// ---- together

TEST(Parameters, MayBeCombined) {
  const Mesh mesh = mesh_of(small_recipe);
  const Mesh::Vertex_index v(7);
  const Options options;
  const auto proceed = [](double) { return true; };
  const HTL::Default_visitor visitor;
  const Pairs expected = find_loops(mesh, params::seed_vertex(v));
  const auto point = get(CGAL::vertex_point, mesh);

  expect_same(find_loops(mesh, params::seed_vertex(v).callback(proceed)), expected);
  expect_same(find_loops(mesh, params::seed_vertex(v).visitor(visitor).callback(proceed)),
              expected);
  expect_same(find_loops(mesh, params::seed_vertex(v, params::solver_options(options))), expected);
  expect_same(find_loops(mesh, params::solver_options(options, params::seed_vertex(v))), expected);
  expect_same(
      find_loops(mesh, params::seed_vertex(v, params::callback(proceed)
                                                  .vertex_point_map(point)
                                                  .geom_traits(CGAL::Simple_cartesian<double>())
                                                  .visitor(visitor))),
      expected);
  expect_same(
      find_loops(mesh, params::basis_kind(HTL::Basis_kind::PURE,
                                          params::seed_vertex(v, params::solver_options(options)
                                                                     .vertex_point_map(point)
                                                                     .callback(proceed)))),
      expected);
}

} // namespace test_options
