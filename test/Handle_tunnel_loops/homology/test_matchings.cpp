// What is matched with what, and how visits are divided among searches.

#include "Crossing_loops.h"
#include "Loops_of_classes.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

namespace test_matchings {

using namespace CGAL::Handle_tunnel_loops::internal;

// ---- pairings

using Allowed = std::vector<std::vector<Index>>; // columns, by row

Allowed random_allowed(Random& random, std::size_t n) {
  Allowed allowed(n);
  const double density = random.uniform(0.1, 0.8);
  for(auto& columns : allowed)
    for(Index c = 0; c < n; ++c)
      if(random.uniform(0., 1.) < density)
        columns.push_back(c);
  return allowed;
}

// Of the rows in a set, by trying all.
bool can_be_matched(const Allowed& allowed,
                    const std::vector<Index>& rows,
                    std::size_t k = 0,
                    unsigned used = 0) {
  if(k == rows.size())
    return true;
  for(const Index c : allowed[rows[k]])
    if((used >> c & 1) == 0 && can_be_matched(allowed, rows, k + 1, used | 1u << c))
      return true;
  return false;
}

TEST(Pairing, GrowsAsLongAsItCan) {
  Random random(1);
  for(int round = 0; round < 2000; ++round) {
    const std::size_t n = 1 + random.below(7);
    const Allowed allowed = random_allowed(random, n);
    Pairing pairing(n);
    std::vector<Index> order(n), matched;
    std::iota(order.begin(), order.end(), Index(0));
    random.shuffle(order);
    for(const Index row : order) {
      const Pairing before = pairing;
      std::vector<Index> rows = matched;
      rows.push_back(row);
      const bool is_matched = pairing.augment(row, [&](Index r) { return allowed[r]; });
      ASSERT_EQ(is_matched, can_be_matched(allowed, rows));
      if(is_matched)
        matched = rows;
      std::set<Index> columns;
      for(const Index r : matched) {
        const Index c = pairing.column_of(r);
        ASSERT_NE(std::find(allowed[r].begin(), allowed[r].end(), c), allowed[r].end());
        EXPECT_EQ(pairing.row_of(c), r);
        EXPECT_TRUE(columns.insert(c).second);
      }
      for(Index i = 0; i < n && !is_matched; ++i) {
        EXPECT_EQ(pairing.column_of(i), before.column_of(i));
        EXPECT_EQ(pairing.row_of(i), before.row_of(i));
      }
    }
  }
}

TEST(Pairing, PrefersFirstColumns) {
  Pairing pairing(3);
  EXPECT_TRUE(pairing.augment(1, [](Index) { return std::vector<Index>{2, 0, 1}; }));
  EXPECT_EQ(pairing.column_of(1), 2u);
  pairing.release(1);
  EXPECT_EQ(pairing.column_of(1), no_index);
  EXPECT_EQ(pairing.row_of(2), no_index);
  pairing.release(1);
  pairing.match(0, 2);
  EXPECT_TRUE(pairing.augment(1, [](Index) { return std::vector<Index>{2, 0, 1}; }));
  EXPECT_EQ(pairing.column_of(0), 2u);
  EXPECT_EQ(pairing.column_of(1), 0u);
}

// ---- plans

constexpr double closest = 0.1, farthest = 1.;

double expected_visits(double disc, double places, double spacing) {
  return disc * (1. + places / spacing);
}

// Some visits are added to each search, so that small ones come to an end.
constexpr double slack = 201.;

TEST(Search_plan, PlansNoMoreThanThereIsButForSlack) {
  Random random(2);
  for(int round = 0; round < 3000; ++round) {
    const std::size_t n = 1 + random.below(12);
    std::vector<double> discs, places;
    for(std::size_t i = 0; i < n; ++i) {
      discs.push_back(std::exp(random.uniform(0., 12.)));
      places.push_back(std::exp(random.uniform(-2., 4.)));
    }
    const double visits = std::exp(random.uniform(0., 17.));
    const Search_plan plan(discs, places, visits);
    double planned = 0.;
    bool is_complete = true;
    for(std::size_t i = 0; i < n; ++i) {
      const Search_effort& e = plan.effort(i);
      planned += double(e.visits);
      is_complete = is_complete && e.visits > 0 && e.spacing == closest;
      if(e.visits == 0)
        continue;
      EXPECT_GE(e.spacing, closest);
      EXPECT_LE(e.spacing, farthest);
      EXPECT_NEAR(double(e.visits), expected_visits(discs[i], places[i], e.spacing) + 200., 1.);
    }
    EXPECT_LE(planned, (1. + 1e-9) * visits + slack * double(n)) << round;
    EXPECT_EQ(plan.is_tight(), !is_complete);
    const double all = std::inner_product(
        discs.begin(), discs.end(), places.begin(), 0., std::plus<>(),
        [](double disc, double p) { return expected_visits(disc, p, closest) + slack; });
    EXPECT_FALSE(all <= visits && plan.is_tight());
  }
}

// What takes no more than an equal share is done in full, whatever the others take; and what is
// done in full is no dearer than what is not, but for what is given up.
TEST(Search_plan, HasCheapSearchesFirst) {
  Random random(3);
  for(int round = 0; round < 1000; ++round) {
    const std::size_t n = 2 + random.below(12);
    std::vector<double> discs, places;
    for(std::size_t i = 0; i < n; ++i) {
      discs.push_back(std::exp(random.uniform(2., 12.)));
      places.push_back(std::exp(random.uniform(-1., 3.)));
    }
    const double visits = std::exp(random.uniform(8., 17.));
    const Search_plan plan(discs, places, visits);
    double dearest_in_full = 0., cheapest_shortened = 1e300;
    bool is_any_left_out = false;
    for(std::size_t i = 0; i < n; ++i) {
      const double need = expected_visits(discs[i], places[i], closest);
      const Search_effort& e = plan.effort(i);
      is_any_left_out = is_any_left_out || e.visits == 0;
      if(need + 2. * slack <= visits / double(n)) {
        EXPECT_EQ(e.spacing, closest);
        EXPECT_GE(double(e.visits), need);
      }
      if(e.visits > 0 && e.spacing == closest)
        dearest_in_full = (std::max)(dearest_in_full, need);
      else if(e.visits > 0)
        cheapest_shortened = (std::min)(cheapest_shortened, need);
    }
    if(!is_any_left_out) {
      EXPECT_LE(dearest_in_full, cheapest_shortened);
    }
  }
}

TEST(Search_plan, SpendsMoreIfThereIsMore) {
  Random random(4);
  for(int round = 0; round < 1000; ++round) {
    const std::vector<double> discs = {std::exp(random.uniform(0., 12.))};
    const std::vector<double> places = {std::exp(random.uniform(-2., 4.))};
    double spacing = 1e300;
    std::size_t before = 0;
    for(double visits = 1.; visits < 1e9; visits *= 3.) {
      const Search_effort e = Search_plan(discs, places, visits).effort(0);
      EXPECT_GE(e.visits, before);
      before = e.visits;
      if(e.visits > 0) {
        EXPECT_LE(e.spacing, spacing);
        spacing = e.spacing;
      }
    }
    EXPECT_EQ(spacing, closest);
  }
}

// ---- pairs of loops

// Whether the loops can be paired so that all pairs are allowed, by trying all ways.
template <typename Is_allowed>
bool can_be_paired(std::vector<Index> loops, const Is_allowed& is_allowed) {
  if(loops.empty())
    return true;
  const Index i = loops.back();
  loops.pop_back();
  for(std::size_t k = 0; k < loops.size(); ++k)
    if(is_allowed(i, loops[k])) {
      std::vector<Index> others = loops;
      others.erase(others.begin() + k);
      if(can_be_paired(others, is_allowed))
        return true;
    }
  return false;
}

TEST(Match_loops, CrossAnOddNumberOfTimesAndOnceIfTheyCan) {
  Random random(5);
  int once = 0, not_once = 0;
  for(const std::size_t genus : {1, 2, 3})
    for(int round = 0; round < 40; ++round) {
      const Recipe recipe = {"random", {100 + 60 * genus, genus, static_cast<unsigned>(round % 4)}};
      const Flat_mesh mesh = flat_mesh_of(recipe);
      const std::vector<Crossing_loop> first = loops_of_basis(soup_of(recipe));
      const std::vector<Crossing_loop> loops =
          combined(mesh, first, wound_up(random, 2 * genus, std::size_t(round), 40));
      std::vector<Flat_pair> pairs;
      for(std::size_t k = 0; k < genus; ++k)
        pairs.push_back({loops[2 * k], loops[2 * k + 1]});
      const Integer_matrix numbers =
          intersection_matrix(loops, Crossing_index(mesh, loops), loops.size());
      ASSERT_EQ(determinant(numbers), 1);
      std::vector<Index> all(loops.size());
      std::iota(all.begin(), all.end(), Index(0));
      const bool can_cross_once =
          can_be_paired(all, [&](Index i, Index j) { return abs(numbers[i][j]) == 1; });
      (can_cross_once ? once : not_once) += 1;

      match_loops(Execution(), mesh, pairs);
      ASSERT_EQ(pairs.size(), genus);
      std::vector<Crossing_loop> matched;
      for(const Flat_pair& pair : pairs) {
        matched.push_back(pair.handle);
        matched.push_back(pair.tunnel);
      }
      const Integer_matrix after =
          intersection_matrix(matched, Crossing_index(mesh, matched), matched.size());
      EXPECT_EQ(determinant(after), 1);
      for(std::size_t k = 0; k < genus; ++k) {
        const Integer number = abs(after[2 * k][2 * k + 1]);
        EXPECT_EQ(number % 2, 1);
        EXPECT_TRUE(number == 1 || !can_cross_once);
      }
      expect_same_loops(loops, matched);
    }
  EXPECT_GT(once, 10);
  EXPECT_GT(not_once, 10);
}

} // namespace test_matchings
