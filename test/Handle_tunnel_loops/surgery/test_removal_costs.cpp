// What the removal of single handles takes, beside what their removal reports.

#include "Generated_soups.h"
#include "Meshes_of_soups.h"
#include "with.h"

#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/removal_costs.h>
#include <CGAL/remove_handles.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace test_removal_costs {

namespace htl = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using Costs = htl::Removal_costs;

template <typename Tag = CGAL::Sequential_tag>
std::vector<Costs> costs_of(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Costs> costs;
  CGAL::removal_costs<Tag>(mesh, pairs, std::back_inserter(costs));
  return costs;
}

htl::Removal_report
report_on(Mesh mesh, const Pairs& pairs, std::size_t pair, htl::Removal_method method) {
  const auto is_it = [&](const CGAL::Handle_tunnel_pair<Mesh>& p) {
    return p.handle().length() == pairs[pair].handle().length() &&
           p.tunnel().length() == pairs[pair].tunnel().length();
  };
  const std::function<bool(const CGAL::Handle_tunnel_pair<Mesh>&)> filter = is_it;
  const auto options = params::removal_options(with(&htl::Removal_options::method, method));
  return CGAL::remove_handles(mesh, params::known_loops(pairs, options).filter(filter));
}

void expect_same(const htl::Removed_handle& a, const htl::Removed_handle& b) {
  EXPECT_EQ(a.pair, b.pair);
  EXPECT_EQ(a.by, b.by);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.change.displacement, b.change.displacement);
}

class Costs_of_surfaces : public testing::TestWithParam<Recipe>
{};

// A handle that cannot be removed along its loops may be along others nearby, which cost more.
TEST_P(Costs_of_surfaces, AreThoseOfRemovingOneHandle) {
  const Mesh mesh = mesh_of(GetParam());
  const Pairs pairs = find_loops(mesh);
  const std::vector<Costs> costs = costs_of(mesh, pairs);
  ASSERT_EQ(costs.size(), pairs.size());
  std::size_t ways = 0;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    for(const bool is_cut : {true, false}) {
      const std::optional<htl::Removed_handle>& way = is_cut ? costs[i].cut : costs[i].fill;
      const std::string& why_not = is_cut ? costs[i].why_no_cut : costs[i].why_no_fill;
      EXPECT_EQ(why_not.empty(), way.has_value());
      if(!way)
        continue;
      ++ways;
      EXPECT_EQ(way->by, is_cut ? htl::Removal_way::CUT : htl::Removal_way::FILL);
      EXPECT_TRUE(is_cut ? way->volume >= 0. : way->volume <= 0.);
      const auto report =
          report_on(mesh, pairs, i, is_cut ? htl::Removal_method::CUT : htl::Removal_method::FILL);
      for(const htl::Removed_handle& removed : report.removed)
        if(removed.pair == i) // others may have loops of the same lengths
          expect_same(removed, *way);
    }
  }
  EXPECT_GE(ways, pairs.size());
}

INSTANTIATE_TEST_SUITE_P(Generated,
                         Costs_of_surfaces,
                         testing::ValuesIn(std::vector<Recipe>{{"torus", {600, 1, 0}},
                                                               {"multi-torus", {1500, 3, 0}},
                                                               {"plates", {600, 4, 1}},
                                                               {"chain", {900, 3, 0}},
                                                               {"lattice", {1500, 3, 0}},
                                                               {"gyroid", {3000, 4, 0}},
                                                               {"foam", {2600, 3, 1}}}));

