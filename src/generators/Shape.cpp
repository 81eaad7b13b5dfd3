// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Shape.h"

#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

constexpr std::size_t fewest_shape_faces = 100;

// The radius that an edge may have where the least extent of a part, from its middle, is known.
double edge_radius(double wanted, double extent) { return (std::min)(wanted, extent / 2.); }

double cylinder_distance(
    const Vector& p, const Vector& a, const Vector& b, double radius, double rounding) {
  const Vector axis = unit(b - a), from = p - a;
  const double along = from * axis, half = length(b - a) / 2.;
  const double edge = edge_radius(rounding, (std::min)(radius, half));
  const double outside = length(from - along * axis) - radius + edge;
  const double beyond = std::abs(along - half) - half + edge;
  return (std::min)((std::max)(outside, beyond), 0.) +
         hypotenuse((std::max)(outside, 0.), (std::max)(beyond, 0.)) - edge;
}

double block_distance(const Vector& p, const Vector& low, const Vector& high, double rounding) {
  double square = 0., inside = -std::numeric_limits<double>::infinity();
  for(int i = 0; i < 3; ++i) {
    const double beyond =
        std::abs(p[i] - (low[i] + high[i]) / 2.) - (high[i] - low[i]) / 2. + rounding;
    inside = (std::max)(inside, beyond);
    square += beyond > 0. ? beyond * beyond : 0.;
  }
  return (std::min)(inside, 0.) + std::sqrt(square) - rounding;
}

double ring_distance(const Vector& p, const Vector& middle, const Vector& axis, double radius) {
  const Vector from = p - middle;
  const double along = from * axis;
  return hypotenuse(length(from - along * axis) - radius, along);
}

// A smooth curve through points (Catmull and Rom), as many short segments.
std::vector<Vector> smooth_curve(const std::vector<Vector>& points, bool is_closed) {
  constexpr int steps = 10;
  const auto n = static_cast<int>(points.size());
  const auto at = [&](int i) {
    return is_closed ? points[static_cast<std::size_t>((i + n) % n)]
                     : points[static_cast<std::size_t>(std::clamp(i, 0, n - 1))];
  };
  std::vector<Vector> curve;
  for(int i = 0; i < (is_closed ? n : n - 1); ++i)
    for(int k = 0; k < steps; ++k) {
      const double t = double(k) / steps;
      const Vector a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
      curve.push_back(0.5 * (2. * b + t * (c - a) + t * t * (2. * a - 5. * b + 4. * c - d) +
                             t * t * t * (3. * b - a - 3. * c + d)));
    }
  curve.push_back(at(is_closed ? 0 : n - 1));
  return curve;
}

double curve_distance(const Vector& p, const std::vector<Vector>& curve) {
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t i = 1; i < curve.size(); ++i)
    least = (std::min)(least, segment_distance(p, curve[i - 1], curve[i]));
  return least;
}

Vector turned(const Vector& p, const Vector& axis, double angle) {
  const Vector along = (p * axis) * axis, across = p - along;
  return along + cosine(angle) * across + sine(angle) * CGAL::cross_product(axis, across);
}

// The least of two distances, with a fillet: never more than the least.
double blended(double a, double b, double size) {
  const double h = (std::max)(size - std::abs(a - b), 0.);
  return (std::min)(a, b) - (size > 0. ? h * h / (4. * size) : 0.);
}

// Two digits are easier to remember: not fewer than \p faces.
std::size_t two_digits(double faces) {
  double unit = 1.;
  while(faces >= 100. * unit)
    unit *= 10.;
  return static_cast<std::size_t>(std::llround(std::ceil(faces / unit) * unit));
}

// A number of faces with which the mesh of a shape has its genus; a larger number was tried, too,
// to exclude chance. Nothing if there is none up to `most`.
std::optional<std::size_t> enough_faces(const Shape& shape, std::size_t too_few, std::size_t most) {
  std::optional<std::size_t> enough;
  for(std::size_t faces = too_few; (faces = two_digits(1.3 * static_cast<double>(faces))) <= most;)
    if(genus(lattice_mesh(shape, faces, shape.most_spacing(faces)).soup) != *shape.genus())
      enough.reset();
    else if(enough)
      return enough;
    else
      enough = faces;
  return enough;
}

std::string too_few(std::size_t faces) {
  return std::to_string(faces) + (faces == 1 ? " face is" : " faces are") + " too few for ";
}

