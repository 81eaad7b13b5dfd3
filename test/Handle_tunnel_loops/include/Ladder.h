#ifndef HTL_TEST_LADDER_H
#define HTL_TEST_LADDER_H

#include "generators/generators.h"

#include <cstdint>
#include <utility>
#include <vector>

// Two drums whose sides are long triangles from the bottom to the top, and rungs between them, one
// above the other. By height, the contours around the drums meet and part again at every rung, and
// each time both of them are long. The genus is one less than the number of rungs.
class Ladder
{
public:
  using Soup = CGAL::Handle_tunnel_loops::generators::Soup;

  Ladder(std::uint32_t number_of_columns, std::uint32_t number_of_rungs)
      : columns_(number_of_columns)
      , rungs_(number_of_rungs) {
    add_drum(0.);
    add_lid(bottom(0), false);
    add_lid(top(0), true);
    for(std::uint32_t i = 1; i < columns_; ++i) {
      add(bottom(i), bottom(i + 1), top(i + 1));
      add(bottom(i), top(i + 1), top(i));
    }
    add_column_with_holes();
    mirror();
    for(std::uint32_t r = 0; r < rungs_; ++r)
      add_rung(r);
  }

  const Soup& soup() const { return soup_; }

private:
  std::uint32_t bottom(std::uint32_t i) const { return i % columns_; }
  std::uint32_t top(std::uint32_t i) const { return columns_ + i % columns_; }

  // The lowest vertex of a hole, those to the left and to the right, and the highest one.
  std::uint32_t hole(std::uint32_t rung, std::uint32_t i) const {
    return 2 * columns_ + 4 * rung + i;
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.triangles.push_back({a, b, c});
  }

  void add_drum(double x) {
    const double size = columns_;
    for(const double z : {0., size})
      for(std::uint32_t i = 0; i < columns_; ++i)
        soup_.points.push_back({x + double(i), double(i) * double(i) / size, z + 0.001 * i});
    for(std::uint32_t r = 0; r < rungs_; ++r)
      for(std::uint32_t i = 0; i < 4; ++i)
        soup_.points.push_back(
            {x + 0.4 + 0.1 * (i % 2), -1., size * (0.1 + 0.8 * (r + 0.2 * i) / double(rungs_))});
  }

  void add_lid(std::uint32_t first, bool is_top) {
    for(std::uint32_t i = 1; i + 1 < columns_; ++i)
      is_top ? add(first, first + i, first + i + 1) : add(first, first + i + 1, first + i);
  }

  void add_column_with_holes() {
    const std::uint32_t l = top(0), r = top(1);
    add(bottom(0), bottom(1), hole(0, 0));
    add(bottom(0), hole(0, 0), l);
    add(bottom(1), r, hole(0, 0));
    for(std::uint32_t h = 0; h < rungs_; ++h) {
      add_sides(l, r, hole(h, 0), hole(h, 1), hole(h, 2));
      add_sides(l, r, hole(h, 1), hole(h, 3), hole(h, 2), hole(h, 3));
      if(h + 1 < rungs_)
        add_sides(l, r, hole(h, 3), hole(h + 1, 0), hole(h, 3), hole(h + 1, 0));
    }
    add(l, hole(rungs_ - 1, 3), r);
  }

  void add_sides(std::uint32_t l,
                 std::uint32_t r,
                 std::uint32_t below,
                 std::uint32_t left,
                 std::uint32_t right) {
    add_sides(l, r, below, left, below, right);
  }

  void add_sides(std::uint32_t l,
                 std::uint32_t r,
                 std::uint32_t left_below,
                 std::uint32_t left_above,
                 std::uint32_t right_below,
                 std::uint32_t right_above) {
    add(l, left_below, left_above);
    add(r, right_above, right_below);
  }

  void mirror() {
    const std::size_t number_of_triangles = soup_.triangles.size();
    shift_ = static_cast<std::uint32_t>(soup_.points.size());
    add_drum(-2. * columns_);
    for(std::size_t i = 0; i < number_of_triangles; ++i) {
      const auto [a, b, c] = soup_.triangles[i];
      add(a + shift_, c + shift_, b + shift_);
    }
  }

  // Around the hole, with the surface on the left.
  void add_rung(std::uint32_t rung) {
    const std::uint32_t ring[] = {hole(rung, 0), hole(rung, 1), hole(rung, 3), hole(rung, 2)};
    for(int i = 0; i < 4; ++i) {
      const std::uint32_t u = ring[i], v = ring[(i + 1) % 4];
      add(v, u, u + shift_);
      add(v, u + shift_, v + shift_);
    }
  }

  std::uint32_t columns_, rungs_, shift_ = 0;
  Soup soup_;
};

#endif // HTL_TEST_LADDER_H
