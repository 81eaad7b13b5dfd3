// Classes of loops as coordinates, and the search for the shortest closed walks of some of them,
// against brute force on the cover on which all loops unroll.

#include "Loops_of_classes.h"
#include "Number_of_cases.h"
#include "Walks_of_steps.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_search.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace test_class_search {

using namespace CGAL::Handle_tunnel_loops::internal;

// Not a knot: ways that wind around its tube are more than a vertex has labels for.
const std::vector<Recipe> embedded = {{"torus", {160, 1, 0}},    {"multi-torus", {600, 2, 0}},
                                      {"sponge", {120, 2, 0}},   {"sponge", {160, 3, 0}},
                                      {"lattice", {1200, 3, 1}}, {"plates", {1200, 2, 0}},
                                      {"gyroid", {2000, 3, 0}}};

const std::vector<Recipe> at_random = {
    {"random", {60, 1, 0}}, {"random", {80, 2, 1}}, {"random", {120, 3, 2}}};

std::vector<Recipe> all_recipes() {
  std::vector<Recipe> recipes = embedded;
  recipes.insert(recipes.end(), at_random.begin(), at_random.end());
  return recipes;
}

// ---- coordinates

TEST(Loop_classes, HaveCoordinatesThatAddUp) {
  Random random(1);
  for(const Recipe& recipe : all_recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> loops = loops_of_basis(soup_of(recipe));
    const Loop_classes classes(Execution(), mesh, loops);
    ASSERT_EQ(classes.size(), loops.size());
    for(int round = 0; round < 3; ++round) {
      const std::vector<Class_vector> rows = wound_up(random, loops.size(), 20, 10);
      const std::vector<Crossing_loop> sums = combined(mesh, loops, rows);
      for(std::size_t i = 0; i < rows.size(); ++i) {
        expect_crossing_loop(mesh, sums[i]);
        const Class_vector numbers = classes.numbers(sums[i]);
        EXPECT_EQ(classes.numbers_of_class(rows[i]), numbers);
        EXPECT_EQ(classes.class_with(numbers), rows[i]);
      }
      // The other way around: these loops are a basis, too.
      const Loop_classes others(Execution(), mesh, sums);
      for(const Crossing_loop& loop : loops) {
        const std::optional<Class_vector> back = others.class_with(others.numbers(loop));
        ASSERT_TRUE(back);
        EXPECT_EQ(others.numbers_of_class(*back), others.numbers(loop));
      }
    }
  }
}

// The class with intersection number 1 with one loop and 0 with the others gives coordinates.
TEST(Loop_classes, HaveDuals) {
  Random random(2);
  for(const Recipe& recipe : all_recipes()) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> first = loops_of_basis(soup_of(recipe));
    const std::vector<Crossing_loop> loops =
        combined(mesh, first, wound_up(random, first.size(), 15, 5));
    const Loop_classes classes(Execution(), mesh, loops);
    for(Index t = 0; t < loops.size(); ++t) {
      const std::optional<Class_vector> dual = classes.class_with({{t, 1}});
      ASSERT_TRUE(dual);
      for(Index i = 0; i < loops.size(); ++i)
        EXPECT_EQ(std::abs(product_sum(*dual, classes.row(i))), i == t ? 1 : 0);
    }
  }
}

TEST(Class_exchange, KeepsCoordinates) {
  Random random(3);
  for(const Recipe& recipe : all_recipes()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> loops = loops_of_basis(soup_of(recipe));
    const Loop_classes classes(Execution(), mesh, loops);
    const std::size_t n = loops.size();
    Class_exchange exchange(classes);
    std::vector<Class_vector> members; // in the first basis
    for(Index i = 0; i < n; ++i)
      members.push_back({{i, 1}});
    struct Seen
    {
      Class_vector a, x;
      Index exchanges_before;
    };
    std::vector<Seen> seen;
    for(int round = 0; round < 30; ++round) {
      const std::vector<Class_vector> rows = wound_up(random, n, 10, 3);
      const Class_vector a = rows[random.below(n)];
      const std::optional<Class_vector> x = exchange.coordinates(a);
      ASSERT_TRUE(x);
      Class_vector sum;
      for(const auto& [i, factor] : *x)
        ASSERT_TRUE(add_multiple(sum, factor, members[i]));
      EXPECT_EQ(sum, a);
      for(const Seen& s : seen)
        EXPECT_EQ(exchange.coordinates(s.x, s.exchanges_before), exchange.coordinates(s.a));
      seen.push_back({a, *x, exchange.number_of_exchanges()});
      for(Index i = 0; i < n; ++i) {
        EXPECT_EQ(exchange.numbers(i), classes.numbers_of_class(members[i]));
        EXPECT_EQ(exchange.crossing(classes.numbers_of_class(a), i),
                  product_sum(members[i], classes.numbers_of_class(a)));
      }
      const Index k = static_cast<Index>(random.below(n));
      if(std::abs(coordinate(*x, k)) == 1) {
        exchange.replace(k, a, *x);
        members[k] = a;
      }
    }
  }
}