// A number of faces with which the mesh has the genus of the shape.
std::string advice(const Shape& shape, std::size_t faces) {
  const std::size_t parts = (std::max)(shape.number_of_parts(), std::size_t(100));
  const std::size_t most = 40000000 / parts; // more would take long
  if(const auto enough = enough_faces(shape, (std::max)(faces, fewest_shape_faces), most))
    return "; " + std::to_string(*enough) + " faces are enough";
  return "; no number of faces that was tried, up to " + std::to_string((std::max)(faces, most)) +
         ", gives genus " + std::to_string(*shape.genus()) + ", so the text may be wrong";
}

// Edges that are sharper than the spacing of the lattice become jagged, so they are rounded first.
// If thin walls would break, they are not.
Soup fitted_with_rounded_edges(const Lattice_mesh& mesh, const Shape& shape) {
  for(const double cells : {1., 0.5}) {
    const Shape rounded = shape.rounded(cells * mesh.spacing);
    const Lattice_mesh round_mesh = {isosurface(rounded, mesh.spacing, mesh.soup.triangles.size()),
                                     mesh.spacing};
    if(genus(mesh.soup) == genus(round_mesh.soup) &&
       number_of_components(mesh.soup) == number_of_components(round_mesh.soup))
      return fitted(round_mesh, rounded);
  }
  return fitted(mesh, shape);
}

} // namespace

/// Reads a text line by line.
class Shape::Reader
{
public:
  Reader(Shape& shape, std::string_view text)
      : shape_(shape)
      , lines_(std::string(text)) {}

  void read() {
    for(std::string line; std::getline(lines_, line);) {
      ++number_;
      if(line.substr(0, 1) == "#") {
        if(shape_.description_.empty())
          shape_.description_ = line.substr((std::min)(line.find_first_not_of("# "), line.size()));
        continue;
      }
      words_ = std::istringstream(line);
      if(std::string word; words_ >> word)
        read_line(word);
    }
    if(!has_box_)
      throw std::invalid_argument(shape_.parts_.empty()
                                      ? "the shape has no parts"
                                      : "the shape is empty: all its parts are cut out");
    check_size();
  }

private:
  using Motion = std::function<Vector(const Vector&)>;

  [[noreturn]] void fail(const std::string& problem) const {
    throw std::invalid_argument("line " + std::to_string(number_) + " of the shape: " + problem);
  }

  // A shape that is very small, or far away, is lost in rounding errors.
  void check_size() const {
    const double size = length(shape_.box_.high - shape_.box_.low);
    const double away = length(shape_.box_.high + shape_.box_.low) / 2.;
    if(size < 1. / largest || size < 1e-9 * away)
      throw std::invalid_argument(
          "the shape is too small, or too far from the origin, for double precision");
  }

  double number() {
    double value;
    if(!(words_ >> value) || !std::isfinite(value))
      fail("a number is missing");
    if(std::abs(value) > largest)
      fail("a number is too large");
    return value;
  }

  double positive() {
    const double value = number();
    if(!(value > 0.))
      fail("a size must be positive");
    return value;
  }

  std::size_t whole_number() {
    const double value = number();
    if(!(value >= 0. && value <= 1e9 && value == std::floor(value)))
      fail("expected a whole number, 0 or larger");
    return static_cast<std::size_t>(value);
  }

  Vector point() {
    const double x = number(), y = number();
    return {x, y, number()};
  }

  Vector axis() {
    const Vector v = point();
    if(!(length(v) > 0.))
      fail("the direction of an axis must not be zero");
    return unit(v);
  }

  void read_line(const std::string& word) {
    if(word == "genus")
      shape_.genus_ = whole_number();
    else if(word == "faces")
      shape_.faces_ = whole_number();
    else if(word == "blend")
      blend_ = (std::max)(number(), 0.);
    else
      read_part(word, {[](const Vector& p) { return p; }});
    if(std::string rest; words_ >> rest)
      fail("unexpected '" + rest + "' at the end");
  }

