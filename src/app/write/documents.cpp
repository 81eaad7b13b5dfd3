// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/documents.h"

#include "file_names.h"
#include "version.h"
#include "write/Json_writer.h"
#include "write/pair_listing.h"
#include "write/tables.h"
#include "write/throat_tables.h"

#include <CGAL/Handle_tunnel_loops/Loop_shape.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Stage;

Json json_of_point(const Point& point) {
  return std::array<double, 3>{point.x(), point.y(), point.z()};
}

Json json_of_vector(const Kernel::Vector_3& vector) {
  return std::array<double, 3>{vector.x(), vector.y(), vector.z()};
}

// An array of what `json_of(element)` makes of the elements of a range.
template <typename Range, typename Json_of> Json array_of(const Range& range, Json_of json_of) {
  Json array = Json::array();
  for(const auto& element : range)
    array.push_back(json_of(element));
  return array;
}

Json timings(const Answer& answer, double read_seconds) {
  Json json = {{"read", read_seconds}};
  for(std::size_t i = 0; i < CGAL::Handle_tunnel_loops::number_of_stages; ++i) {
    const auto stage = static_cast<Stage>(i);
    if(stage == Stage::DIFFUSION)
      continue; // no loop comes of it
    json[CGAL::Handle_tunnel_loops::stage_name(stage)] = answer.statistics.seconds_of(stage);
  }
  json["total"] = answer.total_seconds;
  return json;
}

Json json_of(const std::optional<std::size_t>& count) { return count ? Json(*count) : Json(); }

Json json_of(const Certificate& certificate) {
  return {{"closed_on_surface", certificate.closed_on_surface},
          {"basis", certificate.basis},
          {"pairing", certificate.pairing},
          {"types", certificate.types},
          {"handles_bound_inside", json_of(certificate.handles_bound_inside)},
          {"tunnels_bound_outside", json_of(certificate.tunnels_bound_outside)},
          {"handles_bound_inside_alone", json_of(certificate.handles_bound_inside_alone)},
          {"tunnels_bound_outside_alone", json_of(certificate.tunnels_bound_outside_alone)}};
}

// Row, column and value, where loop 2k is handle k and loop 2k + 1 is tunnel k.
Json json_of(const std::vector<Loop_linking>& linking) {
  Json array = Json::array();
  for(std::size_t i = 0; i < linking.size(); ++i)
    for(const auto& [j, value] : linking[i].row)
      array.push_back(Json::array({i, j, value}));
  return array;
}

// What loops lie on.
struct Ground
{
  const Mesh& mesh;
  const Face_cuts& cuts;
  std::vector<std::size_t> components; // of vertices
};

// The positions of the locations on edges that are in no face of the file.
Json positions_across_faces(const Loop& loop, const Ground& on) {
  Json positions = Json::array();
  for(std::size_t i = 0; i < loop.steps().size(); ++i)
    if(on.cuts[on.mesh.edge(loop.steps()[i].halfedge).idx()])
      positions.push_back(i);
  return positions;
}

Json json_of_line(const Loop& loop, const Ground& on, Json json) {
  json["locations"] = array_of(loop.steps(), [&mesh = on.mesh](const Loop::Step& step) {
    return Json::array(
        {mesh.source(step.halfedge).idx(), mesh.target(step.halfedge).idx(), step.ratio});
  });
  if(!on.cuts.empty())
    json["across_faces"] = positions_across_faces(loop, on);
  json["points"] = array_of(loop.points(), json_of_point);
  return json;
}

Json json_of(const Ball& ball) {
  return {{"diameter", ball.diameter},
          {"error", ball.error},
          {"throat", json_of_point(ball.throat)},
          {"curve", array_of(ball.curve, json_of_point)}};
}

void add_measure(Json& pair, const Measure& measure) {
  if(measure.thickness)
    pair["thickness"] = json_of(*measure.thickness);
  if(measure.clear_width)
    pair["clear_width"] = json_of(*measure.clear_width);
  if(!measure.why.empty())
    pair["not_measured_because"] = measure.why;
}