// ---- the oracle

using Numbers = std::vector<int>;

// The shortest closed walks through a root, of each class that has one below a bound.
class Cover_oracle
{
public:
  Cover_oracle(const Flat_mesh& mesh,
               const Search_mesh& search_mesh,
               const std::vector<Crossing_loop>& loops)
      : mesh_(search_mesh)
      , size_(loops.size()) {
    const Crossing_index index(mesh, loops);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      numbers_.emplace_back();
      for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
        Sparse_numbers sparse;
        for_each_edge(mesh_, v, step, [&](Index from, Index to) {
          const Index u = mesh_.corner(from), w = mesh_.corner(to);
          if(u != w)
            index.add_crossings(u, w, sparse);
        });
        Numbers numbers(size_, 0);
        for(const auto& [loop, number] : sparse)
          numbers[loop] = static_cast<int>(number);
        numbers_.back().push_back(std::move(numbers));
      }
    }
  }

  std::vector<double> distances(Index root) const {
    std::vector<double> distance(mesh_.number_of_vertices(),
                                 std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance[root] = 0.;
    queue.emplace(0., root);
    while(!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > distance[v])
        continue;
      for(Index p = 0; p < size(v); ++p)
        if(const double e = d + length(v, p); e < distance[head(v, p)]) {
          distance[head(v, p)] = e;
          queue.emplace(e, head(v, p));
        }
    }
    return distance;
  }

  std::map<Numbers, double> walks_through(Index root, double bound) const {
    const std::vector<double> way_back = distances(root);
    using Place = std::pair<Numbers, Index>;
    using Entry = std::pair<double, Place>;
    std::map<Place, double> distance;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](double d, Place place) {
      if(d + way_back[place.second] > bound)
        return;
      const auto [it, is_new] = distance.emplace(place, d);
      if(is_new || d < it->second) {
        it->second = d;
        queue.emplace(d, std::move(place));
      }
    };
    reach(0., {Numbers(size_, 0), root});
    std::map<Numbers, double> found;
    while(!queue.empty()) {
      const auto [d, place] = queue.top();
      queue.pop();
      if(d > distance.at(place))
        continue;
      const auto& [sum, v] = place;
      if(v == root)
        found.emplace(sum, d);
      for(Index p = 0; p < size(v); ++p) {
        Numbers next = sum;
        for(std::size_t i = 0; i < size_; ++i)
          next[i] += numbers_[v][p][i];
        reach(d + length(v, p), {std::move(next), head(v, p)});
      }
    }
    return found;
  }

private:
  Index size(Index v) const { return mesh_.end(v) - mesh_.begin(v); }
  Index head(Index v, Index p) const { return mesh_.head(mesh_.begin(v) + p); }
  double length(Index v, Index p) const { return mesh_.length(v, mesh_.begin(v) + p); }

  const Search_mesh& mesh_;
  std::size_t size_;
  std::vector<std::vector<Numbers>> numbers_; // by vertex and step from it
};

// ---- searches

constexpr double rounding = 1e-5;

// A basis with its duals, and what may be crossed by loops that are looked for.
class Searched_surface
{
public:
  Searched_surface(const Recipe& recipe, bool is_pure, std::size_t finer, double coarser = 0.)
      : mesh_(flat_mesh_of(recipe))
      , loops_(loops_of_basis(soup_of(recipe)))
      , is_pure_(loops_.size() / 2, is_pure)
      , search_mesh_(mesh_)
      , classes_(Execution(), mesh_, loops_)
      , edge_classes_(classes_.edge_crossings(), random_weights(is_pure_)) {
    if(finer > 0)
      search_mesh_.refine(finer);
    search_mesh_.count(edge_classes_);
    if(coarser > 0.) {
      search_mesh_.measure();
      const double spacing =
          coarser * std::sqrt(search_mesh_.area() / double(search_mesh_.number_of_vertices()));
      coarser_ = std::make_unique<Search_mesh>(search_mesh_, spacing);
      coarser_->count(edge_classes_);
    }
    oracle_.emplace(mesh_, searched(), loops_);
    for(Index t = 0; t < loops_.size(); ++t)
      duals_.push_back(classes_.class_with({{t, 1}}).value());
  }

