// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/cleaning.h"

#include "clean/copies.h"
#include "clean/crossings.h"
#include "clean/fates.h"
#include "clean/holes.h"
#include "clean/parts.h"
#include "interrupt.h"
#include "solve/backends.h"
#include "solve/certification.h"
#include "solve/details.h"
#include "words.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace htloops {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Face = Changeable_mesh::Face_index;

double absolute(const Relative_length& length, const Mesh& mesh) {
  return length.is_share ? length.value * diagonal_of(mesh) : length.value;
}

// Of the parts for which that holds; how many there are.
template <typename Predicate>
std::size_t turn_over(Changeable_mesh& mesh, const Parts& parts, const Predicate& holds) {
  std::vector<char> is_turned;
  for(std::size_t i = 0; i < parts.all.size(); ++i)
    is_turned.push_back(parts.all[i].is_turned() && holds(i));
  std::vector<Face> turned;
  for(const Face f : mesh.faces())
    if(is_turned[parts.of_face[f.idx()]])
      turned.push_back(f);
  PMP::reverse_face_orientations(turned, mesh);
  return std::size_t(std::count(is_turned.begin(), is_turned.end(), 1));
}

Mesh_state state_of(const Changeable_mesh& mesh, const Crossings& crossings) {
  const Parts parts = measured_parts(mesh);
  Mesh_state state;
  for(const auto v : mesh.vertices())
    state.vertices += !mesh.is_isolated(v);
  state.faces = mesh.number_of_faces();
  state.parts = parts.all.size();
  std::vector<Changeable_mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  state.boundaries = borders.size();
  state.crossings = crossings.crossing.size();
  // V - E + F = 2 c - 2 g - b
  state.genus =
      (2 * state.parts + mesh.number_of_edges() - state.boundaries - state.vertices - state.faces) /
      2;
  for(const Part& part : parts.all)
    state.volume += borders.empty() ? part.orientation * part.volume : 0.;
  return state;
}

std::string words_of_handles(const Removal_report& report) {
  return "genus " + std::to_string(report.genus_before) + " -> " +
         std::to_string(report.genus_after);
}

class Cleaner
{
public:
  Cleaner(const Mesh& mesh, const Clean_options& options, Progress& progress)
      : mesh_(mesh)
      , options_(options)
      , progress_(progress) {
    static_cast<Changed_mesh&>(result_) = unchanged_mesh(mesh);
    result_.fates.assign(mesh.number_of_faces(), Face_fate::KEPT);
  }

  Cleaned_mesh operator()() {
    const Stopwatch stopwatch;
    progress_.start("clean");
    close_surface();
    if(options_.has(Clean_step::CHANNELS))
      close_channels();
    drop_parts();
    if(options_.has(Clean_step::HANDLES))
      remove_small_handles();
    find_replaced_faces();
    result_.total_seconds = stopwatch.seconds();
    return std::move(result_);
  }

private:
  void go_on_with(const Changed_mesh& changed) {
    loops_.reset();
    static_cast<Changed_mesh&>(result_) = composed(result_, changed);
  }

  // Where whole faces were put in or taken out.
  void go_on_with_parts(const Changed_mesh& changed) {
    crossings_ = kept_crossings(crossings_, changed);
    go_on_with(changed);
  }

  // What was removed may have been crossed; what was put in is not.
  void go_on_without_handles(const Changed_mesh& changed) {
    go_on_with(changed);
    if(!crossings_.crossing.empty() || !crossings_.touching.empty())
      crossings_ = crossings_of(Changeable_copy(result_.mesh).mesh);
  }

  // ---- the surface

  // Which side is which is known where a part is closed.
  void close_surface() {
    Changeable_copy copy(result_.mesh);
    result_.before = state_of(copy.mesh, {});
    note_open_parts(copy.mesh);
    Clean_record holes{Clean_step::HOLES};
    if(options_.has(Clean_step::HOLES) && result_.before.boundaries > 0) {
      Closed_holes closed = close_holes(copy.mesh);
      describe(closed, holes);
      crossings_ = std::move(closed.crossings);
    } else if(touches_itself(result_.mesh, throw_if_interrupted)) // found sooner
      crossings_ = crossings_of(copy.mesh);
    if(options_.has(Clean_step::HOLES))
      result_.records.push_back(holes);
    if(options_.has(Clean_step::ORIENT))
      orient(copy.mesh);
    result_.before.crossings = crossings_.crossing.size(); // caps cross nothing
    go_on_with_parts(changed_mesh(copy.mesh, result_.mesh));
  }

  void note_open_parts(const Changeable_mesh& mesh) {
    const Parts parts = measured_parts(mesh);
    for(const Face f : mesh.faces())
      was_open_.push_back(!parts.part_of(f).is_closed);
  }

  void orient(Changeable_mesh& mesh) {
    const Parts parts = parts_of(mesh, crossings_);
    const auto is_outer = [&](std::size_t part) { return parts.all[part].depth == 0; };
    result_.records.push_back({Clean_step::ORIENT});
    note_turned(turn_over(mesh, parts, is_outer)); // others perhaps go
  }