Json json_of_way(const Removed_handle& way) { return {{"area", way.area}, {"volume", way.volume}}; }

} // namespace

void add_costs(Json& pair, const Costs::value_type& costs) {
  if(costs.cut)
    pair["cut"] = json_of_way(*costs.cut);
  else
    pair["no_cut_because"] = costs.why_no_cut;
  if(costs.fill)
    pair["fill"] = json_of_way(*costs.fill);
  else
    pair["no_fill_because"] = costs.why_no_fill;
}

namespace {

// How flat and how round it is.
Json json_of_shape(const Loop& loop) {
  const auto shape = CGAL::loop_shape(loop.points());
  Json json = {{"diameter", shape.diameter},
               {"centre", json_of_point(shape.center)},
               {"normal", json_of_vector(shape.normal)},
               {"deviation", shape.deviation}};
  if(shape.circle)
    json["circle"] = {{"diameter", shape.circle->diameter},
                      {"centre", json_of_point(shape.circle->center)},
                      {"deviation", shape.circle->deviation}};
  return json;
}

// Its length and the component of the surface that it is on, its shape, what else is told of it,
// and where it runs.
Json json_of(const Loop& loop, const Ground& on, const Json& more) {
  const Mesh::Vertex_index v = on.mesh.source(loop.steps().front().halfedge);
  Json json = {{"length", loop.length()},
               {"component", on.components[v.idx()]},
               {"shape", json_of_shape(loop)}};
  json.update(more);
  return json_of_line(loop, on, std::move(json));
}

Json json_of(const Loop_linking& linking) {
  Json json = {{"bounds", word_for_side(linking)}, {"bounds_alone", word_for_side_alone(linking)}};
  if(!linking.problem.empty())
    json["undecided_because"] = linking.problem;
  return json;
}

// Of a boundary curve, if it has one, and that was looked for.
Json json_of_waist(const Loop& curve, const Boundaries& boundaries, const Ground& on) {
  const Loop* waist = boundaries.waist(curve.pair_index());
  if(!waist)
    return Json::object();
  return {{"waist", json_of_line(*waist, on, {{"length", waist->length()}})}};
}

// How small a pair is, where it lies, and how wide its hole is.
Json json_of_place(const Listed_pair& pair) {
  const CGAL::Bbox_3& box = pair.box;
  Json json = {{"size", pair.size},
               {"centre", json_of_point(pair.centre)},
               {"box", Json::array({Json::array({box.xmin(), box.ymin(), box.zmin()}),
                                    Json::array({box.xmax(), box.ymax(), box.zmax()})})},
               {"diameter", pair.hole.diameter},
               {"diameter_of", pair.hole.word()},
               {"wall_diameter", pair.hole.wall_diameter}};
  if(const std::optional<Bore>& bore = pair.hole.bore)
    json["bore"] = {{"diameter", bore->diameter},         {"centre", json_of_point(bore->center)},
                    {"axis", json_of_vector(bore->axis)}, {"depth", bore->length},
                    {"deviation", bore->deviation},       {"drilling", bore->drilling}};
  else
    json["out_of_roundness"] = pair.hole.out_of_roundness;
  return json;
}

using Graph = CGAL::Reeb_graph<Mesh>;

Json timings(const Reeb_answer& answer, double read_seconds) {
  const auto& statistics = answer.statistics;
  return {{"read", read_seconds},
          {"adaptor", statistics.seconds_of_adaptor},
          {"function", statistics.seconds_of_function},
          {"sweep", statistics.seconds_of_sweep},
          {"finishing", statistics.seconds_of_finishing},
          {"drawing", answer.embedding ? answer.embedding->seconds : 0.},
          {"total", answer.total_seconds}};
}

// What is known of the lines.
Json json_of(const CGAL::Handle_tunnel_loops::Reeb_embedding& embedding) {
  return {{"inside", embedding.inside},
          {"embedded", embedding.embedded},
          {"segments", embedding.number_of_segments},
          {"segments_inside", embedding.number_of_segments_inside}};
}

Json json_of_node(const Graph& graph, Graph::vertex_descriptor v) {
  const auto& node = graph[v];
  Json json = {{"id", v},
               {"type", name_of(node.type)},
               {"vertex", node.vertex.idx()},
               {"value", node.value},
               {"position", json_of_point(node.point)}};
  if(node.radius > 0.)
    json["radius"] = node.radius;
  return json;
}

Json json_of_arc(const Graph& graph, Graph::edge_descriptor e, const std::vector<double>& girths) {
  const auto& arc = graph[e];
  Json json = {{"id", arc.index},
               {"source", source(e, graph)},
               {"target", target(e, graph)},
               {"vertex_count", arc.vertices.size()},
               {"length", arc.length},
               {"girth", girths[arc.index]},
               {"polyline", array_of(arc.polyline, json_of_point)}};
  if(!arc.radii.empty()) {
    json["radii"] = arc.radii;
    json["outside"] = Json::array();
    for(std::size_t i = 0; i < arc.is_inside.size(); ++i)
      if(!arc.is_inside[i])
        json["outside"].push_back(i);
  }
  return json;
}

// Vertices without faces are on no arc: null.
Json json_of_arc_of_vertex(std::size_t arc) {
  return arc == Reeb_answer::no_arc ? Json() : Json(arc);
}

Json json_of(const Shape_change& change) {
  return {{"volume_removed", change.volume_removed},
          {"volume_added", change.volume_added},
          {"cap_area", change.cap_area},
          {"cap_ratio", change.cap_ratio},
          {"displacement", change.displacement},
          {"burial", change.burial},
          {"sharpest_angle", change.sharpest_angle},
          {"box_growth", change.box_growth},
          {"crossings", change.crossings}};
}

Json json_of(const Removed_handle& handle) {
  return {{"pair", handle.pair}, {"by", name_of(handle)},   {"length", handle.length},
          {"area", handle.area}, {"volume", handle.volume}, {"change", json_of(handle.change)}};
}

Json json_of(const Refused_handle& handle) {
  return {{"pair", handle.pair}, {"length", handle.length}, {"reason", handle.reason}};
}

// Necks are of no pair.
template <typename Necks> Json json_of_necks(const Necks& necks) {
  return array_of(necks, [](const auto& neck) {
    Json json = json_of(neck);
    json.erase("pair");
    return json;
  });
}

Json json_of(const Dual_cut& cut, const Mesh& mesh) {
  Json json = {{"loop", name_of(cut.loop.type())}};
  json[cut.loop.type() == Loop_type::BOUNDARY ? "boundary" : "pair"] = cut.loop.pair_index();
  json["edges"] = array_of(cut.edges, [&mesh](const auto& edge) {
    return Json::array({mesh.source(edge.first).idx(), mesh.target(edge.first).idx(), edge.second});
  });
  return json;
}

using CGAL::Handle_tunnel_loops::Field_resolution;
using CGAL::Handle_tunnel_loops::Front_event;

Json json_of(const Field_resolution& resolution) {
  return {{"is_resolved", resolution.is_resolved()},
          {"handles_within_steps", resolution.handles_within_steps},
          {"rests", resolution.rests},
          {"early_vertices", resolution.early_vertices},
          {"events_in_seed_region", resolution.events_in_seed_region}};
}

Json json_of_front(const Front_event::Front& front) {
  return {{"layer", front.layer}, {"length", front.length}};
}

Json json_of(const Front_event& event) {
  return {{"type", CGAL::Handle_tunnel_loops::front_event_name(event.type)},
          {"step", event.step},
          {"vertex", event.vertex},
          {"before", array_of(event.before, json_of_front)},
          {"after", array_of(event.after, json_of_front)}};
}

/// what documents say of the mesh that they are about.
template <typename Statistics>
Json json_of_mesh(std::size_t vertices, std::size_t faces, const Statistics& statistics) {
  return {{"vertices", vertices},
          {"faces", faces},
          {"components", statistics.number_of_components},
          {"boundaries", statistics.number_of_boundaries},
          {"genus", statistics.genus}};
}

template <typename Statistics> Json json_of_mesh(const Mesh& mesh, const Statistics& statistics) {
  return json_of_mesh(mesh.number_of_vertices(), mesh.number_of_faces(), statistics);
}

// The segments of arcs that are edges not known to be inside: arc and place in it.
Json json_of_edges_outside(const Skeleton_answer& answer) {
  std::set<std::pair<std::size_t, std::size_t>> outside;
  for(const auto& [edge, face] : answer.certificate().edges_outside)
    outside.insert(std::minmax(edge.first, edge.second));
  Json segments = Json::array();
  for(std::size_t arc = 0; arc < answer.arcs.size(); ++arc) {
    const std::vector<std::size_t>& points = answer.arcs[arc].points;
    for(std::size_t i = 1; i < points.size(); ++i)
      if(outside.count(std::minmax(points[i - 1], points[i])) != 0)
        segments.push_back({arc, i - 1});
  }
  return segments;
}

Json json_of_certificate(const Skeleton_answer& answer) {
  const Skeleton_certificate& certificate = answer.certificate();
  return {{"connected", certificate.connected},
          {"inside", certificate.inside},
          {"embedded", certificate.embedded},
          {"cycles", certificate.basis},
          {"failure", certificate.failure},
          {"taken_alone", certificate.taken_alone},
          {"edges_outside", json_of_edges_outside(answer)}};
}

// The points of a skeleton as a document numbers them: the nodes, and then those within arcs, in
// their order.
class Points_in_document
{
public:
  explicit Points_in_document(const Skeleton_answer& answer)
      : numbers_(num_vertices(answer.graph), Skeleton_answer::none) {
    constexpr std::size_t within = Skeleton_answer::none - 1;
    for_each_within_arcs(answer, [&](std::size_t p) { numbers_[p] = within; });
    for(std::size_t p = 0; p < numbers_.size(); ++p)
      if(numbers_[p] != within) {
        numbers_[p] = nodes_.size();
        nodes_.push_back(p);
      }
    std::size_t next = nodes_.size();
    for_each_within_arcs(answer, [&](std::size_t p) { numbers_[p] = next++; });
  }

