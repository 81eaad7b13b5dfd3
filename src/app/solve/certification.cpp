// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/certification.h"

#include "solve/boundaries.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>
#include <CGAL/certify_curve_skeleton.h>

namespace htloops {
namespace {

class Watch_by_function final : public internal::Watch
{
public:
  explicit Watch_by_function(const std::function<void()>& look)
      : look_(look) {}

  void look() override { look_(); }

private:
  const std::function<void()>& look_;
};

using Prepared_mesh =
    internal::Prepared_surface<Mesh, boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>;

using Reader =
    internal::Triangle_reader<Mesh, boost::property_map<Mesh, boost::face_index_t>::const_type>;

internal::Triangle_list triangles_of(const Mesh& mesh, const Reader& reader) {
  return reader.read(internal::execution_of<All_threads_tag>(), get(boost::vertex_index, mesh),
                     get(CGAL::vertex_point, mesh));
}

// With the caps that close its boundary curves.
bool touches_itself_with_caps(internal::Execution execution, const Prepared_mesh& surface) {
  if(surface.mesh.number_of_hubs == 0)
    return internal::touches_itself(execution, surface.tm, surface.point,
                                    get(boost::vertex_index, surface.tm));
  return internal::touches_itself(execution, surface.mesh,
                                  internal::places_of_vertices(execution, surface));
}

internal::Flat_skeleton as_arrays(const Skeleton_lines& skeleton) {
  internal::Flat_skeleton arrays;
  for(const Point& p : skeleton.points)
    arrays.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& [p, q] : skeleton.edges)
    arrays.edges.push_back({static_cast<internal::Index>(p), static_cast<internal::Index>(q)});
  for(const std::size_t component : skeleton.components)
    arrays.component_of.push_back(internal::component_number(component));
  arrays.is_inlet = skeleton.is_inlet;
  return arrays;
}

} // namespace

Certificate certify(const Mesh& mesh, const Pairs& pairs, Basis_kind basis_kind, bool with_sides) {
  CGAL::Handle_tunnel_loops::Solver_options options;
  options.do_compute_linking = with_sides;
  return CGAL::certify_handle_tunnel_loops<All_threads_tag>(
      mesh, pairs,
      CGAL::parameters::basis_kind(basis_kind, CGAL::parameters::solver_options(options)));
}

std::vector<std::string> problems_of_boundaries(const Mesh& mesh,
                                                const std::vector<Loop>& curves,
                                                const std::vector<Loop>& waists) {
  const Reader reader(mesh, get(boost::face_index, mesh));
  std::vector<internal::Listed_loop> listed_curves;
  for(const Loop& curve : curves)
    listed_curves.push_back(reader.listed(curve));
  std::vector<internal::Listed_waist> listed_waists;
  for(const Loop& waist : waists)
    listed_waists.push_back({reader.listed(waist), waist.pair_index()});
  return internal::problems_of_boundaries(internal::execution_of<All_threads_tag>(),
                                          triangles_of(mesh, reader), listed_curves, listed_waists);
}

std::vector<char> are_closed_on_surface(const Mesh& mesh, const std::vector<Loop>& loops) {
  const Reader reader(mesh, get(boost::face_index, mesh));
  std::vector<internal::Listed_loop> listed;
  for(const Loop& loop : loops)
    listed.push_back(reader.listed(loop));
  const std::vector<std::string> reasons = internal::reasons_not_closed(
      internal::execution_of<All_threads_tag>(), triangles_of(mesh, reader), listed);
  std::vector<char> are_closed;
  for(const std::string& reason : reasons)
    are_closed.push_back(reason.empty());
  return are_closed;
}

bool touches_itself(const Mesh& mesh, const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<All_threads_tag>();
  return internal::touches_itself(execution.watched_by(watch), mesh, get(CGAL::vertex_point, mesh),
                                  get(boost::vertex_index, mesh));
}

CGAL::Handle_tunnel_loops::Skeleton_certificate
certify_skeleton(const Mesh& mesh,
                 const Skeleton_lines& skeleton,
                 const Pairs& pairs,
                 const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<All_threads_tag>().watched_by(watch);
  const auto vertex_index = get(boost::vertex_index, mesh);
  Prepared_mesh surface(execution, mesh, vertex_index, get(CGAL::vertex_point, mesh));
  const std::vector<internal::Vector> places = internal::places_of_vertices(execution, surface);
  const std::string taken_alone =
      internal::join_components_of_solids(execution, surface.mesh, places);
  internal::Flat_skeleton arrays = as_arrays(skeleton);
  internal::find_places(execution, surface.mesh, places, arrays);
  auto certificate = internal::certify_skeleton(
      execution, surface, places, vertex_index, get(boost::face_index, mesh), arrays, pairs,
      [&](internal::Index p) { return skeleton.names[p]; });
  certificate.taken_alone = taken_alone;
  if(touches_itself_with_caps(execution, surface))
    internal::note_self_contact(certificate, surface.mesh.number_of_hubs > 0);
  return certificate;
}

bool note_self_contact(const Mesh& mesh,
                       CGAL::Handle_tunnel_loops::Skeleton_certificate& certificate,
                       const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<All_threads_tag>().watched_by(watch);
  const Prepared_mesh surface(execution, mesh, get(boost::vertex_index, mesh),
                              get(CGAL::vertex_point, mesh));
  const bool touches_itself = touches_itself_with_caps(execution, surface);
  if(touches_itself)
    internal::note_self_contact(certificate, surface.mesh.number_of_hubs > 0);
  return touches_itself;
}

} // namespace htloops
