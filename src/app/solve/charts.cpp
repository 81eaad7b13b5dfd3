// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/charts.h"

#include "failure.h"

#ifdef CGAL_EIGEN3_ENABLED

#include "mesh_types.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/assertions.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace htloops {
namespace {

namespace Parameterization = CGAL::Surface_mesh_parameterization;
namespace generators = CGAL::Handle_tunnel_loops::generators;
using Disk = CGAL::Surface_mesh<Point>;
using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane_point = Plane::Point_2;
using Places = std::vector<Plane_point>; // by vertex of a disk

struct Component
{
  Disk disk;
  std::vector<std::uint32_t> vertices; // of the opened mesh, by vertex of the disk
  Disk::Halfedge_index border;
  double area = 0.;
};

std::array<Disk::Vertex_index, 3> corners_of(const Disk& disk, Disk::Face_index f) {
  const Disk::Halfedge_index h = disk.halfedge(f);
  return {disk.source(h), disk.target(h), disk.target(disk.next(h))};
}

double area_of(const Disk& disk, Disk::Face_index f) {
  const auto [u, v, w] = corners_of(disk, f);
  return std::sqrt(CGAL::squared_area(disk.point(u), disk.point(v), disk.point(w)));
}

std::vector<Component> components_of(const generators::Soup& opened) {
  boost::disjoint_sets_with_storage<> sets(opened.points.size());
  for(const auto& [u, v, w] : opened.triangles) {
    sets.union_set(u, v);
    sets.union_set(v, w);
  }
  std::vector<Component> components;
  std::map<std::size_t, std::size_t> component_of; // by set
  std::vector<Disk::Vertex_index> vertex_of(opened.points.size());
  for(const auto& triangle : opened.triangles) {
    const auto [found, is_new] =
        component_of.emplace(sets.find_set(triangle[0]), components.size());
    if(is_new)
      components.emplace_back();
    Component& component = components[found->second];
    for(const std::uint32_t v : triangle)
      if(vertex_of[v] == Disk::Vertex_index()) {
        const auto& [x, y, z] = opened.points[v];
        vertex_of[v] = component.disk.add_vertex(Point(x, y, z));
        component.vertices.push_back(v);
      }
    component.disk.add_face(vertex_of[triangle[0]], vertex_of[triangle[1]], vertex_of[triangle[2]]);
  }
  for(Component& component : components) {
    std::vector<Disk::Halfedge_index> borders;
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(component.disk,
                                                           std::back_inserter(borders));
    component.border = borders.front();
    for(const Disk::Face_index f : component.disk.faces())
      component.area += area_of(component.disk, f);
  }
  return components;
}

// Whether no triangle is turned over or flat, and the border does not meet itself: then no two
// triangles do.
bool is_chart(const Component& component, const Places& places) {
  const Disk& disk = component.disk;
  for(const Plane_point& p : places)
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()))
      return false;
  for(const Disk::Face_index f : disk.faces()) {
    const auto [u, v, w] = corners_of(disk, f);
    if(CGAL::orientation(places[u], places[v], places[w]) != CGAL::LEFT_TURN)
      return false;
  }
  std::vector<Plane_point> border;
  for(const Disk::Halfedge_index h : CGAL::halfedges_around_face(component.border, disk))
    border.push_back(places[disk.target(h)]);
  return CGAL::is_simple_2(border.begin(), border.end(), Plane());
}

// ---- distortion

/// How a triangle is stretched: the most, and the least, that anything in it becomes longer.
struct Stretch
{
  double most, least;
};

Stretch stretch_of(const Disk& disk, Disk::Face_index f, const Places& places) {
  const auto [u, v, w] = corners_of(disk, f);
  const Kernel::Vector_3 a = disk.point(v) - disk.point(u), b = disk.point(w) - disk.point(u);
  const Plane::Vector_2 p = places[v] - places[u], q = places[w] - places[u];
  const double length = std::sqrt(a * a), along = a * b / length;
  const double height = std::sqrt((std::max)(0., b * b - along * along));
  const Plane::Vector_2 x = p / length, y = (q - along * x) / height;
  const double sum = x * x + y * y, twice_area = 2. * (x.x() * y.y() - x.y() * y.x());
  const double s = std::sqrt((std::max)(0., sum + twice_area)),
               d = std::sqrt((std::max)(0., sum - twice_area));
  return {(s + d) / 2., (s - d) / 2.};
}

