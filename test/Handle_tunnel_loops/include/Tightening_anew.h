#ifndef HTL_TEST_TIGHTENING_ANEW_H
#define HTL_TEST_TIGHTENING_ANEW_H

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/remove_turns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tightening_anew {

using namespace CGAL::Handle_tunnel_loops::internal;

// Tightens a loop as `Loop_tightening` does, but lays the whole strip out anew in each round, and
// finds all places where the loop crosses edges.
class Tightening_anew
{
public:
  explicit Tightening_anew(const Flat_mesh& mesh)
      : mesh_(mesh) {}

  // Stops when a round gains less than a thousandth part of the length and changes no side, at the
  // latest after the given number of rounds.
  void tighten(Crossing_loop& loop, std::size_t maximum_number_of_rounds) {
    remove_backtracks(loop);
    remove_turns(mesh_, loop);
    Crossing_loop best = loop;
    double best_length = length(mesh_, best), previous_length = best_length;
    // On the mesh, not in the plane: on slivers rounding can make the two differ.
    const auto keep_if_best = [&] {
      const double current = length(mesh_, loop);
      if(current <= best_length) {
        best = loop;
        best_length = current;
      }
    };
    int idle_rounds = 0;
    // Where many points coincide, going around them may seem to gain without end.
    const std::size_t largest_size = 8 * loop.size() + 64,
                      largest_work = 2 * maximum_number_of_rounds * (loop.size() + 64);
    std::size_t work = 0;
    for(std::size_t round = 1;
        round <= maximum_number_of_rounds && loop.size() >= 3 && loop.size() <= largest_size &&
        work <= largest_work && idle_rounds < 2;
        ++round)
    {
      work += loop.size();
      rotate_start(loop);
      shorten_within_strip(loop);
      const double current = length_in_plane();
      const bool is_measured = round % 8 == 0 || round == maximum_number_of_rounds;
      if(is_measured)
        keep_if_best();
      const bool changed = change_sides(loop);
      idle_rounds = changed || current < 0.999 * previous_length ? 0 : idle_rounds + 1;
      if(idle_rounds == 2 && !is_measured)
        keep_if_best();
      previous_length = current;
    }
    if(!loop.empty())
      loop = std::move(best);
  }

private:
  using Point_2 = std::array<double, 2>;

  static Point_2 minus(const Point_2& a, const Point_2& b) { return {a[0] - b[0], a[1] - b[1]}; }
  static double cross(const Point_2& a, const Point_2& b) { return a[0] * b[1] - a[1] * b[0]; }
  static double dot(const Point_2& a, const Point_2& b) { return a[0] * b[0] + a[1] * b[1]; }

  // The place where the path is held moves by an irrational part of the loop from round to round.
  static void rotate_start(Crossing_loop& loop) {
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(loop.size() * 0.381966),
                loop.end());
  }

  double squared_length(Index u, Index v) const {
    const Vector e = mesh_.points[v] - mesh_.points[u];
    return CGAL::Handle_tunnel_loops::internal::dot(e, e);
  }

  // Lays the strip out: portal i is crossing i, portal n the first one again.
  void unfold(const Crossing_loop& loop) {
    const std::size_t n = loop.size();
    left_.resize(n + 1);
    right_.resize(n + 1);
    double base = squared_length(loop[0].left, loop[0].right);
    left_[0] = {0., 0.};
    right_[0] = {0., -std::sqrt(base)};
    for(std::size_t i = 0; i < n; ++i) {
      const Crossing& from = loop[i];
      const Crossing& to = loop[i + 1 == n ? 0 : i + 1];
      const bool keeps_left = to.left == from.left;
      const Index apex = keeps_left ? to.right : to.left;
      const double to_left = squared_length(from.left, apex);
      const double to_right = squared_length(from.right, apex);
      const Point_2 p = apex_position(left_[i], right_[i], base, to_left, to_right);
      left_[i + 1] = keeps_left ? left_[i] : p;
      right_[i + 1] = keeps_left ? p : right_[i];
      base = keeps_left ? to_left : to_right;
    }
  }

  // Of the triangle over l - r with the given squared lengths. Heading along +x, with l above r,
  // the apex is ahead.
  static Point_2
  apex_position(const Point_2& l, const Point_2& r, double base, double to_left, double to_right) {
    if(base == 0.)
      return {l[0] + std::sqrt(to_left), l[1]};
    const double along = 0.5 * (to_left - to_right + base) / base;
    const double ahead = std::sqrt((std::max)(0., to_left / base - along * along));
    const Point_2 d = minus(r, l);
    return {l[0] + along * d[0] - ahead * d[1], l[1] + along * d[1] + ahead * d[0]};
  }

  struct Bend
  {
    std::size_t portal;
    Point_2 point;
  };

  // Of the path that has been found last.
  double length_in_plane() const {
    double sum = 0.;
    for(std::size_t b = 1; b < bends_.size(); ++b) {
      const Point_2 step = minus(bends_[b].point, bends_[b - 1].point);
      sum += std::sqrt(dot(step, step));
    }
    return sum;
  }

  void shorten_within_strip(Crossing_loop& loop) {
    unfold(loop);
    find_bends(loop);
    set_ratios(loop);
  }

  // At the ends exactly: the funnel has to tell whether the path is held at a corner.
  static Point_2 between(const Point_2& l, const Point_2& r, double ratio) {
    return {(1. - ratio) * l[0] + ratio * r[0], (1. - ratio) * l[1] + ratio * r[1]};
  }

  // One side of the funnel: the corners that a path from the apex, the last of `bends_`, would turn
  // around on its way to the last of them.
  struct Funnel_side
  {
    std::vector<Bend> corners;
    std::size_t first = 0;
    double sign; // 1 to the left, -1 to the right

    void clear() {
      corners.clear();
      first = 0;
    }
    bool is_empty() const { return first == corners.size(); }
  };

  // The funnel algorithm of Lee and Preparata: `bends_` are the corners of the shortest path
  // through the portals. Each corner enters the funnel once and leaves it once.
  void find_bends(const Crossing_loop& loop) {
    const std::size_t n = loop.size();
    const double ratio = loop[0].ratio;
    const Bend goal = {n, between(left_[n], right_[n], ratio)};
    bends_.clear();
    bends_.push_back({0, between(left_[0], right_[0], ratio)});
    funnel_left_.clear();
    funnel_right_.clear();
    for(std::size_t i = 1; i < n; ++i) {
      if(i == 1 || loop[i].right != loop[i - 1].right)
        narrow(funnel_right_, funnel_left_, {i, right_[i]});
      if(i == 1 || loop[i].left != loop[i - 1].left)
        narrow(funnel_left_, funnel_right_, {i, left_[i]});
    }
    narrow(funnel_left_, funnel_right_, goal);
    bends_.insert(bends_.end(), funnel_left_.corners.begin() + funnel_left_.first,
                  funnel_left_.corners.end());
    if(bends_.back().portal != n)
      bends_.push_back(goal);
  }

  // Lets one side of the funnel end at `corner`. Where that lies beyond the other side, the path
  // turns around the corners there. Corners that it passes straight ahead count as well: there too
  // the way around the other side may be shorter.
  void narrow(Funnel_side& side, Funnel_side& other, const Bend& corner) {
    std::vector<Bend>& corners = side.corners;
    if(corner.point == (side.is_empty() ? bends_ : corners).back().point)
      return;
    while(!side.is_empty() &&
          !passes(side.first + 1 == corners.size() ? bends_.back() : corners[corners.size() - 2],
                  corners.back(), corner, side.sign))
      corners.pop_back();
    if(side.is_empty())
      while(!other.is_empty() &&
            passes(bends_.back(), other.corners[other.first], corner, other.sign))
        bends_.push_back(other.corners[other.first++]);
    corners.push_back(corner);
  }

  // Whether the shortest path to `to` that stays to the right of `by` (sign 1) or to the left of it
  // (-1) touches it.
  static bool passes(const Bend& from, const Bend& by, const Bend& to, double sign) {
    const Point_2 first = minus(by.point, from.point), second = minus(to.point, by.point);
    const double turn = sign * cross(first, second);
    return turn > 0. || (turn == 0. && dot(first, second) >= 0.);
  }

  void set_ratios(Crossing_loop& loop) const {
    for(std::size_t b = 0; b + 1 < bends_.size(); ++b) {
      const Point_2 from = bends_[b].point;
      const Point_2 direction = minus(bends_[b + 1].point, from);
      for(std::size_t i = bends_[b].portal + (b == 0 ? 1 : 0);
          i < (std::min)(bends_[b + 1].portal + 1, loop.size()); ++i)
        loop[i].ratio = crossing_ratio(i, from, direction);
    }
    for(std::size_t b = 1; b + 1 < bends_.size(); ++b)
      hold_at_corner(loop, bends_[b]);
  }

  // Where the path goes through a vertex but for rounding, it goes through the vertex.
  double crossing_ratio(std::size_t i, const Point_2& from, const Point_2& direction) const {
    const double across = cross(minus(right_[i], left_[i]), direction);
    const double ratio = across == 0. ? 0.5 : cross(minus(from, left_[i]), direction) / across;
    constexpr double rounding = 1e-12;
    return ratio < rounding ? 0. : ratio > 1. - rounding ? 1. : ratio;
  }

  // All the portals that end at the corner are passed exactly there.
  void hold_at_corner(Crossing_loop& loop, const Bend& bend) const {
    const bool at_left = left_[bend.portal] == bend.point;
    const Index corner = at_left ? loop[bend.portal].left : loop[bend.portal].right;
    const auto ends_there = [&](std::size_t i) {
      return i < loop.size() && (at_left ? loop[i].left : loop[i].right) == corner;
    };
    for(std::size_t i = bend.portal; ends_there(i); ++i)
      loop[i].ratio = at_left ? 0. : 1.;
    for(std::size_t i = bend.portal; i > 0 && ends_there(i - 1) && i - 1 > 0; --i)
      loop[i - 1].ratio = at_left ? 0. : 1.;
  }

  // A maximal run of portals that end at one corner, at which the path bends.
  struct Fan
  {
    std::size_t first, last;
    bool at_left;
  };

  bool change_sides(Crossing_loop& loop) {
    std::vector<Fan> fans;
    for(std::size_t b = 1; b + 1 < bends_.size(); ++b) {
      const Fan fan = fan_of(loop, bends_[b]);
      const bool is_apart = fans.empty() || fan.first > fans.back().last + 1;
      // The strip cannot be led around a corner that lies where it is held.
      if(fan.first > 1 && fan.last + 2 < loop.size() && is_apart &&
         (portals_of_turns(loop, fan) > 0 ||
          is_shorter_on_other_side(loop, fan, bends_[b - 1].point, bends_[b + 1].point)))
        fans.push_back(fan);
    }
    if(fans.empty())
      return false;
    Crossing_loop changed;
    std::size_t done = 0;
    for(const Fan& fan : fans) {
      changed.insert(changed.end(), loop.begin() + done, loop.begin() + fan.first);
      const std::size_t turns = portals_of_turns(loop, fan);
      if(turns > 0)
        changed.insert(changed.end(), loop.begin() + fan.first + turns,
                       loop.begin() + fan.last + 1);
      else
        append_other_side(loop, fan, changed);
      done = fan.last + 1;
    }
    changed.insert(changed.end(), loop.begin() + done, loop.end());
    loop = std::move(changed);
    remove_backtracks(loop);
    remove_turns(mesh_, loop);
    return true;
  }

  Fan fan_of(const Crossing_loop& loop, const Bend& bend) const {
    const bool at_left = left_[bend.portal] == bend.point;
    const Index corner = at_left ? loop[bend.portal].left : loop[bend.portal].right;
    const auto ends_there = [&](std::size_t i) {
      return (at_left ? loop[i].left : loop[i].right) == corner;
    };
    Fan fan = {bend.portal, bend.portal, at_left};
    while(fan.first > 0 && ends_there(fan.first - 1))
      --fan.first;
    while(fan.last + 1 < loop.size() && ends_there(fan.last + 1))
      ++fan.last;
    return fan;
  }

  // Those of whole turns around the corner.
  std::size_t portals_of_turns(const Crossing_loop& loop, const Fan& fan) const {
    const Crossing& crossing = loop[fan.first];
    const std::size_t turn = mesh_.ring(fan.at_left ? crossing.left : crossing.right).size();
    return (fan.last + 1 - fan.first) / turn * turn;
  }

  // Adds up angles between 0 and a straight one, without trigonometric functions.
  class Angle_sum
  {
  public:
    // adds the angle whose cosine and sine are in the ratio of the arguments. Returns whether the
    // sum is still less than straight.
    bool add(double cosine, double sine) {
      const double c = cosine_ * cosine - sine_ * sine, s = cosine_ * sine + sine_ * cosine;
      const double size = (std::max)(std::abs(c), std::abs(s));
      cosine_ = size > 0. ? c / size : 1.;
      sine_ = size > 0. ? s / size : 0.;
      constexpr double tolerance = 1e-7;
      return sine_ > tolerance || (sine_ >= 0. && cosine_ > 0.);
    }

  private:
    double cosine_ = 1., sine_ = 0.;
  };

  static bool add_angle(const Point_2& a, const Point_2& b, Angle_sum& sum) {
    return sum.add(dot(a, b), std::abs(cross(a, b)));
  }

  bool add_corner(Index v, Index a, Index b, Angle_sum& sum) const {
    const Vector p = mesh_.points[a] - mesh_.points[v], q = mesh_.points[b] - mesh_.points[v];
    return sum.add(CGAL::Handle_tunnel_loops::internal::dot(p, q),
                   norm(CGAL::Handle_tunnel_loops::internal::cross(p, q)));
  }

  // Whether the faces on the other side of the corner, from the way in to the way out, span less
  // than a straight angle.
  bool is_shorter_on_other_side(const Crossing_loop& loop,
                                const Fan& fan,
                                const Point_2& before,
                                const Point_2& after) const {
    const auto& near = fan.at_left ? left_ : right_;
    const Point_2 corner = near[fan.first];
    Angle_sum sum;
    if(!add_angle(minus(before, corner), minus(near[fan.first - 1], corner), sum))
      return false;
    const Index v = fan.at_left ? loop[fan.first].left : loop[fan.first].right;
    const Index from = fan.at_left ? loop[fan.first - 1].left : loop[fan.first - 1].right;
    const Index to = fan.at_left ? loop[fan.last + 1].left : loop[fan.last + 1].right;
    const Ring ring = mesh_.ring(v);
    const Index end = ring.position(to);
    for(Index p = ring.position(from); p != end;) {
      const Index q = fan.at_left ? ring.previous(p) : ring.next(p);
      if(!add_corner(v, ring[p], ring[q], sum))
        return false;
      p = q;
    }
    return add_angle(minus(near[fan.last + 1], corner), minus(after, corner), sum);
  }

  // The strip comes from the triangle before the fan and goes to the one after it; between them it
  // now passes the spokes that it did not pass.
  void append_other_side(const Crossing_loop& loop, const Fan& fan, Crossing_loop& changed) const {
    const Crossing &before = loop[fan.first - 1], &after = loop[fan.last + 1];
    if(fan.at_left) {
      const Index corner = loop[fan.first].left;
      const Ring ring = mesh_.ring(corner);
      const Index end = ring.position(after.left);
      for(Index p = ring.position(before.left);; p = ring.previous(p)) {
        changed.push_back({ring[p], corner, 1.});
        if(p == end)
          break;
      }
    } else {
      const Index corner = loop[fan.first].right;
      const Ring ring = mesh_.ring(corner);
      const Index end = ring.position(after.right);
      for(Index p = ring.position(before.right);; p = ring.next(p)) {
        changed.push_back({corner, ring[p], 0.});
        if(p == end)
          break;
      }
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Point_2> left_, right_;
  std::vector<Bend> bends_;
  Funnel_side funnel_left_ = {{}, 0, 1.}, funnel_right_ = {{}, 0, -1.};
};

} // namespace tightening_anew

using tightening_anew::Tightening_anew;

#endif // HTL_TEST_TIGHTENING_ANEW_H