  void note_turned(std::size_t number) {
    for(Clean_record& record : result_.records)
      if(record.step == Clean_step::ORIENT && number > 0) {
        record.count += number;
        record.done = {"turned over " + counted(record.count, "part that was", "parts that were") +
                       " inside out"};
      }
  }

  void describe(const Closed_holes& holes, Clean_record& record) {
    record.count = holes.closed;
    open_holes_ = holes.open;
    if(holes.closed > 0)
      record.done = {"closed " + counted(holes.closed, "hole", "holes") + ", " +
                     formatted("%s%.4g around", holes.closed > 1 ? "up to " : "", holes.longest)};
  }

  // ---- channels

  void close_channels() {
    Clean_record record{Clean_step::CHANNELS};
    const double most = absolute(options_.channel_length, mesh_);
    if(!(most > 0.))
      return; // all points are one
    const Pairs& pairs = loops();
    const Removal_answer answer = remove_channels(pairs, most);
    record.count = number_of_channels(answer.report);
    if(record.count > 0) {
      record.done = {"closed " + words_of_channels(answer.report)};
      keep_loops(pairs, answer.report);
      go_on_without_handles(answer);
    } else if(const std::string words = words_of_wider_channels(pairs, most); !words.empty())
      record.left = {words};
    if(const std::size_t refused =
           answer.report.refused.size() + answer.report.refused_necks.size();
       refused > 0 && record.count == 0)
      record.left.push_back(counted(refused, "short hole", "short holes") +
                            " cannot be filled: nothing tells whether an inner wall is behind");
    result_.records.push_back(record);
  }

  Removal_answer remove_channels(const Pairs& pairs, double most) {
    Removal_options wanted;
    wanted.number_of_threads = options_.number_of_threads;
    wanted.maximal_neck_length = most;
    wanted.only_channels = true;
    return remove_handles(result_.mesh, pairs, wanted, progress_);
  }

  static std::size_t number_of_channels(const Removal_report& report) {
    return report.removed.size() + report.removed_necks.size();
  }

  // The last one of those that lead to a wall is a neck.
  static std::string words_of_channels(const Removal_report& report) {
    double longest = 0.;
    for(const auto* some : {&report.removed, &report.removed_necks})
      for(const Removed_handle& channel : *some)
        longest = (std::max)(longest, channel.length);
    const std::size_t number = number_of_channels(report), walls = report.removed_necks.size();
    return counted(number, "channel", "channels") + ", " +
           formatted("%s%.4g around: ", number > 1 ? "up to " : "", longest) +
           counted(walls, "inner wall comes", "inner walls come") + " off";
  }