// The symmetric Dirichlet energy: 1 if nothing changes.
double energy_of(const Component& component, const Places& places) {
  double energy = 0.;
  for(const Disk::Face_index f : component.disk.faces()) {
    const auto [most, least] = stretch_of(component.disk, f, places);
    const double a = most * most, b = least * least;
    const double term = (a + b + 1. / a + 1. / b) / 4.;
    if(std::isfinite(term)) // flat in space
      energy += term * area_of(component.disk, f) / component.area;
  }
  return energy;
}

// ---- the chart of a component

// In the least box, along the axes, as large as on the surface.
Places normalized(const Component& component, const Places& places) {
  std::vector<Plane_point> hull, rectangle;
  CGAL::convex_hull_2(places.begin(), places.end(), std::back_inserter(hull));
  CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(rectangle));
  Plane::Vector_2 x = rectangle[1] - rectangle[0];
  x = x / std::sqrt(x * x);
  const Plane::Vector_2 y(-x.y(), x.x());
  double area = 0.;
  for(const Disk::Face_index f : component.disk.faces()) {
    const auto [u, v, w] = corners_of(component.disk, f);
    area += CGAL::area(places[u], places[v], places[w]);
  }
  const double scale = std::sqrt(component.area / area);
  Places result;
  for(const Plane_point& p : places) {
    const Plane::Vector_2 d = p - rectangle[0];
    result.emplace_back(scale * (d * x), scale * (d * y));
  }
  const CGAL::Bbox_2 box = CGAL::bbox_2(result.begin(), result.end());
  for(Plane_point& p : result)
    p = Plane_point(p.x() - box.xmin(), p.y() - box.ymin());
  return result;
}

// Whether a method says that it has found something. Those that cannot divide say so only in builds
// that check preconditions, and find nothing in others.
template <typename Parameterizer, typename Map>
bool has_parameterized(Component& component, Parameterizer& parameterizer, Map map) {
  try {
    return Parameterization::parameterize(component.disk, parameterizer, component.border, map) ==
           Parameterization::OK;
  } catch(const CGAL::Failure_exception&) {
    return false;
  }
}

// Appends what a method finds, if it is a chart.
template <typename Parameterizer>
void try_method(Component component, Parameterizer parameterizer, std::vector<Places>& charts) {
  using Uv = Kernel::Point_2;
  Disk& disk = component.disk;
  const auto map = disk.add_property_map<Disk::Vertex_index, Uv>("v:uv", Uv(0., 0.)).first;
  if(!has_parameterized(component, parameterizer, map))
    return;
  Places places;
  for(const Disk::Vertex_index v : disk.vertices())
    places.emplace_back(map[v].x(), map[v].y());
  if(!is_chart(component, places))
    return;
  places = normalized(component, places);
  if(is_chart(component, places))
    charts.push_back(std::move(places));
}

// The charts that there are of a component, the best ones first.
std::vector<Places> charts_of(const Component& component) {
  using Circle = Parameterization::Circular_border_arc_length_parameterizer_3<Disk>;
  std::vector<Places> charts;
  try_method(component, Parameterization::ARAP_parameterizer_3<Disk>(), charts);
  std::vector<Places> others;
  if(charts.empty()) {
    try_method(component, Parameterization::LSCM_parameterizer_3<Disk>(), others);
    try_method(component, Parameterization::Mean_value_coordinates_parameterizer_3<Disk, Circle>(),
               others);
    try_method(component, Parameterization::Discrete_authalic_parameterizer_3<Disk, Circle>(),
               others);
    try_method(component, Parameterization::Barycentric_mapping_parameterizer_3<Disk, Circle>(),
               others);
  }
  std::vector<std::pair<double, std::size_t>> order;
  for(std::size_t i = 0; i < others.size(); ++i)
    order.emplace_back(energy_of(component, others[i]), i);
  std::sort(order.begin(), order.end());
  for(const auto& [energy, i] : order)
    charts.push_back(std::move(others[i]));
  return charts;
}

// ---- the square

/// Where charts go: moved, and then all made smaller.
struct Packing
{
  std::vector<Plane::Vector_2> offsets;
  double scale = 1.;
};

