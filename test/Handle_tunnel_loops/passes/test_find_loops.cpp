// The order of a computation, whoever does the passes and whatever mesh the caller has: which
// passes are called, where a diffusion begins, and that no loops are given away that fail their
// certificate.

#include "Crossing_loops.h"
#include "Quiet_progress.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace test_find_loops {

using namespace CGAL::Handle_tunnel_loops;
using namespace CGAL::Handle_tunnel_loops::internal;

// Passes that note that they were called.
class Noted_passes : public Passes
{
public:
  void initial_pass(Progress&, Statistics&) override { calls += "initial "; }
  Swept_vertices take_swept_vertices() override { return {}; }
  void tunnel_pass(Progress&, Statistics&) override { calls += "tunnel "; }
  void refinement_pass(Progress&, Statistics&) override { calls += "refinement "; }
  void shorten(Progress&) override { calls += "shorten "; }
  std::vector<Flat_pair> take_pairs() override { return {}; }

  std::vector<Time> diffusion(const std::vector<Index>& vertices, Progress&, Statistics&) override {
    sources.push_back(vertices);
    return times;
  }

  std::string calls;
  std::vector<Time> times;
  std::vector<std::vector<Index>> sources; // of each diffusion
};

TEST(Run_passes, CallsThoseThatAreAskedForInOrder) {
  for(const bool do_refine : {false, true})
    for(const bool do_tighten : {false, true}) {
      Pass_options options;
      options.do_refine_handles = do_refine;
      options.do_tighten = do_tighten;
      Noted_passes passes;
      Quiet_progress progress;
      Statistics statistics;
      run_passes(passes, options, progress, statistics);
      EXPECT_EQ(passes.calls, std::string("initial tunnel ") + (do_refine ? "refinement " : "") +
                                  (do_tighten ? "shorten " : ""));
    }
}

TEST(Diffusion_times, BeginsWhereAFrontFromTheSeedArrivesLast) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sphere", {200, 0, 0}});
  const Index last = static_cast<Index>(mesh.number_of_vertices()) / 3;
  ASSERT_NE(last, mesh.seeds[0]);
  Noted_passes passes;
  passes.times.assign(mesh.number_of_vertices(), 5);
  passes.times[mesh.seeds[0]] = 0;
  passes.times[last] = 9;
  Quiet_progress progress;
  Statistics statistics;
  EXPECT_EQ(diffusion_times(passes, {}, mesh, {}, progress, statistics), passes.times);
  EXPECT_EQ(passes.sources, (std::vector<std::vector<Index>>{mesh.seeds, {last}}));
}

// Also those that no refinement has replaced.
TEST(Run_passes, GivesLoopsThatAreTaut) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3, 10}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Pass_options options;
    options.do_refine_handles = false;
    Quiet_progress progress;
    Statistics statistics;
    const auto passes = Passes_of_tag<CGAL::Sequential_tag>::make(mesh, mesh.seeds, options);
    for(const Flat_pair& pair : run_passes(*passes, options, progress, statistics))
      for(const Crossing_loop* loop : {&pair.handle, &pair.tunnel}) {
        Crossing_loop again = *loop;
        Loop_tightening(mesh).tighten(again);
        EXPECT_GE(length(mesh, again), (1. - 1e-3) * length(mesh, *loop));
      }
  }
}

// Where so many tunnels lead over so few edges that no field finds them all, the sweep has the
// others, at no cost.
TEST(Run_passes, TakesTunnelsOfTheSweepWhereNoFieldFindsThem) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"hubs", {8000, 50, 0}});
  Quiet_progress progress;
  Statistics statistics;
  const auto passes = Passes_of_tag<CGAL::Sequential_tag>::make(mesh, mesh.seeds, {});
  const std::vector<Flat_pair> pairs = run_passes(*passes, {}, progress, statistics);
  EXPECT_GT(statistics.kept_sweep_tunnels, 0u);
  ASSERT_EQ(pairs.size(), 50u);
  for(const Flat_pair& pair : pairs) {
    EXPECT_FALSE(pair.handle.empty());
    EXPECT_FALSE(pair.tunnel.empty());
  }
}

// A mesh that may show the certificate other loops than it was given.
class Told_caller : public Caller_mesh
{
public:
  explicit Told_caller(const Flat_mesh& mesh)
      : mesh_(mesh)
      , surface_(mesh, coordinates({})) {}