// A way that leaves a sharp edge is taken only if the other one leaves one, too, or changes many
// times the volume.
TEST(Removal_costs, TellWhyASharpEdgeIsLeft) {
  const auto volume = [](const htl::Removed_handle& way) {
    return way.change.volume_removed + way.change.volume_added;
  };
  std::size_t of_both_ways = 0, sharp_ones = 0;
  for(unsigned seed = 0; seed < 4; ++seed)
    for(const char* kind : {"lattice", "foam", "gyroid"}) {
      const Mesh mesh = mesh_of(Recipe{kind, {4000, 5, seed}});
      const Pairs pairs = find_loops(mesh);
      const std::vector<Costs> costs = costs_of(mesh, pairs);
      for(std::size_t i = 0; i < pairs.size(); ++i) {
        if(!costs[i].cut || !costs[i].fill)
          continue;
        const auto report = report_on(mesh, pairs, i, htl::Removal_method::SMALLEST_CHANGE);
        for(const htl::Removed_handle& removed : report.removed)
          for(const bool is_cut : {true, false})
            if(const htl::Removed_handle& way = is_cut ? *costs[i].cut : *costs[i].fill,
               &other = is_cut ? *costs[i].fill : *costs[i].cut;
               removed.pair == i && removed.by == way.by && removed.volume == way.volume)
            {
              ++of_both_ways;
              if(way.change.has_sharp_edge() && !other.change.has_sharp_edge()) {
                EXPECT_GE(volume(other), 7.99 * volume(way));
                ++sharp_ones;
              } else if(way.change.has_sharp_edge() == other.change.has_sharp_edge()) {
                EXPECT_LE(volume(way), 1.11 * volume(other));
              } else
                EXPECT_LE(volume(way), 8.01 * volume(other));
            }
      }
    }
  RecordProperty("sharp_ones", static_cast<int>(sharp_ones));
  EXPECT_GT(of_both_ways, 20u);
}

TEST(Removal_costs, AreTheSameInAnyNumberOfThreadsAndOfSomePairs) {
  const Mesh mesh = mesh_of(Recipe{"plates", {600, 4, 1}});
  const Pairs pairs = find_loops(mesh);
  const std::vector<Costs> all = costs_of(mesh, pairs),
                           parallel = costs_of<CGAL::Parallel_if_available_tag>(mesh, pairs);
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    ASSERT_EQ(all[i].cut.has_value(), parallel[i].cut.has_value());
    ASSERT_EQ(all[i].fill.has_value(), parallel[i].fill.has_value());
    if(all[i].cut)
      expect_same(*all[i].cut, *parallel[i].cut);
    if(all[i].fill)
      expect_same(*all[i].fill, *parallel[i].fill);
    const std::vector<Costs> one = costs_of(mesh, {pairs[i]});
    ASSERT_EQ(one.size(), 1u);
    ASSERT_EQ(one[0].fill.has_value(), all[i].fill.has_value());
    if(one[0].fill) {
      EXPECT_EQ(one[0].fill->pair, 0u);
      EXPECT_EQ(one[0].fill->volume, all[i].fill->volume);
    }
  }
}

// Lengths, areas and volumes are those of the unit of the mesh.
TEST(Removal_costs, AreOfTheSizeOfTheMesh) {
  const Soup soup = soup_of(Recipe{"torus", {600, 1, 0}});
  for(const double scale : {0x1p-100, 0x1p100}) {
    Soup scaled = soup;
    for(auto& p : scaled.points)
      for(double& x : p)
        x *= scale;
    const Mesh a = mesh_of(soup), b = mesh_of(scaled);
    const auto costs = costs_of(a, find_loops(a)), others = costs_of(b, find_loops(b));
    ASSERT_TRUE(costs[0].cut && others[0].cut);
    EXPECT_NEAR(others[0].cut->area / scale / scale / costs[0].cut->area, 1., 1e-6);
    EXPECT_NEAR(others[0].cut->volume / scale / scale / scale / costs[0].cut->volume, 1., 1e-6);
  }
}

TEST(Removal_costs, OfNoPairsAreNone) {
  const Mesh mesh = mesh_of(Recipe{"torus", {600, 1, 0}});
  EXPECT_TRUE(costs_of(mesh, {}).empty());
}

TEST(Removal_costs, AreStoppedByTheCallback) {
  const Mesh mesh = mesh_of(Recipe{"torus", {600, 1, 0}});
  const Pairs pairs = find_loops(mesh);
  std::vector<Costs> costs;
  EXPECT_THROW(CGAL::removal_costs(mesh, pairs, std::back_inserter(costs),
                                   params::callback([](double) { return false; })),
               htl::Interrupted_exception);
}

} // namespace test_removal_costs