// On shelves, the highest ones first.
Packing pack(const std::vector<Places>& charts) {
  std::vector<CGAL::Bbox_2> boxes;
  double area = 0., widest = 0.;
  for(const Places& places : charts) {
    boxes.push_back(CGAL::bbox_2(places.begin(), places.end()));
    area += boxes.back().xmax() * boxes.back().ymax();
    widest = (std::max)(widest, boxes.back().xmax());
  }
  std::vector<std::size_t> order(charts.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return boxes[i].ymax() > boxes[j].ymax(); });
  const double width = (std::max)(widest, std::sqrt(1.1 * area)), margin = width / 256.;
  Packing packing = {std::vector<Plane::Vector_2>(charts.size()), 1.};
  double x = margin, y = margin, height = 0., side = 0.;
  for(const std::size_t i : order) {
    if(x > margin && x + boxes[i].xmax() > width + margin) {
      x = margin;
      y += height + margin;
      height = 0.;
    }
    packing.offsets[i] = {x, y};
    x += boxes[i].xmax() + margin;
    height = (std::max)(height, boxes[i].ymax());
    side = (std::max)({side, x, y + height + margin});
  }
  packing.scale = 1. / side;
  return packing;
}

Places packed(const Places& places, const Packing& packing, std::size_t chart) {
  const Plane::Vector_2& offset = packing.offsets[chart];
  Places result;
  for(const Plane_point& p : places)
    result.emplace_back((p.x() + offset.x()) * packing.scale, (p.y() + offset.y()) * packing.scale);
  return result;
}

Places in_single_precision(const Places& places) {
  Places result;
  for(const Plane_point& p : places)
    result.emplace_back(double(static_cast<float>(p.x())), double(static_cast<float>(p.y())));
  return result;
}

void measure(const std::vector<Component>& components,
             const std::vector<Places>& charts,
             Charts& result) {
  std::vector<std::pair<double, double>> areas; // how it changes, and how much of it
  double whole = 0., angles = 0.;
  for(std::size_t i = 0; i < components.size(); ++i)
    for(const Disk::Face_index f : components[i].disk.faces()) {
      const auto [most, least] = stretch_of(components[i].disk, f, charts[i]);
      const double area = area_of(components[i].disk, f);
      if(!(area > 0.) || !std::isfinite(most / least))
        continue;
      areas.emplace_back(most * least, area);
      angles += area * most / least;
      whole += area;
    }
  if(areas.empty())
    return;
  result.angle_distortion = angles / whole;
  std::sort(areas.begin(), areas.end());
  double sum = 0.;
  result.least_area = areas.front().first;
  for(const auto& [change, area] : areas) {
    result.least_area = sum < 0.05 * whole ? change : result.least_area;
    result.largest_area = sum < 0.95 * whole ? change : result.largest_area;
    sum += area;
  }
}

} // namespace

bool can_make_charts() { return true; }

Charts make_charts(const generators::Soup& opened) {
  const std::vector<Component> components = components_of(opened);
  std::vector<Places> charts;
  for(const Component& component : components) {
    if(!(component.area > 0.)) // CGAL's methods may not end well
      throw Failure(Exit_code::NOT_CERTIFIED,
                    "the component of vertex " + std::to_string(component.vertices.front()) +
                        " has no area, so it has no chart; 'htloops clean' drops such parts");
    std::vector<Places> candidates = charts_of(component);
    if(candidates.empty())
      throw Failure(Exit_code::NOT_CERTIFIED,
                    "no chart without flipped triangles was found for the component of vertex " +
                        std::to_string(component.vertices.front()) +
                        ": cut it along more edges, with --through");
    charts.push_back(std::move(candidates.front()));
  }
  const Packing packing = pack(charts);
  Charts result;
  result.number = charts.size();
  result.places.resize(opened.points.size());
  for(std::size_t i = 0; i < charts.size(); ++i) {
    const Places fine = packed(charts[i], packing, i);
    Places places = in_single_precision(fine);
    if(!is_chart(components[i], places)) {
      ++result.number_of_fine_ones;
      places = fine;
      if(!is_chart(components[i], places))
        throw Failure(Exit_code::NOT_CERTIFIED,
                      "a chart has triangles that are too small for double precision");
    }
    for(std::size_t v = 0; v < places.size(); ++v)
      result.places[components[i].vertices[v]] = {places[v].x(), places[v].y()};
  }
  measure(components, charts, result);
  return result;
}

} // namespace htloops

#else

namespace htloops {

bool can_make_charts() { return false; }

Charts make_charts(const CGAL::Handle_tunnel_loops::generators::Soup&) {
  throw wrong_usage("charts need a build with Eigen");
}

} // namespace htloops

#endif
