// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mesh_of_field.h"

#include "kinds.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// whether no point is inside a solid. What it is too tedious to be sure of is not empty.
bool is_empty(const Field& field) {
  constexpr int most_boxes = 200000;
  std::vector<Box> boxes = {field.box()};
  for(int count = 0; !boxes.empty(); ++count) {
    const Box box = boxes.back();
    boxes.pop_back();
    const double value = field((box.low + box.high) / 2.);
    if(value < 0. || count == most_boxes)
      return false;
    // The field is no more than the distance to the surface: a large value tells of the whole box.
    const Vector half = (box.high - box.low) / 2.;
    if(value < length(box.high - box.low) / 2.)
      for(int octant = 0; octant < 8; ++octant) {
        const Vector low = box.low + Box{Vector(0., 0., 0.), half}.corner(octant);
        boxes.push_back({low, low + half});
      }
  }
  return true;
}

/// Meshes with so many faces for each handle do not come to cross themselves when they are
/// smoothed.
constexpr std::size_t fine = 1200;

/// About how many points the tables of a lattice in a box have, one slice after the other.
double lattice_points(const Box& box, double spacing) {
  const Vector size = (box.high - box.low) / spacing;
  return (size.x() + size.y()) * (size.x() + size.z()) * 2. * size.z();
}

/// With more points than these a lattice takes long, and the surface is a very small part of it.
double most_lattice_points(std::size_t faces) {
  return (std::max)(5e8, 16. * double(faces) * std::sqrt(double(faces)));
}

std::invalid_argument too_thin(std::size_t faces) {
  return std::invalid_argument("the parts of the shape are too thin for " + std::to_string(faces) +
                               " faces");
}

/// Looks for the spacing of the lattice that gives a number of faces, which grows about as
/// spacing^-2.
class Spacing_search
{
public:
  explicit Spacing_search(const Field& field,
                          double most_points = std::numeric_limits<double>::infinity())
      : field_(field)
      , most_points_(most_points)
      , spacing_(length(field.box().high - field.box().low) / 40.) {}

  /// throws `std::invalid_argument` if the solid is empty, or so thin that the lattice would have
  /// too many points.
  Lattice_mesh mesh_with_faces(std::size_t wanted) {
    too_fine_ = 0.;
    too_coarse_ = std::numeric_limits<double>::infinity();
    std::size_t expected = 0;
    while(true) {
      Soup soup = isosurface(field_, spacing_, expected);
      const double faces = static_cast<double>(soup.triangles.size());
      // Meshes of a few triangles jump from one number to another: be content with too many then.
      if(std::abs(faces - wanted) <= 0.05 * wanted || spacing_ == too_fine_)
        return {std::move(soup), spacing_};
      if(expected == 0 && faces == 0. && is_empty(field_))
        throw std::invalid_argument("the shape is empty");
      // From coarse to fine by small factors: coarse meshes are cheap, and each tells more.
      const double factor = std::clamp(wanted / (std::max)(faces, 1.), 1. / 16., 16.);
      expected = static_cast<std::size_t>(1.1 * factor * faces);
      change_spacing(faces < wanted, factor);
      if(!has_lattice())
        throw too_thin(wanted);
    }
  }

private:
  void change_spacing(bool is_too_coarse, double factor) {
    (is_too_coarse ? too_coarse_ : too_fine_) = spacing_;
    spacing_ /= std::sqrt(factor);
    if(too_coarse_ < 1.01 * too_fine_)
      spacing_ = too_fine_;
    else if(spacing_ <= too_fine_ || spacing_ >= too_coarse_)
      spacing_ = std::sqrt(too_fine_ * too_coarse_);
  }

  // The finest lattice that there may be is tried before it is given up.
  bool has_lattice() {
    if(lattice_points(field_.box(), spacing_) <= most_points_)
      return true;
    while(lattice_points(field_.box(), spacing_) > most_points_)
      spacing_ *= 1.05;
    return spacing_ < 0.95 * too_coarse_;
  }

  const Field& field_;
  double most_points_;
  double spacing_, too_fine_, too_coarse_;
};

