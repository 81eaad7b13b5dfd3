// What measures are made of, against brute force.

#include "Flat_mesh_of_soup.h"
#include "Gauss_linking.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cycle_trials.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Paired_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Plane_section.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Pushed_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Room_in_caps.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Voronoi_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Way_network.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace test_measure_parts {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::generators::Random;
using impl::Index;
using impl::Linking_row;
using impl::operator-;
using impl::operator+;
using impl::operator*;

Linking_row random_row(std::size_t width, Random& random) {
  Linking_row row;
  for(Index i = 0; i < width; ++i)
    if(const int x = static_cast<int>(random.below(7)) - 3; x != 0 && random.below(2) == 0)
      row.emplace_back(i, x);
  return row;
}

std::size_t rank_of(std::vector<std::vector<double>> rows) {
  std::size_t rank = 0;
  for(std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column)
    for(std::size_t r = rank; r < rows.size(); ++r)
      if(std::abs(rows[r][column]) > 1e-6) {
        std::swap(rows[r], rows[rank]);
        for(std::size_t k = rank + 1; k < rows.size(); ++k) {
          const double factor = rows[k][column] / rows[rank][column];
          for(std::size_t c = 0; c < rows[k].size(); ++c)
            rows[k][c] -= factor * rows[rank][c];
        }
        ++rank;
        break;
      }
  return rank;
}

TEST(Linking_rank, IsThatOfTheMatrix) {
  Random random(1);
  for(int i = 0; i < 300; ++i) {
    const std::size_t width = 1 + random.below(6);
    impl::Linking_rank rank;
    std::vector<std::vector<double>> dense;
    for(int k = 0; k < 8; ++k) {
      const Linking_row row = random_row(width, random);
      dense.emplace_back(width, 0.);
      for(const auto& [loop, number] : row)
        dense.back()[loop] = number;
      const std::size_t before = rank.size();
      const bool is_new = rank.add(row);
      EXPECT_EQ(is_new, rank.size() > before);
      EXPECT_EQ(rank.size(), rank_of(dense));
    }
  }
}

// Whether the cycles from a number on can have loops of their own that are not taken.
bool can_be_matched(const std::vector<Linking_row>& rows,
                    std::size_t from,
                    std::vector<char> taken) {
  if(from == rows.size())
    return true;
  for(const auto& entry : rows[from])
    if(taken[entry.first] == 0) {
      std::vector<char> more = taken;
      more[entry.first] = 1;
      if(can_be_matched(rows, from + 1, more))
        return true;
    }
  return false;
}

TEST(Paired_cycles, TakeTheShortestThatLeavesTheOthersWhatTheyNeed) {
  Random random(2);
  int matched = 0;
  for(int i = 0; i < 500; ++i) {
    const std::size_t n = 1 + random.below(6);
    std::vector<Linking_row> rows;
    std::vector<double> lengths;
    for(std::size_t k = 0; k < n; ++k) {
      rows.push_back(random_row(n, random));
      lengths.push_back(random.uniform(1., 2.));
    }
    std::vector<char> taken(n, 0);
    if(!can_be_matched(rows, 0, taken))
      continue;
    ++matched;
    std::vector<const Linking_row*> pointers;
    for(const Linking_row& row : rows)
      pointers.push_back(&row);
    const std::vector<Index> found = impl::Paired_cycles(pointers, lengths, 1).partners();
    for(std::size_t c = 0; c < n; ++c) {
      Index best = impl::no_index;
      for(const auto& entry : rows[c])
        if(taken[entry.first] == 0) {
          std::vector<char> more = taken;
          more[entry.first] = 1;
          if(can_be_matched(rows, c + 1, more) &&
             (best == impl::no_index || lengths[entry.first] < lengths[best]))
            best = entry.first;
        }
      EXPECT_EQ(found[c], best);
      taken[best] = 1;
    }
  }
  EXPECT_GT(matched, 50);
}

TEST(Paired_cycles, OfOnePairTakeWhatIsLeft) {
  const Linking_row both = {{0, 1}, {1, 2}};
  const std::vector<Index> found =
      impl::Paired_cycles({&both, &both}, {1., 1., 1., 1.}, 2).partners();
  EXPECT_EQ(found, (std::vector<Index>{0, 1}));
}

