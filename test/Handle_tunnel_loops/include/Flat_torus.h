#ifndef HTL_TEST_FLAT_TORUS_H
#define HTL_TEST_FLAT_TORUS_H

#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// A torus without curvature: a rectangle whose opposite sides are one, folded into space without
// stretching it. One way it goes around a square prism, the other way to its end and back. All
// closed geodesics are known: their length is that of the way in the plane.
//
// The rows of vertices are straight, so that the quadrangles between them may be cut in two either
// way; which way, and where the vertices of a row are, is random.
class Flat_torus
{
public:
  // `columns` must be a multiple of 4, `rows` of 2.
  Flat_torus(std::size_t columns,
             std::size_t rows,
             double width,
             double height,
             generators::Random& random)
      : width_(width)
      , height_(height) {
    std::vector<double> x, y;
    for(std::size_t j = 0; j < rows; ++j) {
      const double offset = j % (rows / 2) == 0 ? 0. : random.uniform(-0.3, 0.3);
      y.push_back((static_cast<double>(j) + offset) * height / static_cast<double>(rows));
    }
    for(std::size_t j = 0; j < rows; ++j)
      for(std::size_t i = 0; i < columns; ++i) {
        const double offset = i % (columns / 4) == 0 ? 0. : random.uniform(-0.4, 0.4);
        const double u = (static_cast<double>(i) + offset) * width / static_cast<double>(columns);
        places_.emplace_back(u, y[j]);
        soup_.points.push_back(folded(u, y[j]));
      }
    const auto vertex = [&](std::size_t i, std::size_t j) {
      return static_cast<Index>((j % rows) * columns + i % columns);
    };
    for(std::size_t j = 0; j < rows; ++j)
      for(std::size_t i = 0; i < columns; ++i) {
        const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                    d = vertex(i, j + 1);
        if(random.below(2) == 0)
          soup_.triangles.insert(soup_.triangles.end(), {{a, b, c}, {a, c, d}});
        else
          soup_.triangles.insert(soup_.triangles.end(), {{a, b, d}, {b, c, d}});
      }
  }

  const Soup& soup() const { return soup_; }

  // How often a closed walk on the edges goes around each way.
  std::pair<int, int> turns(const std::vector<Index>& walk) const {
    double u = 0., v = 0.;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const auto [u1, v1] = places_[walk[i]];
      const auto [u2, v2] = places_[walk[(i + 1) % walk.size()]];
      u += std::remainder(u2 - u1, width_);
      v += std::remainder(v2 - v1, height_);
    }
    return {static_cast<int>(std::lround(u / width_)), static_cast<int>(std::lround(v / height_))};
  }

  double geodesic_length(const std::pair<int, int>& turns) const {
    return std::hypot(turns.first * width_, turns.second * height_);
  }

private:
  std::array<double, 3> folded(double u, double v) const {
    const double side = width_ / 4.;
    const int k = static_cast<int>(u / side) % 4;
    const double t = u - k * side;
    const double z = v < height_ / 2. ? v : height_ - v;
    switch(k) {
    case 0:
      return {t, 0., z};
    case 1:
      return {side, t, z};
    case 2:
      return {side - t, side, z};
    default:
      return {0., side - t, z};
    }
  }

  double width_, height_;
  std::vector<std::pair<double, double>> places_; // in the rectangle
  Soup soup_;
};

#endif // HTL_TEST_FLAT_TORUS_H