  const std::vector<std::size_t>& nodes() const { return nodes_; }
  std::size_t number(std::size_t point) const { return numbers_[point]; }

private:
  template <typename Visit>
  static void for_each_within_arcs(const Skeleton_answer& answer, Visit visit) {
    for(const Skeleton_arc& arc : answer.arcs)
      std::for_each(std::next(arc.points.begin()), std::prev(arc.points.end()), visit);
  }

  std::vector<std::size_t> numbers_, nodes_;
};

Json json_of_node(const Skeleton_graph& graph, std::size_t point, std::size_t id) {
  return {{"id", id},
          {"position", json_of_point(graph[point].point)},
          {"radius", graph[point].radius},
          {"kind", name_of_point(graph, point)},
          {"component", graph[point].component}};
}

Json json_of_arc(const Skeleton_answer& answer,
                 std::size_t number,
                 const Points_in_document& points) {
  const Skeleton_graph& graph = answer.graph;
  const Skeleton_arc& arc = answer.arcs[number];
  const double chord = chord_of(graph, arc);
  return {{"arc", number},
          {"component", arc.component},
          {"length", arc.length},
          {"smallest_radius", arc.smallest_radius},
          {"mean_radius", arc.mean_radius},
          {"tortuosity", chord > 0. ? Json(arc.length / chord) : Json()},
          {"on_cycle", arc.is_on_cycle},
          {"source", points.number(arc.points.front())},
          {"target", points.number(arc.points.back())},
          {"polyline", array_of(arc.points, [&](auto p) { return json_of_point(graph[p].point); })},
          {"radii", array_of(arc.points, [&](auto p) { return graph[p].radius; })}};
}

// A document as a value, member by member as a `Json_writer` has it.
struct Json_value
{
  Json value = Json::object();

