#ifndef HTL_TEST_BORED_PARTS_H
#define HTL_TEST_BORED_PARTS_H

#include "Meshes_of_soups.h"

#include "generators/Field.h"
#include "generators/Random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Parts as they are designed: plates, blocks and flanges with bores, in long triangles.

// A part, and what it was made from.
struct Bored_part
{
  std::string kind;
  Mesh mesh, blank;
  std::vector<double> diameters; ///< of bores with six sides and more, the narrowest of each
};

class Bored_part_maker
{
  using Exact_mesh =
      CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  using Exact_point = Exact_mesh::Point;
  using Vector = generators::Vector;
  using Placing = std::function<Vector(const Vector&)>;
  using Section = std::vector<std::array<double, 2>>; // convex, anticlockwise

public:
  // Every other part lies askew in space, so that all coordinates are rounded.
  explicit Bored_part_maker(unsigned seed)
      : random_(seed)
      , kind_(seed % number_of_kinds)
      , is_askew_(seed / number_of_kinds % 2 == 1) {
    for(double& angle : angles_)
      angle = random_.uniform(0., 1.);
  }

  Bored_part operator()() {
    static constexpr std::array<std::pair<const char*, void (Bored_part_maker::*)()>,
                                number_of_kinds>
        kinds = {{{"plate", &Bored_part_maker::make_plate},
                  {"plate with counterbores", &Bored_part_maker::make_counterbores},
                  {"plate with slots", &Bored_part_maker::make_slots},
                  {"block with bores that meet", &Bored_part_maker::make_cross_drilled},
                  {"flange", &Bored_part_maker::make_flange},
                  {"plate with oblique bores", &Bored_part_maker::make_oblique},
                  {"plate with keyways", &Bored_part_maker::make_keyways}}};
    (this->*kinds[kind_].second)();
    return {std::string(kinds[kind_].first) + (is_askew_ ? ", askew" : ""), copy_of(part_),
            copy_of(blank_), diameters_};
  }

private:
  static constexpr unsigned number_of_kinds = 7;

  // ---- the kinds

  void make_plate() {
    on_grid([this](double x, double y) {
      round_bore(random_.uniform(0.05, 0.4), number_of_sides(), at(x, y));
    });
  }

  // On one side, or on both.
  void make_counterbores() {
    on_grid([this](double x, double y) {
      const double radius = random_.uniform(0.1, 0.2), wider = radius * random_.uniform(1.5, 2.);
      const double depth = random_.uniform(0.1, 0.4) * thickness_;
      round_bore(radius, (std::max)(std::size_t(6), number_of_sides()), at(x, y));
      const std::size_t sides = random_.below(3);
      if(sides != 0)
        cut(polygon(wider, number_of_sides()), at(x, y), thickness_ - depth, 2. * thickness_);
      if(sides != 1)
        cut(polygon(wider, number_of_sides()), at(x, y), -thickness_, depth);
    });
  }

  void make_slots() {
    on_grid([this](double x, double y) {
      const double radius = random_.uniform(0.05, 0.15);
      const double length = random_.uniform(0.1, 0.4 - radius);
      bore(slot(radius, length, 2 + random_.below(12)), at(x, y));
    });
  }

  // Bores along the edges of a block, each of which meets some others.
  void make_cross_drilled() {
    const double size = random_.uniform(2., 3.);
    thickness_ = size;
    start(rectangle(size, size));
    const std::size_t number = 2 + random_.below(3);
    for(std::size_t i = 0; i < number; ++i) {
      const auto section = polygon(random_.uniform(0.1, 0.3), number_of_sides());
      const double x = size / 2. + random_.uniform(-0.1, 0.1),
                   y = i < 3 ? size / 2. + random_.uniform(-0.1, 0.1) : 0.2 * size;
      bore(section, [x, y, axis = i % 3](const Vector& p) {
        const std::array<double, 3> q = {p.x() + x, p.y() + y, p.z()};
        return Vector(q[axis], q[(axis + 1) % 3], q[(axis + 2) % 3]);
      });
    }
  }

  void make_flange() {
    thickness_ = random_.uniform(0.1, 1.);
    start(polygon(3., 24 + random_.below(60)));
    round_bore(random_.uniform(0.5, 1.5), number_of_sides(), at(0., 0.));
    const std::size_t number = 3 + random_.below(6);
    const double radius = random_.uniform(0.05, 0.3);
    const std::size_t sides = number_of_sides();
    for(std::size_t i = 0; i < number; ++i) {
      const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(number);
      round_bore(radius, sides, at(2.3 * std::cos(angle), 2.3 * std::sin(angle)));
    }
  }

  void make_oblique() {
    on_grid([this](double x, double y) {
      const double tilt = random_.uniform(-0.15, 0.15) / thickness_;
      bore(polygon(random_.uniform(0.05, 0.25), number_of_sides()),
           [x, y, tilt, middle = thickness_ / 2.](const Vector& p) {
             return Vector(x + p.x() + tilt * (p.z() - middle), y + p.y(), p.z());
           });
    });
  }