std::vector<impl::Vector> random_points(std::size_t n, Random& random) {
  std::vector<impl::Vector> points(n);
  for(impl::Vector& p : points)
    for(double& x : p)
      x = random.uniform(0., 1.);
  return points;
}

TEST(Voronoi_graph, HasBallsThatHoldNoPoint) {
  Random random(3);
  for(const std::size_t n : {4u, 30u, 200u}) {
    std::vector<impl::Vector> points = random_points(n, random);
    if(n == 200) // on a grid, so that many are on one sphere
      for(impl::Vector& p : points)
        for(double& x : p)
          x = std::round(4. * x) / 4.;
    impl::Voronoi_graph graph({0., 0., 0.}, {1., 1., 1.});
    graph.insert(impl::Execution(), points, 0);
    graph.build(impl::Execution());
    const auto distance = [&](const impl::Vector& p) {
      double least = std::numeric_limits<double>::infinity();
      for(const impl::Vector& q : points)
        least = (std::min)(least, impl::norm(p - q));
      return least;
    };
    for(const auto& edge : graph.edges) {
      const auto &a = graph.nodes[edge.nodes[0]], &b = graph.nodes[edge.nodes[1]];
      double least = std::numeric_limits<double>::infinity();
      for(int k = 0; k <= 64; ++k)
        least = (std::min)(least, distance((1. - k / 64.) * a.place + (k / 64.) * b.place));
      EXPECT_LE(edge.radius, least * (1. + 1e-5) + 1e-9); // points of the frame may be nearer
      const bool is_by_frame = (std::max)(a.radius, b.radius) >= 2.;
      EXPECT_TRUE(is_by_frame || edge.radius >= least - impl::norm(a.place - b.place) / 64. - 1e-5);
    }
  }
}

TEST(Linked_segments, AddUpToLinkingNumbers) {
  Random random(4);
  int linked_ones = 0;
  for(int i = 0; i < 200; ++i) {
    const std::vector<std::vector<impl::Vector>> loops = {random_points(6, random),
                                                          random_points(9, random)};
    const std::vector<impl::Vector> curve = random_points(8, random);
    const impl::Linked_segments linked(impl::Execution(), loops);
    Linking_row row;
    std::uint64_t name = 0;
    for(std::size_t k = 0; k < curve.size(); ++k) {
      linked.add(curve[k], curve[(k + 1) % curve.size()], row);
      name += linked.name(curve[k], curve[(k + 1) % curve.size()]);
    }
    impl::add_up(row);
    EXPECT_EQ(name, linked.name(row));
    EXPECT_EQ(name == 0, row.empty());
    int sign = 0; // of a convention
    for(Index l = 0; l < loops.size(); ++l) {
      const int expected = static_cast<int>(std::lround(
          linking_number({curve.begin(), curve.end()}, {loops[l].begin(), loops[l].end()})));
      const auto entry =
          std::find_if(row.begin(), row.end(), [&](const auto& e) { return e.first == l; });
      const int number = entry == row.end() ? 0 : entry->second;
      EXPECT_EQ(std::abs(number), std::abs(expected));
      if(expected != 0) {
        ++linked_ones;
        const int same = number == expected ? 1 : -1;
        EXPECT_TRUE(sign == 0 || sign == same);
        sign = same;
      }
    }
  }
  EXPECT_GT(linked_ones, 20);
}

// A ring of straight pieces with three-cornered sections, and faces far longer than those.
struct Wire
{
  static constexpr std::uint32_t pieces = 12;
  static constexpr double radius = 0.2, out = 4e-4; // of the ring, and of the corners

  static Soup soup() {
    Soup soup;
    for(std::uint32_t i = 0; i < pieces; ++i)
      for(const int k : {0, 1, 2}) {
        const double a = 2. * pi * i / pieces, b = 2. * pi * k / 3.;
        const double r = radius + out * std::cos(b);
        soup.points.push_back({r * std::cos(a), r * std::sin(a), out * std::sin(b)});
      }
    for(std::uint32_t i = 0; i < pieces; ++i)
      for(std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = 3 * i, b = 3 * ((i + 1) % pieces), next = (k + 1) % 3;
        soup.triangles.push_back({a + k, b + k, b + next});
        soup.triangles.push_back({a + k, b + next, a + next});
      }
    return soup;
  }

