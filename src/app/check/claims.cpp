// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "check/claims.h"

#include "interrupt.h"
#include "read/loops_reader.h"
#include "solve/backends.h"
#include "solve/boundaries.h"
#include "solve/certification.h"
#include "solve/channels.h"
#include "solve/details.h"
#include "solve/skeleton_solver.h"
#include "solve/throat_solver.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace htloops {
namespace {

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  for(const std::string& line : more)
    if(std::find(lines.begin(), lines.end(), line) == lines.end())
      lines.push_back(line);
}

bool is_document(const Input_file& file) {
  const std::size_t first = file.content().find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && file.content()[first] == '{';
}

Json document_in(const Input_file& file) {
  return Json::parse(file.content()); // it has been read as one
}

double largest_coordinate(const Mesh& mesh) {
  double largest = 0.;
  for(const Point& p : mesh.points())
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return largest;
}

// Of what has faces.
template <typename Statistics> void count_surface(const Mesh& mesh, Statistics& counts) {
  const std::size_t all = mesh.number_of_vertices();
  const std::vector<std::size_t> component = components_of_vertices(mesh, all);
  std::size_t number_of_vertices = 0;
  counts.number_of_components = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v)) {
      ++number_of_vertices;
      counts.number_of_components = (std::max)(counts.number_of_components, component[v.idx()] + 1);
    }
  counts.number_of_boundaries = find_boundaries(mesh, false).curves.size();
  // V - E + F = 2 C - 2 G - B
  counts.genus = (2 * counts.number_of_components + mesh.number_of_edges() -
                  counts.number_of_boundaries - number_of_vertices - mesh.number_of_faces()) /
                 2;
}

// ---- loops

// The names of handles and tunnels are wrong, and nothing else.
bool has_wrong_types_only(const Certificate& c) {
  return c.closed_on_surface && c.basis && c.pairing && !c.types;
}

bool is_basis(const Certificate& c) { return bool(c) || has_wrong_types_only(c); }

/// What linking numbers a document has, and which are so.
class Linking_comparison
{
public:
  explicit Linking_comparison(const std::vector<Loop_linking>& linking)
      : linking_(linking) {}

  /// says the first that differs, and of how many there are.
  std::optional<std::string> problem(const Json& given) const {
    Entries computed;
    for(std::size_t i = 0; i < linking_.size(); ++i)
      for(const auto& [j, value] : linking_[i].row)
        computed[{static_cast<long long>(i), static_cast<long long>(j)}] = value;
    Entries differences = computed;
    for(const Json& entry : given) {
      if(!entry.is_array() || entry.size() != 3 ||
         !std::all_of(entry.begin(), entry.end(), is_small_integer))
        return "linking has an entry that is not three small integers";
      differences[{entry[0].get<long long>(), entry[1].get<long long>()}] -=
          entry[2].get<long long>();
    }
    std::size_t number = 0;
    std::string first;
    for(const auto& [place, difference] : differences) {
      const auto [i, j] = place;
      if(difference == 0 || !means_something(i) || !means_something(j))
        continue;
      const auto is = computed.find(place);
      const long long value = is == computed.end() ? 0 : is->second;
      if(number++ == 0)
        first = given_as("linking [" + std::to_string(i) + ", " + std::to_string(j) + "]",
                         std::to_string(value - difference), std::to_string(value));
    }
    if(number == 0)
      return {};
    return first +
           (number == 1 ? "" : "; " + std::to_string(number) + " linking numbers are wrong");
  }

private:
  using Entries = std::map<std::pair<long long, long long>, long long>;

  static bool is_small_integer(const Json& x) {
    return x.is_number_integer() && std::abs(x.get<double>()) < 0x1p31;
  }

  // Numbers of loops of which nothing is known mean nothing.
  bool means_something(long long i) const {
    return i < 0 || i >= static_cast<long long>(linking_.size()) ||
           linking_[static_cast<std::size_t>(i)].problem.empty();
  }

  const std::vector<Loop_linking>& linking_;
};

// What can be computed from a basis only.
constexpr std::array<const char*, 12> details = {"bore",
                                                 "thickness",
                                                 "clear_width",
                                                 "not_measured_because",
                                                 "cut",
                                                 "no_cut_because",
                                                 "fill",
                                                 "no_fill_because",
                                                 "diameter",
                                                 "diameter_of",
                                                 "out_of_roundness",
                                                 "wall_diameter"};

bool has_any(const Json& document, std::initializer_list<const char*> names) {
  const Json& pairs = document["pairs"];
  return std::any_of(pairs.begin(), pairs.end(), [&](const Json& pair) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return pair.contains(name); });
  });
}