  // Their walls have convex edges.
  void make_keyways() {
    on_grid([this](double x, double y) {
      const double radius = random_.uniform(0.1, 0.3), width = radius * random_.uniform(0.3, 0.8),
                   depth = radius * random_.uniform(1.1, 1.4);
      bore(polygon(radius, 24 + random_.below(40)), at(x, y));
      bore(rectangle(depth, width), at(x, y - width / 2.));
    });
  }

  // ---- their features

  // A plate with a feature in most cells of a grid, in at least one.
  void on_grid(const std::function<void(double, double)>& cut_at) {
    const std::size_t columns = 1 + random_.below(3), rows = 1 + random_.below(3);
    thickness_ = random_.uniform(0.1, 1.5);
    start(rectangle(static_cast<double>(columns), static_cast<double>(rows)));
    for(std::size_t i = 0; i < columns; ++i)
      for(std::size_t j = 0; j < rows; ++j)
        if(i + j == 0 || random_.below(4) != 0)
          cut_at(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
  }

  std::size_t number_of_sides() {
    constexpr std::array<std::size_t, 6> usual = {4, 6, 8, 12, 24, 48};
    return usual[random_.below(usual.size())];
  }

  Section polygon(double radius, std::size_t sides) { return slot(radius, 0., sides); }

  void round_bore(double radius, std::size_t sides, const Placing& place) {
    if(sides >= 6)
      diameters_.push_back(2. * radius);
    bore(polygon(radius, sides), place);
  }

  // Two half circles of so many sides each, or together if they are one circle.
  Section slot(double radius, double length, std::size_t sides) {
    const double start = random_.uniform(0., 2. * CGAL_PI);
    Section section;
    const auto add = [&](double angle, double shift) {
      const double x = radius * std::cos(angle) + shift, y = radius * std::sin(angle);
      section.push_back(
          {x * std::cos(start) - y * std::sin(start), x * std::sin(start) + y * std::cos(start)});
    };
    const double step = (length > 0. ? 1. : 2.) * CGAL_PI / static_cast<double>(sides);
    for(std::size_t i = 0; i < sides; ++i)
      add(step * static_cast<double>(i) - CGAL_PI / 2., length / 2.);
    if(length > 0.) {
      add(CGAL_PI / 2., length / 2.);
      for(std::size_t i = 0; i <= sides; ++i)
        add(step * static_cast<double>(i) + CGAL_PI / 2., -length / 2.);
    }
    return section;
  }

  static Section rectangle(double width, double depth) {
    return {{0., 0.}, {width, 0.}, {width, depth}, {0., depth}};
  }

  static Placing at(double x, double y) {
    return [x, y](const Vector& p) { return Vector(p.x() + x, p.y() + y, p.z()); };
  }

  // ---- how they are made

  void start(const Section& section) {
    blank_ = prism(section, at(0., 0.), 0., thickness_);
    part_ = blank_;
  }

  void bore(const Section& section, const Placing& place) {
    cut(section, place, -thickness_, 2. * thickness_);
  }

  void cut(const Section& section, const Placing& place, double low, double high) {
    Exact_mesh tool = prism(section, place, low, high);
    if(!CGAL::Polygon_mesh_processing::corefine_and_compute_difference(part_, tool, part_))
      throw std::logic_error("a bore cannot be cut");
  }

  Exact_mesh prism(const Section& section, const Placing& place, double low, double high) const {
    Exact_mesh mesh;
    std::vector<Exact_mesh::Vertex_index> v;
    for(const double z : {low, high})
      for(const auto& [x, y] : section)
        v.push_back(mesh.add_vertex(placed(place(Vector(x, y, z)))));
    const std::size_t n = section.size();
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      mesh.add_face(v[i], v[j], v[n + j]);
      mesh.add_face(v[i], v[n + j], v[n + i]);
      if(i > 0 && j > 0) {
        mesh.add_face(v[0], v[j], v[i]);
        mesh.add_face(v[n], v[n + i], v[n + j]);
      }
    }
    return mesh;
  }

  Exact_point placed(const Vector& p) const {
    if(!is_askew_)
      return {p.x(), p.y(), p.z()};
    std::array<double, 3> q = {p.x(), p.y(), p.z()};
    for(std::size_t i = 0; i < 3; ++i) {
      const double c = std::cos(angles_[i]), s = std::sin(angles_[i]);
      double &x = q[i], &y = q[(i + 1) % 3];
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    }
    return {q[0], q[1], q[2]};
  }

  // With no gaps in the numbers.
  static Mesh copy_of(const Exact_mesh& mesh) {
    Mesh copy;
    CGAL::copy_face_graph(mesh, copy);
    return copy;
  }

  generators::Random random_;
  const unsigned kind_;
  const bool is_askew_;
  std::array<double, 3> angles_;
  double thickness_ = 1.;
  Exact_mesh blank_, part_;
  std::vector<double> diameters_;
};

#endif // HTL_TEST_BORED_PARTS_H