  std::size_t number_of_loops() const { return loops_.size(); }

  std::size_t number_of_bounds() const { return bounded_roots_; }
  std::size_t number_of_vertices() const { return searched().number_of_vertices(); }
  const Search_mesh& searched() const { return coarser_ ? *coarser_ : search_mesh_; }

  // There is a walk through the root that goes around the loop.
  double limit(Index t, Index root) const {
    const std::vector<double> distance = oracle_->distances(root);
    double nearest = 1e300, around = 0.;
    for(std::size_t i = 0; i < loops_[t].size(); ++i) {
      const Index v = near(loops_[t][i]), u = near(loops_[t][(i + 1) % loops_[t].size()]);
      nearest = (std::min)(nearest, distance[v]);
      if(u != v)
        around += oracle_->distances(v)[u];
    }
    return 1.01 * (around + 2. * nearest);
  }

  // With what is known of the distances from a loop, the shortest walks that cross it are found.
  void expect_shortest_walks_across(Index partner, Index t) const {
    const bool are_walls_along = is_pure_[0] && t % 2 == 1;
    const Index root = near(loops_[partner].front());
    const double most = limit(t, root);
    Search_targets found({{most, &duals_[t]}});
    Partner_distances distances(searched());
    std::size_t visits = 100000000;
    distances.compute(loops_[partner], partner, most, visits);
    Class_search search(searched());
    search.start(are_walls_along, &distances);
    const std::size_t before = visits;
    search.search(root, found, visits);
    double shortest = 1e300, shortest_found = 1e300;
    for(const auto& [numbers, length] : oracle_->walks_through(root, most))
      if(crosses_no_wall(numbers, t) && is_unit(numbers, t) && numbers[partner] != 0)
        shortest = (std::min)(shortest, length);
    for(const Search_targets::Found& f : found.take_found()) {
      shortest_found = (std::min)(shortest_found, f.length);
      expect_walk(f, t);
    }
    if(shortest < most) {
      EXPECT_LE(shortest_found, (1. + rounding) * shortest) << "loop " << t << " at " << partner;
      EXPECT_LE(distances.around(), (1. + rounding) * shortest);
      ++across_;
    }
    expect_lean_search_across(distances, root, t, shortest);
    Search_targets all({{most, &duals_[t]}});
    Class_search other(searched());
    other.start(are_walls_along);
    std::size_t left = 100000000;
    other.search(root, all, left);
    visits_ += before - visits;
    visits_without_ += 100000000 - left;
  }

  // With two sums at a vertex walks are right as well, and most often the shortest.
  void expect_lean_search_across(const Partner_distances& distances,
                                 Index root,
                                 Index t,
                                 double shortest) const {
    const double most = limit(t, root);
    Search_targets found({{most, &duals_[t]}});
    Class_search search(searched());
    search.start(is_pure_[0] && t % 2 == 1, &distances, true);
    std::size_t visits = 100000000;
    search.search(root, found, visits);
    double shortest_found = 1e300;
    for(const Search_targets::Found& f : found.take_found()) {
      shortest_found = (std::min)(shortest_found, f.length);
      expect_walk(f, t);
    }
    lean_ += shortest < most && shortest_found <= (1. + rounding) * shortest;
  }

  // Searches at each loop for those that cross it.
  void expect_shortest_walks_across() const {
    for(Index t = 0; t < loops_.size(); ++t)
      for(const auto& entry : duals_[t])
        expect_shortest_walks_across(entry.first, t);
    EXPECT_GT(across_, 0u);
    EXPECT_GE(2 * lean_, across_);
    EXPECT_LE(visits_, visits_without_);
  }