  impl::Flat_mesh mesh = flat_mesh_of(soup());
  impl::Face_tree faces{impl::Execution(), mesh, impl::span_of(mesh.points)};
  impl::Wall wall{mesh, impl::span_of(mesh.points), faces};
  impl::Clearance clearance{faces, 1e-3};

  static constexpr double pi = 3.14159265358979323846;
};

// Whether balls fit all along a segment is what distances at many points of it say; where they do
// not, a point is named where they do not.
TEST(Clearance, IsThatAllAlongASegment) {
  const Wire wire;
  Random random(5);
  std::size_t free = 0, narrow = 0;
  for(int i = 0; i < 2000; ++i) {
    const auto place = [&] {
      return Wire::radius * impl::Vector{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                                         random.uniform(-0.1, 0.1)};
    };
    const impl::Vector a = place(), b = place();
    const impl::Free_ball first{a, wire.clearance.at(a, 1.)}, last{b, wire.clearance.at(b, 1.)};
    const double radius = random.uniform(0.01, 1.) * (std::min)(first.radius, last.radius);
    double least = 1.;
    constexpr int n = 500;
    for(int k = 0; k <= n; ++k)
      least =
          (std::min)(least, wire.clearance.at((1. - double(k) / n) * a + (double(k) / n) * b, 1.));
    if(const auto where = wire.clearance.narrow_between(first, last, radius)) {
      EXPECT_LT(wire.clearance.at(*where, 1.), radius);
      EXPECT_LT(least, radius + impl::norm(b - a) / n);
      ++narrow;
    } else {
      EXPECT_GE(least, (1. - wire.clearance.tolerance()) * radius);
      ++free;
    }
  }
  EXPECT_GT(free, 300u);
  EXPECT_GT(narrow, 300u);
}

// The room in a cone over a loop, looked at in many places, is no more than that, and nearly as
// much.
TEST(Room_in_caps, BoundsTheRoomInCones) {
  for(unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Wire wire;
    std::vector<impl::Vector> loop;
    const double size = seed % 2 == 0 ? 3. * Wire::radius : 2. * Wire::out;
    for(int k = 0; k < 9; ++k) {
      const double a = 2. * Wire::pi * k / 9.;
      loop.push_back(impl::Vector{seed % 2 == 0 ? 0. : Wire::radius, 0., 0.} +
                     size * random.uniform(0.5, 1.) *
                         impl::Vector{std::cos(a), std::sin(a), random.uniform(-0.2, 0.2)});
    }
    const double bound = impl::Room_in_caps(wire.faces, wire.clearance, 0.01).of_loop(loop);
    impl::Vector middle = {0., 0., 0.};
    double length = 0.;
    const auto next = [&](std::size_t i) { return loop[(i + 1) % loop.size()]; };
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const double side = impl::norm(next(i) - loop[i]);
      middle = middle + 0.5 * side * (loop[i] + next(i));
      length += side;
    }
    middle = (1. / length) * middle;
    double room = 0.;
    constexpr int n = 60;
    for(std::size_t i = 0; i < loop.size(); ++i)
      for(int j = 0; j <= n; ++j)
        for(int k = 0; j + k <= n; ++k)
          room = (std::max)(room, wire.clearance.at((1. - double(j + k) / n) * middle +
                                                        (double(j) / n) * loop[i] +
                                                        (double(k) / n) * next(i),
                                                    4.));
    EXPECT_GE(bound, (1. - 1e-12) * room);
    EXPECT_LE(bound, 1.05 * room);
  }
}