  std::vector<Flat_surface::Point> coordinates(Execution) const override {
    std::vector<Flat_surface::Point> points;
    for(Index v = 0; v < mesh_.first_hub; ++v)
      points.emplace_back(mesh_.points[v][0], mesh_.points[v][1], mesh_.points[v][2]);
    return points;
  }

  void convert(Execution execution, const std::vector<Flat_pair>& found) override {
    pairs = found;
    on_convert(execution);
  }

  Triangle_list triangles(Execution execution, bool with_points) const override {
    return reader().read(execution, surface_.vertex_index(), surface_.point(), with_points);
  }

  std::vector<Listed_loop> listed_loops() const override {
    return reader().loops_of(surface_.pairs(pairs));
  }

  void exchange(std::size_t k) override { std::swap(pairs[k].handle, pairs[k].tunnel); }

  std::function<void(Execution)> on_convert = [](Execution) {};
  std::vector<Flat_pair> pairs;

private:
  Triangle_reader<Flat_graph, Flat_surface::Face_index_map> reader() const {
    return {surface_.mesh(), surface_.face_index()};
  }

  const Flat_mesh& mesh_;
  Flat_surface surface_;
};

class Find_loops : public testing::Test
{
protected:
  Find_loops() {
    request.seeds = mesh.seeds;
    request.make_passes = Passes_of_tag<CGAL::Sequential_tag>::make;
    request.put_swept_vertices = [](const Swept_vertices&) {};
  }

  Certificate run(Told_caller& caller, Progress& progress) const {
    Statistics statistics;
    return find_loops(Execution(), mesh, request, caller, progress, statistics);
  }

  Certificate run(Told_caller& caller) const {
    Quiet_progress progress;
    return run(caller, progress);
  }

  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {400, 1, 0}});
  Loop_request request;
};

TEST_F(Find_loops, GivesPairsAndTheirCertificate) {
  Told_caller caller(mesh);
  EXPECT_TRUE(run(caller));
  EXPECT_EQ(caller.pairs.size(), 1u);
}

// There is nothing else to do there.
TEST_F(Find_loops, SweepsASphereOnceForItsLayers) {
  static Noted_passes* passes; // the function is a plain pointer
  const Flat_mesh sphere = flat_mesh_of(Recipe{"sphere", {200, 0, 0}});
  request.passes.do_keep_layers = true;
  request.make_passes = [](const Flat_mesh&, std::vector<Index>, const Pass_options&) {
    auto made = std::make_unique<Noted_passes>();
    passes = made.get();
    return std::shared_ptr<Passes>(std::move(made));
  };
  std::string calls;
  request.put_swept_vertices = [&](const Swept_vertices&) { calls = passes->calls; };
  Told_caller caller(sphere);
  Quiet_progress progress;
  Statistics statistics;
  find_loops(Execution(), sphere, request, caller, progress, statistics);
  EXPECT_EQ(calls, "initial ");
}

TEST_F(Find_loops, SaysWhatFailsInACertificate) {
  Told_caller caller(mesh);
  caller.on_convert = [&](Execution) { caller.pairs[0].tunnel = caller.pairs[0].handle; };
  try {
    run(caller);
    FAIL() << "loops that fail their certificate are given away";
  } catch(const Uncertified_loops_exception& e) {
    EXPECT_NE(std::string(e.what()).find("not certified: "), std::string::npos);
  }
}

// Whatever works for long on the loops can be stopped in the middle.
TEST_F(Find_loops, IsWatchedWhereTheCallerConverts) {
  bool goes_on = true;
  Statistics statistics;
  Progress progress([&](double) { return goes_on; }, [](Stage) {}, [](Stage) {}, statistics,
                    Progress::stages_of_loops());
  Told_caller caller(mesh);
  bool is_stopped = false;
  caller.on_convert = [&](Execution execution) {
    goes_on = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100)); // nobody is asked all the time
    try {
      execution.look();
    } catch(const Interrupted_exception&) {
      is_stopped = true;
      throw;
    }
  };
  EXPECT_THROW(run(caller, progress), Interrupted_exception);
  EXPECT_TRUE(is_stopped);
}

} // namespace test_find_loops