/// moves each vertex along the normal of the mesh towards the surface of a solid: by the value of
/// the field, so never beyond the surface, and by no more than `limit`.
void approach_surface(Soup& soup, const Field& field, double limit) {
  const std::vector<Vector> normals = vertex_normals(soup);
  for(std::uint32_t v = 0; v < soup.points.size(); ++v) {
    look_at(soup, v);
    const double normal_length = length(normals[v]);
    if(normal_length == 0.)
      continue;
    const Vector p = point_of(soup, v);
    const Vector q = p - std::clamp(field(p), -limit, limit) / normal_length * normals[v];
    soup.points[v] = {q.x(), q.y(), q.z()};
  }
}

/// evens out the triangles and moves them onto the surface of the solid.
void fit_to_surface(Soup& soup, const Field& field, double spacing) {
  for(int round = 0; round < 2; ++round) {
    relax(soup, 2);
    approach_surface(soup, field, spacing / 2.);
  }
}

} // namespace

bool crosses_itself(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> vertices;
  for(const auto& [x, y, z] : soup.points)
    vertices.push_back(mesh.add_vertex({x, y, z}));
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(vertices[a], vertices[b], vertices[c]);
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

void relax(Soup& soup, int rounds) {
  std::vector<std::uint32_t> degree(soup.points.size(), 0);
  for(const auto& triangle : soup.triangles)
    for(const std::uint32_t v : triangle)
      ++degree[v];
  std::vector<std::array<double, 3>> sum(soup.points.size());
  for(int round = 0; round < rounds; ++round) {
    look_at(soup);
    sum.assign(sum.size(), {0., 0., 0.});
    // Each edge is seen once in each direction: from a to b here, from b to a across it.
    for(const auto& triangle : soup.triangles)
      for(int corner = 0; corner < 3; ++corner)
        for(int i = 0; i < 3; ++i)
          sum[triangle[corner]][i] += soup.points[triangle[(corner + 1) % 3]][i];
    for(std::size_t v = 0; v < sum.size(); ++v)
      if(degree[v] != 0)
        for(int i = 0; i < 3; ++i)
          soup.points[v][i] += 0.5 * (sum[v][i] / degree[v] - soup.points[v][i]);
  }
}

Soup mesh_of_field(const Field& field, const Request& request, const char* kind) {
  Spacing_search search(field);
  // A mesh whose spacing is close to the size of the details may miss one by bad luck: try finer
  // ones.
  for(const double excess : {1., 1.07, 1.15}) {
    Lattice_mesh mesh = search.mesh_with_faces(static_cast<std::size_t>(excess * request.faces));
    if(!is_connected_of_genus(mesh.soup, request.genus))
      continue;
    if(mesh.soup.triangles.size() < fine * (request.genus + 1))
      return fitted(mesh, field);
    fit_to_surface(mesh.soup, field, mesh.spacing);
    return std::move(mesh.soup);
  }
  throw std::invalid_argument(std::to_string(request.faces) +
                              " faces are too few for a mesh of the kind '" + kind + "' of genus " +
                              std::to_string(request.genus) + ": use more faces");
}

Lattice_mesh lattice_mesh(const Field& field, std::size_t faces, double most_spacing) {
  const double most_points = most_lattice_points(faces);
  if(lattice_points(field.box(), most_spacing) > most_points)
    throw too_thin(faces);
  return Spacing_search(field, most_points).mesh_with_faces(faces);
}

Soup fitted(const Lattice_mesh& mesh, const Field& field) {
  Soup fitted = mesh.soup;
  fit_to_surface(fitted, field, mesh.spacing);
  if(!crosses_itself(fitted))
    return fitted;
  // As much of this as does not make the mesh cross itself, as the one of the lattice never does.
  for(const double part : {0.5, 0.25}) {
    Soup between = mesh.soup;
    for(std::size_t v = 0; v < between.points.size(); ++v)
      for(int i = 0; i < 3; ++i)
        between.points[v][i] += part * (fitted.points[v][i] - between.points[v][i]);
    if(!crosses_itself(between))
      return between;
  }
  return mesh.soup;
}

Soup mesh_of_field(const Field& field, std::size_t faces) {
  return fitted(lattice_mesh(field, faces), field);
}

} // namespace CGAL::Handle_tunnel_loops::generators