  // The walks of all steps lead to their heads, and are as long as they are said to be.
  void expect_steps() const {
    const Search_mesh& mesh = searched();
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index step = mesh.begin(v); step != mesh.end(v); ++step) {
        Index last = mesh.vertex_of_walks(v);
        double length = 0.;
        for_each_edge(mesh, v, step, [&](Index from, Index to) {
          ASSERT_EQ(from, last);
          ASSERT_LT(mesh_.ring(from).position(to), mesh_.ring(from).size());
          length += mesh_.edge_length(from, to);
          last = to;
        });
        EXPECT_EQ(last, mesh.vertex_of_walks(mesh.head(step)));
        EXPECT_NEAR(mesh.length(v, step), length, rounding * length);
      }
  }

  void expect_shortest_walks(Index root, const std::vector<Index>& targets) const {
    double limit = 0.;
    std::vector<Search_targets::Target> wanted;
    for(const Index t : targets) {
      wanted.push_back({this->limit(t, root), &duals_[t]});
      limit = (std::max)(limit, wanted.back().limit);
    }
    Search_targets found(wanted);
    Class_search search(searched());
    const bool are_walls_along = is_pure_[0] && targets.front() % 2 == 1;
    search.start(are_walls_along);
    std::size_t visits = 100000000;
    search.search(root, found, visits);
    ASSERT_GT(visits, 0u);

    const std::map<Numbers, double> all = oracle_->walks_through(root, limit);
    std::vector<double> shortest(targets.size(), 1e300), shortest_found(targets.size(), 1e300);
    for(const auto& [numbers, length] : all)
      for(std::size_t n = 0; n < targets.size(); ++n)
        if(crosses_no_wall(numbers, targets[n]) && is_unit(numbers, targets[n]))
          shortest[n] = (std::min)(shortest[n], length);
    for(const Search_targets::Found& f : found.take_found())
      for(const Index n : f.targets) {
        shortest_found[n] = (std::min)(shortest_found[n], f.length);
        expect_walk(f, targets[n]);
      }
    for(std::size_t n = 0; n < targets.size(); ++n) {
      ASSERT_LT(shortest[n], wanted[n].limit) << "the test itself is wrong";
      EXPECT_NEAR(shortest_found[n], shortest[n], rounding * shortest[n])
          << "root " << root << ", loop " << targets[n];
    }
    if(targets.size() == 1)
      expect_lower_bounds(root, targets.front(), wanted.front().limit, search);
  }

  // The loops of one kind.
  std::vector<Index> targets_like(Index t) const {
    std::vector<Index> targets;
    for(Index i = 0; i < loops_.size(); ++i)
      if(!is_pure_[0] || i % 2 == t % 2)
        targets.push_back(i);
    return targets;
  }

  void expect_visits(Index root, Index t) const {
    for(const std::size_t given : {0, 1, 5, 50}) {
      Search_targets found({{limit(t, root), &duals_[t]}});
      Class_search search(searched());
      search.start(is_pure_[0] && t % 2 == 1);
      std::size_t visits = given;
      search.search(root, found, visits);
      EXPECT_LE(visits, given);
      if(visits == 0) {
        EXPECT_EQ(search.lower_bound(root), 0.);
      }
      // The next search is none the worse for it.
      std::size_t enough = 100000000;
      search.search(root, found, enough);
      Search_targets anew({{limit(t, root), &duals_[t]}});
      Class_search other(searched());
      other.start(is_pure_[0] && t % 2 == 1);
      enough = 100000000;
      other.search(root, anew, enough);
      const auto a = found.take_found(), b = anew.take_found();
      ASSERT_FALSE(a.empty() || b.empty());
      EXPECT_NEAR(a.front().length, b.front().length, rounding * b.front().length);
    }
  }