  // What a person may mean who finds that nothing was done.
  std::string words_of_wider_channels(const Pairs& pairs, double most) {
    constexpr double times = 4.;
    constexpr std::ptrdiff_t most_handles = 30; // it takes time to try them
    if(std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) {
         return pair.tunnel().length() < times * most;
       }) > most_handles)
      return "";
    const Removal_report report = remove_channels(pairs, times * most).report;
    const double percent = 100. * times * most / diagonal_of(mesh_);
    return number_of_channels(report) == 0
               ? ""
               : formatted("--channels %.3g%% would close ", percent) + words_of_channels(report);
  }

  // Of the mesh as it is.
  const Pairs& loops() {
    Solve_options options;
    options.number_of_threads = options_.number_of_threads;
    if(!loops_)
      loops_ = host_backend.solve(result_.mesh, options, progress_).pairs;
    return *loops_;
  }

  // As a person would look for them.
  void keep_loops(const Pairs& pairs, const Removal_report& report) {
    for(const Removed_handle& handle : report.removed) {
      const Pair& pair = pairs[handle.pair];
      result_.closed_loops.push_back(
          (handle.by == Removal_way::CUT ? pair.handle() : pair.tunnel()).points());
    }
  }

  // ---- parts

  void drop_parts() {
    Changeable_copy copy(result_.mesh);
    const Parts parts = parts_of(copy.mesh, crossings_);
    const Part_fates decided =
        fates_of(parts, find_copies(copy.mesh, parts), parts_that_were_open(parts), options_);
    if(options_.has(Clean_step::FLOATERS))
      result_.records.push_back(decided.floaters);
    if(options_.has(Clean_step::SHELLS))
      result_.records.push_back(decided.shells);
    std::size_t turned = 0;
    if(options_.has(Clean_step::ORIENT))
      turned = turn_over(copy.mesh, parts,
                         [&](std::size_t part) { return decided.fates[part] == Face_fate::KEPT; });
    note_turned(turned);
    if(take_out(copy.mesh, parts, decided.fates) || turned > 0)
      go_on_with_parts(changed_mesh(copy.mesh, result_.mesh));
    result_.after = state_of(copy.mesh, crossings_);
    note_open_holes();
  }

  // Of parts that are still there.
  void note_open_holes() {
    std::vector<char> is_gone(mesh_.number_of_vertices(), 1);
    for(const std::int64_t origin : result_.vertex_origins)
      if(origin != nothing_before)
        is_gone[std::size_t(origin)] = 0;
    for(Clean_record& record : result_.records)
      for(const Open_hole& hole : open_holes_)
        if(record.step == Clean_step::HOLES &&
           (hole.vertex.idx() >= is_gone.size() || !is_gone[hole.vertex.idx()]))
          record.left.push_back(hole.why);
  }

  std::vector<char> parts_that_were_open(const Parts& parts) const {
    std::vector<char> were_open(parts.all.size(), 0);
    for(std::size_t f = 0; f < result_.face_parents.size(); ++f)
      if(const std::int64_t parent = result_.face_parents[f]; parent != nothing_before)
        were_open[parts.of_face[f]] |= was_open_[std::size_t(parent)];
    return were_open;
  }

  // Whether anything was there that goes.
  bool take_out(Changeable_mesh& mesh, const Parts& parts, const std::vector<Face_fate>& fates) {
    for(std::size_t f = 0; f < result_.face_origins.size(); ++f)
      if(const std::int64_t origin = result_.face_parents[f]; origin != nothing_before)
        result_.fates[std::size_t(origin)] = fates[parts.of_face[f]];
    std::vector<Face> out;
    for(const Face f : mesh.faces())
      if(fates[parts.of_face[f.idx()]] != Face_fate::KEPT)
        out.push_back(f);
    for(const Face f : out)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    return PMP::remove_isolated_vertices(mesh) + out.size() > 0;
  }

  // ---- handles

  void remove_small_handles() {
    Clean_record record{Clean_step::HANDLES};
    const std::size_t genus = result_.after.genus;
    if(options_.noise_below || options_.genus) {
      if(genus > options_.genus.value_or(0))
        remove(loops(), record);
    } else if(genus > 0)
      record.left = {words_of_left(loops())};
    result_.records.push_back(record);
  }

  void remove(const Pairs& pairs, Clean_record& record) {
    Removal_options wanted;
    wanted.number_of_threads = options_.number_of_threads;
    if(options_.genus)
      wanted.target_genus = *options_.genus;
    if(options_.noise_below)
      wanted.pairs = pairs_of_noise(pairs, absolute(*options_.noise_below, mesh_), record);
    const Removal_answer answer = remove_handles(result_.mesh, pairs, wanted, progress_);
    record.count = answer.report.removed.size();
    if(record.count > 0)
      record.done = {"removed " + counted(record.count, "handle", "handles") + ", " +
                     words_of_handles(answer.report)};
    for(const Refused_handle& refused : answer.report.refused)
      record.left.push_back(formatted("a handle %.4g around: ", refused.length) + refused.reason);
    keep_loops(pairs, answer.report);
    go_on_without_handles(answer);
    result_.after = state_of(Changeable_copy(result_.mesh).mesh, crossings_);
  }

  std::vector<std::size_t> pairs_of_noise(const Pairs& pairs, double below, Clean_record& record) {
    constexpr double precision = 0.01;
    const Measures measures = find_measures(result_.mesh, pairs, precision, progress_);
    std::vector<std::size_t> numbers;
    for(std::size_t i = 0; i < measures.size(); ++i)
      if(const std::optional<double> noise = noise_of(measures[i]); noise && *noise < below)
        numbers.push_back(i);
      else if(!noise)
        record.left.push_back("a handle is not measured: " + measures[i].why);
    return numbers;
  }

  // None is removed unless a size is given: which of them are meant, nobody can tell.
  std::string words_of_left(const Pairs& pairs) const {
    constexpr double small = 0.03;
    std::size_t number = 0;
    for(const Pair& pair : pairs)
      number +=
          (std::min)(pair.handle().length(), pair.tunnel().length()) < small * diagonal_of(mesh_);
    return counted(pairs.size(), "handle", "handles") + ", " +
           (number == 0 ? "none of them" : std::to_string(number) + " of them") +
           " with a loop shorter than 3% of the diagonal: --noise-below or --genus removes some";
  }

  // ---- at last

  // Of what has become no face of the result, and was not dropped with its part.
  void find_replaced_faces() {
    std::vector<char> is_there(mesh_.number_of_faces(), 0);
    for(const std::int64_t parent : result_.face_parents)
      if(parent != nothing_before)
        is_there[std::size_t(parent)] = 1;
    for(std::size_t f = 0; f < is_there.size(); ++f)
      if(!is_there[f] && result_.fates[f] == Face_fate::KEPT)
        result_.fates[f] = Face_fate::REPLACED;
  }

  const Mesh& mesh_;
  const Clean_options& options_;
  Progress& progress_;
  Cleaned_mesh result_;
  Crossings crossings_;        // of the mesh as it is
  std::vector<char> was_open_; // by face of the mesh, whether its part had a boundary
  std::vector<Open_hole> open_holes_;
  std::optional<Pairs> loops_;
};

} // namespace

const char* name_of(Clean_step step) {
  constexpr const char* names[] = {"repair",   "holes",  "orient", "channels",
                                   "floaters", "shells", "handles"};
  return names[static_cast<std::size_t>(step)];
}

Cleaned_mesh clean(const Mesh& mesh, const Clean_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  return Cleaner(mesh, options, progress)();
}

} // namespace htloops