  // \p motions map a point to the place where the part is evaluated, one for each repetition.
  void read_part(const std::string& word, const std::vector<Motion>& motions) {
    if(word == "times") {
      const std::vector<Motion> repeated = repetitions(motions);
      std::string next;
      words_ >> next;
      read_part(next, repeated);
      return;
    }
    std::string name = word;
    const bool is_cut = word == "cut";
    if(is_cut && !(words_ >> name))
      fail("'cut' must be followed by a part");
    const auto [distance, box, area, volume] = primitive(name);
    if(shape_.parts_.size() + motions.size() > most_parts)
      fail("the shape has more than 10000 parts");
    shape_.most_area_ += static_cast<double>(motions.size()) * area;
    if(!is_cut)
      shape_.most_volume_ += static_cast<double>(motions.size()) * volume;
    for(const Motion& motion : motions) {
      shape_.parts_.push_back({[distance = distance, motion](const Vector& p, double rounding) {
                                 return distance(motion(p), rounding);
                               },
                               blend_, is_cut});
      if(!is_cut)
        add_box(box, motion);
    }
  }

  std::vector<Motion> repetitions(const std::vector<Motion>& motions) {
    const double count = number();
    std::string how;
    words_ >> how;
    if(!(count >= 1. && count <= most_parts) || (how != "by" && how != "around"))
      fail("'times' must be followed by a number, and 'by' or 'around'");
    const Vector first = point();
    const Vector direction = how == "around" ? axis() : Vector(0., 0., 1.);
    if(count * static_cast<double>(motions.size()) > most_parts)
      fail("a part is repeated more than 10000 times");
    std::vector<Motion> result;
    for(int i = 0; i < static_cast<int>(count); ++i)
      for(const Motion& motion : motions)
        if(how == "by")
          result.push_back([=](const Vector& p) { return motion(p) - double(i) * first; });
        else
          result.push_back([=](const Vector& p) {
            return first +
                   turned(motion(p) - first, direction, -2. * CGAL_PI * i / std::floor(count));
          });
    return result;
  }

  // The distance to a part, its bounding box, and bounds of its area and volume.
  struct Primitive
  {
    Distance distance;
    Box box;
    double area, volume;
  };

  // Around a curve of some length, with round ends.
  static Primitive around(double length, double r, const Box& way, const Distance& distance) {
    return {distance, way.grown(r), 2. * CGAL_PI * r * (length + 2. * r),
            CGAL_PI * r * r * (length + 4. / 3. * r)};
  }

  Primitive primitive(const std::string& name) {
    if(name == "ball") {
      const Vector middle = point();
      const double r = positive();
      return around(0., r, Box{middle, middle},
                    [=](const Vector& p, double) { return length(p - middle) - r; });
    }
    if(name == "rod" || name == "cylinder") {
      const Vector a = point(), b = point();
      const double r = positive();
      if(!(length(b - a) > 0.))
        fail("its length is zero");
      const Box way = Box{a, a}.with(b);
      if(name == "rod")
        return around(length(b - a), r, way,
                      [=](const Vector& p, double) { return segment_distance(p, a, b) - r; });
      return around(length(b - a), r, way, [=](const Vector& p, double edge) { // a little less
        return cylinder_distance(p, a, b, r, edge);
      });
    }
    if(name == "ring") {
      const Vector middle = point(), direction = axis();
      const double radius = positive(), r = positive();
      return around(
          2. * CGAL_PI * radius, r, Box{middle, middle}.grown(radius),
          [=](const Vector& p, double) { return ring_distance(p, middle, direction, radius) - r; });
    }
    if(name == "block") {
      const Vector a = point(), b = point();
      const double rounding = number();
      const Box box = Box{a, a}.with(b);
      const Vector size = box.high - box.low;
      const double room = (std::min)({size.x(), size.y(), size.z()}) / 2.;
      return {[=](const Vector& p, double edge) {
                return block_distance(p, box.low, box.high,
                                      (std::max)(rounding, edge_radius(edge, room)));
              },
              box, 2. * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()),
              size.x() * size.y() * size.z()};
    }
    if(name == "pipe")
      return pipe();
    if(name == "knot")
      return knot();
    fail("'" + name +
         "' is not a part; the parts are ball, rod, cylinder, pipe, ring, knot and block");
  }

  Primitive pipe() {
    const double r = positive();
    const auto position = words_.tellg();
    std::string word;
    const bool is_closed = words_ >> word && word == "closed";
    if(!is_closed) {
      words_.clear();
      words_.seekg(position);
    }
    std::vector<Vector> points;
    while(words_ >> std::ws && !words_.eof())
      points.push_back(point());
    if(points.size() < (is_closed ? 3u : 2u))
      fail("a pipe needs at least two points, a closed one at least three");
    return tube(smooth_curve(points, is_closed), r);
  }

  Primitive knot() {
    const double p = number(), q = number(), radius = positive(), small = positive();
    const double r = positive();
    constexpr int steps = 300;
    std::vector<Vector> curve;
    for(int i = 0; i <= steps; ++i) {
      const double t = 2. * CGAL_PI * (i % steps) / steps;
      const double away = radius + small * cosine(q * t);
      curve.emplace_back(away * cosine(p * t), away * sine(p * t), small * sine(q * t));
    }
    return tube(curve, r);
  }

  static Primitive tube(const std::vector<Vector>& curve, double r) {
    Box box{curve.front(), curve.front()};
    double way = 0.;
    for(std::size_t i = 0; i < curve.size(); ++i) {
      box = box.with(curve[i]);
      way += length(curve[i] - curve[i == 0 ? 0 : i - 1]);
    }
    return around(way, r, box,
                  [=](const Vector& p, double) { return curve_distance(p, curve) - r; });
  }

  // A motion is from the place of a repetition back to the part: its box is moved the other way,
  // which is found from where the motion brings the corners of a frame.
  void add_box(const Box& box, const Motion& motion) {
    const Vector origin = motion(Vector(0., 0., 0.));
    const std::array<Vector, 3> rows = {motion(Vector(1., 0., 0.)) - origin,
                                        motion(Vector(0., 1., 0.)) - origin,
                                        motion(Vector(0., 0., 1.)) - origin};
    for(int corner = 0; corner < 8; ++corner) {
      const Vector from = box.corner(corner) - origin;
      const Vector place(rows[0] * from, rows[1] * from, rows[2] * from);
      shape_.box_ = has_box_ ? shape_.box_.with(place) : Box{place, place};
      has_box_ = true;
    }
  }

  static constexpr double most_parts = 10000.; // each is looked at for each point of a lattice
  static constexpr double largest = 1e100;     // squares and their sums are numbers, too

  Shape& shape_;
  std::istringstream lines_, words_;
  int number_ = 0;
  double blend_ = 0.;
  bool has_box_ = false;
};