  void member(const char* name, Json member) { value[name] = std::move(member); }

  template <typename Range, typename Json_of>
  void array(const char* name, const Range& range, Json_of json_of) {
    value[name] = array_of(range, json_of);
  }
};

template <typename Document>
void tell_loops(Document& out, const Mesh& mesh, const Answer& answer, const Run_record& run) {
  const auto& linking = answer.certificate.linking;
  const Ground on = {mesh, run.cuts,
                     components_of_vertices(mesh, answer.statistics.number_of_components)};
  out.member("format", "htloops/1");
  out.member("tool", version());
  Json mesh_json = json_of_mesh(mesh, answer.statistics);
  mesh_json["file"] = as_utf8(run.mesh_file);
  if(answer.unit != Unit::NONE)
    mesh_json["unit"] = words_of(answer.unit).name;
  out.member("mesh", mesh_json);
  out.member("options", run.options);
  out.member("backend", answer.backend);
  out.member("threads", answer.number_of_threads);
  out.member("basis", CGAL::Handle_tunnel_loops::name_of(answer.certificate.basis_kind));
  out.member("timings", timings(answer, run.read_seconds));
  out.member("certificate", json_of(answer.certificate));
  out.member("ended_by_time", answer.statistics.was_ended_by_time);
  if(!linking.empty())
    out.member("linking", json_of(linking));
  if(!answer.statistics.fallback.empty())
    out.member("fallback", answer.statistics.fallback);
  const CGAL::Bbox_3 box = box_of(mesh);
  std::size_t index = 0; // of the next loop
  out.array("pairs", answer.pairs, [&](const Pair& pair) {
    Json json = json_of_place(listed_pair(answer, index / 2, box));
    if(index / 2 < answer.measures.size())
      add_measure(json, answer.measures[index / 2]);
    if(index / 2 < answer.costs.size())
      add_costs(json, answer.costs[index / 2]);
    for(const Loop_type type : loop_types) {
      json[name_of(type)] =
          json_of(pair.loop(type), on, linking.empty() ? Json::object() : json_of(linking[index]));
      ++index;
    }
    return json;
  });
  out.array("boundaries", answer.boundaries.curves, [&](const Loop& curve) {
    return json_of(curve, on, json_of_waist(curve, answer.boundaries, on));
  });
  if(answer.throats.are_wanted)
    out.array("throats", answer.throats.all, [&](const Throat& throat) {
      return json_of(throat.loop, on, json_of(answer.throats, throat));
    });
}

template <typename Document>
void tell_skeleton(Document& out, const Skeleton_answer& answer, const Run_record& run) {
  const Points_in_document points(answer);
  out.member("format", "htloops-skeleton/1");
  out.member("tool", version());
  Json mesh = json_of_mesh(answer.vertex_point.size(), answer.statistics.number_of_faces,
                           answer.statistics);
  mesh["file"] = as_utf8(run.mesh_file);
  out.member("mesh", mesh);
  out.member("options", run.options);
  out.member("threads", answer.number_of_threads);
  out.member("timings", {{"read", run.read_seconds},
                         {"loops", answer.statistics.seconds_of_loops},
                         {"skeleton", answer.statistics.seconds_of_skeleton},
                         {"total", answer.total_seconds}});
  out.member("balls", answer.statistics.number_of_balls);
  out.member("cycles", number_of_cycles(answer.graph));
  out.member("certificate", json_of_certificate(answer));
  std::size_t id = 0;
  out.array("nodes", points.nodes(),
            [&](std::size_t point) { return json_of_node(answer.graph, point, id++); });
  std::size_t arc = 0;
  out.array("arcs", answer.arcs,
            [&](const Skeleton_arc&) { return json_of_arc(answer, arc++, points); });
  // Vertices without faces belong to no point: null.
  out.member("vertex_point", array_of(answer.vertex_point, [&](std::size_t point) {
               return point == Skeleton_answer::none ? Json() : Json(points.number(point));
             }));
}

} // namespace