TEST(Pushed_loops, FindTheWayInAThinWire) {
  const Wire wire;
  std::vector<impl::Vector> around(wire.mesh.points.begin(), wire.mesh.points.begin() + 3), along;
  for(std::size_t i = 0; i < Wire::pieces; ++i)
    along.push_back(wire.mesh.points[3 * i]); // an edge of 60 degrees
  const impl::Linked_segments linked(impl::Execution(), {around, along});
  const impl::Cycle_trials trials(wire.clearance, linked, 0.015);
  const impl::Pushed_loops pushed(wire.wall, wire.clearance, trials);
  std::size_t inside = 0;
  for(const auto& [row, trial] : pushed.find(along, 0, Wire::out)) {
    EXPECT_TRUE(trial.is_wide);
    if(row.empty())
      continue;
    ++inside;
    EXPECT_EQ(row.size(), 1u); // it goes through the loop around, once
    EXPECT_EQ(row[0].first, 0u);
    EXPECT_EQ(std::abs(row[0].second), 1);
    EXPECT_GE(trial.radius, 0.2 * Wire::out);
    EXPECT_LE(trial.radius, 0.5 * Wire::out);
    const impl::Cycle_trial wider = trials.widened(trial, row, 0.5 * Wire::out);
    EXPECT_GE(wider.radius, 0.47 * Wire::out);
    EXPECT_EQ(trials.row_of(wider.curve), row);
    for(const auto& [place, radius] : wider.curve) {
      EXPECT_GE(wire.clearance.at(place, 1.), (1. - 1e-9) * radius);
      EXPECT_GE(radius, (1. - 1e-9) * wider.radius);
    }
  }
  EXPECT_EQ(inside, 1u);
}

// Memory with holes of many sizes, in which what is allocated next lies in no order.
std::vector<std::unique_ptr<char[]>> memory_with_holes(Random& random) {
  std::vector<std::unique_ptr<char[]>> pieces, kept;
  for(int i = 0; i < 2000; ++i)
    pieces.push_back(std::make_unique<char[]>(1 + random.below(20000)));
  for(auto& piece : pieces)
    if(random.below(2) == 0)
      kept.push_back(std::move(piece));
  return kept;
}

TEST(Way_network, IsTheSameWhereverItIsInMemory) {
  const Wire wire;
  Random random(9);
  impl::Cycle_trial way;
  way.is_wide = true;
  way.radius = Wire::radius;
  for(int i = 0; i < 300; ++i)
    way.curve.push_back(
        {{random.uniform(-9., 9.) * Wire::radius, random.uniform(-9., 9.) * Wire::radius,
          random.uniform(2., 9.) * Wire::radius},
         Wire::radius});
  const auto edges = [&] {
    std::vector<std::array<Index, 2>> nodes;
    for(const auto& edge :
        impl::Way_network(impl::Execution(), wire.clearance, {way}, 9. * Wire::radius).edges)
      nodes.push_back(edge.nodes);
    return nodes;
  };
  const auto first = edges();
  EXPECT_GT(first.size(), 300u);
  for(int i = 0; i < 20; ++i) {
    const auto memory = memory_with_holes(random);
    EXPECT_EQ(edges(), first);
  }
}

// Through the ring, the plane across it, and one that cuts it in two.
TEST(Plane_section, IsTheCapAroundItsPlace) {
  const Wire wire;
  const auto section = [&](const impl::Vector& place, const impl::Vector& normal) {
    return impl::Plane_section(wire.faces, impl::span_of(wire.mesh.points), place, normal);
  };
  const auto area = [](const impl::Plane_section& of) {
    double sum = 0.;
    for(const auto& [a, b, c] : of.triangles())
      sum += 0.5 * impl::norm(impl::cross(b - a, c - a));
    return sum;
  };
  std::vector<impl::Free_ball> along;
  for(std::uint32_t i = 0; i < Wire::pieces; ++i)
    along.push_back({(1. / 3.) * (wire.mesh.points[3 * i] + wire.mesh.points[3 * i + 1] +
                                  wire.mesh.points[3 * i + 2]),
                     0.});
  const double exact = 0.75 * std::sqrt(3.) * Wire::out * Wire::out; // across the wire

  const impl::Vector in_wire = 0.5 * (along[0].place + along[1].place);
  const impl::Plane_section across = section(in_wire, along[1].place - along[0].place);
  EXPECT_NEAR(area(across), exact * std::cos(Wire::pi / Wire::pieces), 1e-3 * exact);
  EXPECT_EQ(across.passages(along), 1);
  std::reverse(along.begin(), along.end());
  EXPECT_EQ(across.passages(along), -1);

  const impl::Plane_section through = section({0., 0., 0.}, {0., 0., 1.});
  const double radius = Wire::radius - 0.5 * Wire::out; // of the inner corners
  EXPECT_NEAR(area(through), 3. * radius * radius, 2e-3 * radius * radius);
  EXPECT_EQ(through.passages(along), 0);

  EXPECT_TRUE(section({0., 0., 0.}, {1., 0., 0.1}).triangles().empty()); // it goes on and on
}

} // namespace test_measure_parts