/// What is so of the loops in a document.
class Loops_as_they_are
{
public:
  Loops_as_they_are(const Json& given,
                    const Mended_mesh& mended,
                    Bound_loops loops,
                    Certificate certificate,
                    Progress& progress)
      : given_(given)
      , mended_(mended)
      , has_measures_(has_any(given, {"thickness", "clear_width", "not_measured_because"}))
      , has_costs_(has_any(given, {"cut", "no_cut_because", "fill", "no_fill_because"})) {
    count_surface(mended.mesh, answer_.statistics);
    answer_.pairs = std::move(loops.pairs);
    answer_.boundaries = {std::move(loops.curves), std::move(loops.waists)};
    answer_.certificate = std::move(certificate);
    answer_.unit = mended.facts.unit;
    // What is computed from a basis needs one.
    if(is_basis(answer_.certificate))
      add_details(loops.throats, progress);
  }

  Json document() const {
    return loops_document(mended_.mesh, answer_, {"", options(), 0., mended_.cuts});
  }

private:
  void add_details(const std::vector<Loop>& throats, Progress& progress) {
    const Mesh& mesh = mended_.mesh;
    answer_.bores = find_bores(mesh, answer_.pairs);
    if(has_measures_)
      answer_.measures = find_measures(mesh, answer_.pairs, progress);
    if(has_costs_)
      answer_.costs = find_costs(mesh, answer_.pairs, progress);
    if(given_.contains("throats"))
      answer_.throats = classified_throats(mesh, answer_.pairs, answer_.certificate, throats);
  }

  // Of options, those that what is there shows.
  Json options() const {
    Json options = {{"basis", CGAL::Handle_tunnel_loops::name_of(answer_.certificate.basis_kind)},
                    {"throats", given_.contains("throats")}};
    if(!answer_.pairs.empty()) {
      options["measure"] = has_measures_;
      options["removal"] = has_costs_;
    }
    return options;
  }

  const Json& given_;
  const Mended_mesh& mended_;
  bool has_measures_, has_costs_;
  Answer answer_;
};

std::vector<std::string> problems_of_throats(const Mesh& mesh, const std::vector<Loop>& throats) {
  std::vector<std::string> problems;
  if(throats.empty())
    return problems;
  const std::vector<char> are_closed = are_closed_on_surface(mesh, throats);
  for(std::size_t i = 0; i < throats.size(); ++i)
    if(!are_closed[i])
      problems.push_back("throat " + std::to_string(i) + " is not a closed curve on the surface");
  return problems;
}

} // namespace

Checked_loops check_loops(const Input_file& file, const Mended_mesh& mended, Progress& progress) {
  const Mesh& mesh = mended.mesh;
  Bound_loops loops = bind_loops(read_loops_json(file), mesh);
  Checked_loops checked;
  if(!loops.are_placed) { // so nothing can be said of them
    checked.problems = loops.problems;
    return checked;
  }
  checked.certificate = certify(mesh, loops.pairs, loops.basis_kind, true);
  checked.components = components_of_pairs(mesh, loops.pairs);
  const Certificate& certificate = checked.certificate;
  checked.is_boundary_of_solid = loops.pairs.empty() || !touches_itself(mesh, throw_if_interrupted);
  // The worst first: loops that are no basis. Names mean nothing where there is no inside.
  if(!certificate && (checked.is_boundary_of_solid || !has_wrong_types_only(certificate)))
    append(checked.problems, lines_of(certificate.failure));
  if(loops.has_boundaries)
    append(checked.problems, problems_of_boundaries(mesh, loops.curves, loops.waists));
  append(checked.problems, loops.problems);
  const std::vector<std::string> of_throats = problems_of_throats(mesh, loops.throats);
  append(checked.problems, of_throats);
  if(!of_throats.empty())
    return checked;
  Json given = document_in(file);
  if(!is_basis(certificate)) {
    given.erase("throats");
    for(Json& pair : given["pairs"])
      for(const char* key : details)
        pair.erase(key);
  }
  Document_differences differences = compare_documents(
      given, Loops_as_they_are(given, mended, std::move(loops), certificate, progress).document(),
      largest_coordinate(mesh));
  append(checked.problems, differences.claims);
  if(is_basis(certificate) && given.contains("linking"))
    if(const auto problem = Linking_comparison(certificate.linking).problem(given["linking"]))
      checked.problems.push_back(*problem);
  checked.not_compared = std::move(differences.not_compared);
  return checked;
}

// ---- skeletons