Shape::Shape(std::string_view text) {
  Reader(*this, text).read();
  box_ = box_.grown(0.02 * length(box_.high - box_.low));
}

Shape Shape::rounded(double radius) const {
  Shape shape = *this;
  shape.rounding_ = radius;
  return shape;
}

// Of the lattice 12 or 13 triangles take the square of the spacing, and no more than 24 are around
// each of the two points in its cube.
double Shape::most_spacing(std::size_t faces) const {
  const double count = static_cast<double>(faces);
  return (std::min)(std::sqrt(15. * most_area_ / count),
                    power(100. * most_volume_ / count, 1. / 3.));
}

double Shape::operator()(const Vector& p) const {
  double distance = std::numeric_limits<double>::infinity();
  for(const Part& part : parts_) {
    const double other = part.distance(p, rounding_);
    distance = part.is_cut ? -blended(-distance, other, 1.5 * rounding_)
                           : blended(distance, other, part.blend);
  }
  return distance;
}

Soup mesh_of_shape(const Shape& shape, const Request& request, const char* name) {
  require_faces(request, name, 0.);
  const std::size_t faces = request.faces;
  if(faces < fewest_shape_faces)
    throw std::invalid_argument(
        too_few(faces) + "a shape" +
        (shape.genus() ? advice(shape, faces)
                       : "; " + std::to_string(fewest_shape_faces) + " faces are enough"));
  const Lattice_mesh mesh = lattice_mesh(shape, faces, shape.most_spacing(faces));
  if(shape.genus() && genus(mesh.soup) != *shape.genus())
    throw std::invalid_argument(too_few(faces) + "the details of this shape: the mesh would have " +
                                "genus " + std::to_string(genus(mesh.soup)) + " instead of " +
                                std::to_string(*shape.genus()) + advice(shape, faces));
  return fitted_with_rounded_edges(mesh, shape);
}

std::vector<Kind> kinds_of_shapes() {
  static std::deque<std::string> descriptions; // kinds refer to them
  std::vector<Kind> kinds;
  for(const auto& [name, text] : shape_texts()) {
    const Shape shape(text);
    descriptions.push_back(shape.description() + "; genus " + std::to_string(*shape.genus()));
    kinds.push_back({name, descriptions.back().c_str(),
                     [name = name, shape](const Request& request) {
                       require_genus(request, name, *shape.genus());
                       return mesh_of_shape(shape, request, name);
                     },
                     GENUS, shape.faces(), *shape.genus()});
  }
  return kinds;
}

} // namespace CGAL::Handle_tunnel_loops::generators