std::string text_of(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void write_loops_json(const std::string& target,
                      const Mesh& mesh,
                      const Answer& answer,
                      const Run_record& run) {
  Json_writer out(target);
  tell_loops(out, mesh, answer, run);
  out.finish();
}

Json loops_document(const Mesh& mesh, const Answer& answer, const Run_record& run) {
  Json_value document;
  tell_loops(document, mesh, answer, run);
  return std::move(document.value);
}

void write_reeb_json(const std::string& target,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     double read_seconds) {
  const Graph& graph = answer.graph;
  const std::vector<double> girths = girths_of(mesh, answer);
  Json_writer out(target);
  out.member("format", "htloops-reeb/1");
  out.member("mesh", json_of_mesh(mesh, answer.statistics));
  out.member("function", answer.function);
  out.member("capped", answer.is_capped);
  out.member("backend", answer.backend);
  out.member("threads", answer.number_of_threads);
  out.member("timings", timings(answer, read_seconds));
  out.member("cycles", number_of_cycles(answer));
  if(answer.embedding)
    out.member("drawing", json_of(*answer.embedding));
  out.array("nodes", CGAL::make_range(vertices(graph)),
            [&graph](auto v) { return json_of_node(graph, v); });
  out.array("arcs", CGAL::make_range(edges(graph)),
            [&](auto e) { return json_of_arc(graph, e, girths); });
  out.member("vertex_arc", array_of(answer.vertex_arc, json_of_arc_of_vertex));
  out.finish();
}

void write_skeleton_json(const std::string& file,
                         const Skeleton_answer& answer,
                         const Run_record& run) {
  Json_writer out(file);
  tell_skeleton(out, answer, run);
  out.finish();
}

Json skeleton_document(const Skeleton_answer& answer, const Run_record& run) {
  Json_value document;
  tell_skeleton(document, answer, run);
  return std::move(document.value);
}

void write_removal_json(const std::string& file, const Removal_report& report) {
  const auto json = [](const auto& handle) { return json_of(handle); };
  Json_writer document(file);
  document.member("format", "htloops-remove/1");
  document.member("genus_before", report.genus_before);
  document.member("genus_after", report.genus_after);
  document.member("components_before", report.components_before);
  document.member("components_after", report.components_after);
  document.member("change", json_of(report.change()));
  document.array("removed", report.removed, json);
  document.array("refused", report.refused, json);
  document.member("necks", {{"removed", json_of_necks(report.removed_necks)},
                            {"refused", json_of_necks(report.refused_necks)}});
  document.finish();
}

void write_map_json(const std::string& target,
                    std::size_t number_of_vertices_before,
                    std::size_t number_of_faces_before,
                    const Changed_mesh& changed) {
  const auto json_of_origin = [](std::int64_t origin) {
    return origin == nothing_before ? Json() : Json(origin);
  };
  Json_writer out(target);
  out.member("format", "htloops-map/1");
  out.member("vertices_before", number_of_vertices_before);
  out.member("faces_before", number_of_faces_before);
  out.array("vertices", changed.vertex_origins, json_of_origin);
  out.array("faces", changed.face_origins, json_of_origin);
  out.array("face_parents", changed.face_parents, json_of_origin);
  out.finish();
}

void write_dual_cuts_json(const std::string& target, const Mesh& mesh, const Dual_cuts& cuts) {
  Json_writer out(target);
  out.member("format", "htloops-dual/1");
  out.member("mesh", json_of_mesh(mesh, cuts.statistics));
  out.array("cuts", cuts.cuts, [&](const Dual_cut& cut) { return json_of(cut, mesh); });
  out.finish();
}

void write_events(const std::string& target, const Answer& answer) {
  Json_writer out(target);
  out.member("format", "htloops-events/1");
  if(answer.backend == "reference")
    out.member("resolution", json_of(answer.statistics.resolution));
  out.array("events", answer.statistics.front_events,
            [](const Front_event& event) { return json_of(event); });
  out.finish();
}

} // namespace htloops
