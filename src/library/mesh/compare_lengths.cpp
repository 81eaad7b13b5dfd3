// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Square_root_sum.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Compares lengths by intervals, and where these overlap by the sign of a sum of square roots.
class Length_comparison
{
public:
  static Comparison_result compare(const std::vector<Edge_place>& a,
                                   const std::vector<Edge_place>& b) {
    const Uncertain<Comparison_result> result = compare_intervals(a, b);
    return is_certain(result) ? result.inf() : compare_exactly(a, b);
  }

  static std::pair<double, double> interval(const std::vector<Edge_place>& places) {
    const Interval::Protector protector;
    return length(places).pair();
  }

private:
  using Interval = Interval_nt<false>;

  template <typename FT> static std::array<FT, 3> point(const Edge_place& place) {
    std::array<FT, 3> result;
    for(int d = 0; d < 3; ++d) {
      const FT p(place.p[d]), q(place.q[d]);
      result[d] = FT(p + FT(place.ratio) * FT(q - p));
    }
    return result;
  }

  // calls f(s) for the squared length of each segment.
  template <typename FT, typename Function>
  static void for_each_squared_length(const std::vector<Edge_place>& places, const Function& f) {
    if(places.empty())
      return;
    std::array<FT, 3> previous = point<FT>(places.back());
    for(const Edge_place& place : places) {
      const std::array<FT, 3> next = point<FT>(place);
      FT sum(0);
      for(int d = 0; d < 3; ++d)
        sum += CGAL::square(FT(next[d] - previous[d]));
      f(sum);
      previous = next;
    }
  }

  static Interval length(const std::vector<Edge_place>& places) {
    Interval sum(0);
    for_each_squared_length<Interval>(places, [&](const Interval& s) { sum += CGAL::sqrt(s); });
    return sum;
  }

  static Uncertain<Comparison_result> compare_intervals(const std::vector<Edge_place>& a,
                                                        const std::vector<Edge_place>& b) {
    const Interval::Protector protector;
    return CGAL::compare(length(a), length(b));
  }

  static std::vector<Exact_rational> sorted_squared_lengths(const std::vector<Edge_place>& places) {
    std::vector<Exact_rational> result;
    for_each_squared_length<Exact_rational>(places,
                                            [&](const Exact_rational& s) { result.push_back(s); });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Loops that run together have most segments in common, and the sum is slow where many terms
  // cancel: they are left out.
  static Comparison_result compare_exactly(const std::vector<Edge_place>& a,
                                           const std::vector<Edge_place>& b) {
    const std::vector<Exact_rational> of_a = sorted_squared_lengths(a),
                                      of_b = sorted_squared_lengths(b);
    Square_root_sum sum;
    add_difference(of_a, of_b, 1, sum);
    add_difference(of_b, of_a, -1, sum);
    return static_cast<Comparison_result>(sum.sign());
  }

  // Adds the square roots of those that are not among the others as well.
  static void add_difference(const std::vector<Exact_rational>& squares,
                             const std::vector<Exact_rational>& others,
                             int sign,
                             Square_root_sum& sum) {
    std::vector<Exact_rational> difference;
    std::set_difference(squares.begin(), squares.end(), others.begin(), others.end(),
                        std::back_inserter(difference));
    for(const Exact_rational& s : difference)
      sum.add(sign, s);
  }
};

Comparison_result compare_lengths(const std::vector<Edge_place>& a,
                                  const std::vector<Edge_place>& b) {
  return Length_comparison::compare(a, b);
}

std::pair<double, double> length_interval(const std::vector<Edge_place>& places) {
  return Length_comparison::interval(places);
}

} // namespace CGAL::Handle_tunnel_loops::internal