private:
  Index near(const Crossing& c) const {
    return searched().vertex_near(mesh_.points[c.left], c.left);
  }

  bool crosses_no_wall(const Numbers& numbers, Index t) const {
    for(std::size_t i = 0; i < numbers.size(); ++i)
      if(is_pure_[0] && i % 2 == t % 2 && numbers[i] != 0)
        return false;
    return true;
  }

  bool is_unit(const Numbers& numbers, Index t) const {
    std::int64_t x = 0;
    for(const auto& [i, factor] : duals_[t])
      x += factor * numbers[i];
    return std::abs(x) == 1;
  }

  // On the edges of the mesh, in a class that is right by its crossings.
  void expect_walk(const Search_targets::Found& f, Index t) const {
    Numbers numbers(loops_.size(), 0);
    const Crossing_loop loop = search_mesh_.loop_along(f.walk);
    ASSERT_TRUE(are_consecutive(mesh_, loop));
    for(const auto& [other, number] : Crossing_index(mesh_, loops_).intersections(loop))
      numbers[other] = static_cast<int>(number);
    EXPECT_TRUE(crosses_no_wall(numbers, t));
    EXPECT_TRUE(is_unit(numbers, t));
  }

  void expect_lower_bounds(Index root, Index t, double limit, const Class_search& search) const {
    bounded_roots_ += search.lower_bound(root) > 0.;
    Random random(root);
    for(int i = 0; i < 3; ++i) {
      const Index v = static_cast<Index>(random.below(number_of_vertices()));
      if(search.lower_bound(v) <= 0.f)
        continue;
      for(const auto& [numbers, length] : oracle_->walks_through(v, limit))
        if(crosses_no_wall(numbers, t) && is_unit(numbers, t)) {
          EXPECT_GE(length, (1. - rounding) * search.lower_bound(v));
        }
    }
  }

  Flat_mesh mesh_;
  std::vector<Crossing_loop> loops_;
  std::vector<char> is_pure_;
  Search_mesh search_mesh_;
  std::unique_ptr<Search_mesh> coarser_;
  Loop_classes classes_;
  Edge_classes edge_classes_;
  std::optional<Cover_oracle> oracle_;
  std::vector<Class_vector> duals_;
  mutable std::size_t bounded_roots_ = 0, across_ = 0, lean_ = 0, visits_ = 0, visits_without_ = 0;
};

void expect_shortest_walks(const Recipe& recipe, bool is_pure, std::size_t finer) {
  SCOPED_TRACE(testing::PrintToString(recipe));
  Random random(4);
  const Searched_surface surface(recipe, is_pure, finer);
  for(int round = 0; round < 3; ++round) {
    const Index t = static_cast<Index>(random.below(surface.number_of_loops())),
                root = static_cast<Index>(random.below(surface.number_of_vertices()));
    surface.expect_shortest_walks(root, {t});
    surface.expect_shortest_walks(root, surface.targets_like(t));
  }
  // No bound is known where a vertex has been reached with too many sums of walls.
  EXPECT_GT(surface.number_of_bounds(), 0u);
}

TEST(Class_search, FindsShortestWalksThatCrossNoWall) {
  for(std::size_t i = 0; i < embedded.size(); i += are_few_cases_tried() ? 2 : 1)
    expect_shortest_walks(embedded[i], true, 0);
}

TEST(Class_search, FindsShortestWalksWithoutWalls) {
  std::vector<Recipe> small;
  for(const Recipe& recipe : all_recipes())
    if(recipe.request.faces < 200 && recipe.request.genus < 3)
      small.push_back(recipe);
  for(const Recipe& recipe : enough_of(small))
    expect_shortest_walks(recipe, false, 0);
}

TEST(Class_search, FindsShortestWalksOnFinerMeshes) {
  for(const Recipe& recipe : {embedded[0], embedded[2]})
    for(const bool is_pure : {true, false})
      expect_shortest_walks(recipe, is_pure, 400);
}

TEST(Class_search, FindsShortestWalksOnCoarserMeshes) {
  for(const Recipe& recipe : {embedded[0], embedded[2], embedded[4], embedded[5]})
    for(const bool is_pure : {true, false}) {
      SCOPED_TRACE(testing::PrintToString(recipe));
      const Searched_surface finer(recipe, is_pure, 0), surface(recipe, is_pure, 0, 2.);
      EXPECT_LT(2 * surface.number_of_vertices(), finer.number_of_vertices());
      surface.expect_steps();
      // Without walls there are too many classes to try them all, but on few handles.
      if(is_pure || surface.number_of_loops() == 2) {
        surface.expect_shortest_walks(0, {0});
        surface.expect_shortest_walks(5, {1});
      }
    }
}

TEST(Class_search, FindsShortestWalksAcrossPartners) {
  for(const Recipe& recipe : embedded)
    for(const double coarser : {0., 2.}) {
      SCOPED_TRACE(testing::PrintToString(recipe));
      Searched_surface(recipe, true, 0, coarser).expect_shortest_walks_across();
    }
  Searched_surface(embedded[0], false, 0).expect_shortest_walks_across();
  Searched_surface(embedded[2], true, 400).expect_shortest_walks_across();
}

TEST(Class_search, StopsAfterSoManyVisits) {
  for(const Recipe& recipe : all_recipes())
    Searched_surface(recipe, recipe.kind != "random", 0).expect_visits(7, 0);
}

} // namespace test_class_search