namespace {

/// What is so of a skeleton in a document, of which the points have the same numbers.
class Skeleton_as_it_is
{
public:
  Skeleton_as_it_is(const Json& given,
                    const Mesh& mesh,
                    const Skeleton_lines& lines,
                    const Skeleton_certificate& certificate)
      : given_(given) {
    answer_.statistics.number_of_faces = mesh.number_of_faces();
    answer_.statistics.certificate = certificate;
    count_surface(mesh, answer_.statistics);
    answer_.vertex_point.assign(mesh.number_of_vertices(), Skeleton_answer::none);
    const std::vector<double> distances = distances_to_surface(mesh, lines.points);
    for(std::size_t p = 0; p < lines.points.size(); ++p) {
      auto& point = answer_.graph[add_vertex(answer_.graph)];
      point.point = lines.points[p];
      point.component = lines.components.empty() ? 0 : lines.components[p];
      point.is_inlet = lines.is_inlet[p] != 0;
      point.radius = point.is_inlet ? radius_of_inlet(mesh, lines.points[p], p) : distances[p];
    }
    for(const auto& [p, q] : lines.edges)
      add_edge(p, q, answer_.graph);
    find_arcs(lines);
  }

  /// arcs that do not lead from node to node.
  const std::vector<std::string>& problems() const { return problems_; }

  Json document() const { return skeleton_document(answer_, {"", Json::object()}); }

private:
  // Its distance to its curve: to that which fits best.
  double radius_of_inlet(const Mesh& mesh, const Point& p, std::size_t node) const {
    const Json& of = given_["nodes"][node];
    const double given =
        of.contains("radius") && of["radius"].is_number() ? of["radius"].get<double>() : 0.;
    double best = std::numeric_limits<double>::infinity();
    for(const Loop& curve : find_boundaries(mesh, false).curves) {
      const double distance = distance_to_curve(curve.points(), p);
      if(std::abs(distance - given) < std::abs(best - given))
        best = distance;
    }
    return best;
  }

  static double distance_to_curve(const std::vector<Point>& curve, const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < curve.size(); ++i) {
      const Point &a = curve[i], &b = curve[i + 1 == curve.size() ? 0 : i + 1];
      const double length = distance(a, b);
      const Kernel::Vector_3 along = length > 0. ? (b - a) / length : b - a;
      const double place = (std::min)((std::max)((p - a) * along, 0.), length);
      least = (std::min)(least, distance(p, a + place * along));
    }
    return least;
  }

  // Those of the document, as paths of the graph.
  void find_arcs(const Skeleton_lines& lines) {
    std::map<std::vector<std::size_t>, Skeleton_arc> by_points;
    for(Skeleton_arc& arc : arcs_of(answer_.graph)) {
      std::vector<std::size_t> points = arc.points;
      by_points.emplace(points, arc);
      std::reverse(points.begin(), points.end());
      arc.points = points;
      by_points.emplace(std::move(points), std::move(arc));
    }
    std::size_t edge = 0;
    for(std::size_t i = 0; i < given_["arcs"].size(); ++i) {
      std::vector<std::size_t> points = {lines.edges[edge][0]};
      for(std::size_t k = 1; k < given_["arcs"][i]["polyline"].size(); ++k)
        points.push_back(lines.edges[edge++][1]);
      const auto found = by_points.find(points);
      if(found == by_points.end())
        problems_.push_back("arc " + std::to_string(i) + " does not lead from node to node");
      else
        answer_.arcs.push_back(found->second);
    }
  }

  const Json& given_;
  Skeleton_answer answer_;
  std::vector<std::string> problems_;
};

} // namespace

Checked_skeleton check_skeleton(const Input_file& file, const Mesh& mesh, Progress& progress) {
  Skeleton_record record = read_skeleton(file);
  Checked_skeleton checked;
  const std::array<std::size_t, 2> size = {mesh.number_of_vertices(), mesh.number_of_faces()};
  if(record.mesh_size && *record.mesh_size != size) {
    checked.problems = {mesh_difference(*record.mesh_size, size)};
    return checked;
  }
  const Answer loops = host_backend.solve(mesh, Solve_options(), progress);
  const auto certificate = certify_skeleton(mesh, record.lines, loops.pairs, throw_if_interrupted);
  if(!certificate.taken_alone.empty())
    checked.taken_alone = certificate.taken_alone + "\n";
  if(!certificate.failure.empty())
    checked.problems = lines_of(checked.taken_alone + certificate.failure);
  checked.genus = loops.statistics.genus;
  if(is_document(file)) {
    const Json given = document_in(file);
    const Skeleton_as_it_is skeleton(given, mesh, record.lines, certificate);
    append(checked.problems, skeleton.problems());
    if(skeleton.problems().empty()) {
      Document_differences differences =
          compare_documents(given, skeleton.document(), largest_coordinate(mesh));
      append(checked.problems, differences.claims);
      checked.not_compared = std::move(differences.not_compared);
    }
  }
  checked.lines = std::move(record.lines);
  return checked;
}

} // namespace htloops
