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
#include "clean/handle_steps.h"
#include "clean/holes.h"
#include "clean/parts.h"
#include "interrupt.h"
#include "solve/backends.h"
#include "solve/certification.h"
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

constexpr Relative_length usual_channel_length = {0.03, true}; // drains of a hollow are wider

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

Mesh_state state_of(const Changeable_mesh& mesh, const Parts& parts, const Crossings& crossings) {
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
    progress_.start("clean");
    close_surface();
    const double longest = absolute(options_.channel_length.value_or(usual_channel_length), mesh_);
    if(options_.has(Clean_step::CHANNELS) && longest > 0.) // or all points are one
      take(close_channels(result_.mesh, loops(), longest, options_, progress_));
    drop_parts();
    if(options_.has(Clean_step::HANDLES))
      take(remove_small_handles(result_.mesh, loops(), diagonal_of(mesh_), options_, progress_));
    find_replaced_faces();
    const Changeable_copy copy(result_.mesh);
    result_.after = state_of(copy.mesh, measured_parts(copy.mesh), crossings_);
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
    const Parts parts = measured_parts(copy.mesh);
    result_.before = state_of(copy.mesh, parts, {});
    pieces_ = parts.of_face;
    for(const Face f : copy.mesh.faces())
      was_open_.push_back(!parts.part_of(f).is_closed);
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
        record.done = {"flipped " + counted(record.count, "part that was", "parts that were") +
                       " inside out"};
      }
  }

  void describe(const Closed_holes& holes, Clean_record& record) {
    record.count = holes.closed;
    open_holes_ = holes.open;
    if(holes.closed > 0)
      record.done = {
          "closed " + counted(holes.closed, "hole", "holes") + ", " +
          formatted("perimeter %s%.4g", holes.closed > 1 ? "up to " : "", holes.longest)};
  }

  // ---- what needs loops

  void take(const Handle_step& step) {
    result_.records.push_back(step.record);
    if(step.answer) {
      keep_loops(step.answer->report);
      go_on_without_handles(*step.answer);
    }
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
  void keep_loops(const Removal_report& report) {
    for(const Removed_handle& handle : report.removed) {
      const Pair& pair = loops()[handle.pair];
      result_.closed_loops.push_back(
          (handle.by == Removal_way::CUT ? pair.handle() : pair.tunnel()).points());
    }
  }

  // ---- parts

  void drop_parts() {
    Changeable_copy copy(result_.mesh);
    Parts parts = parts_of(copy.mesh, crossings_);
    const Part_fates decided =
        fates_of(parts, find_copies(copy.mesh, parts), parts_that_were_open(parts),
                 separated_parts(parts), options_);
    count_kept_around(parts, decided.fates);
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

  // Of which the channels to a part around them have been closed.
  std::vector<char> separated_parts(const Parts& parts) const {
    std::vector<std::int64_t> pieces(parts.all.size(), nothing_before);
    for(std::size_t f = 0; f < result_.face_parents.size(); ++f)
      if(const std::int64_t parent = result_.face_parents[f]; parent != nothing_before)
        pieces[parts.of_face[f]] = pieces_[std::size_t(parent)];
    std::vector<char> is_separated;
    for(std::size_t i = 0; i < parts.all.size(); ++i) {
      const auto& around = parts.all[i].around;
      is_separated.push_back(std::any_of(around.begin(), around.end(), [&](std::uint32_t outer) {
        return pieces[outer] == pieces[i];
      }));
    }
    return is_separated;
  }

  static void count_kept_around(Parts& parts, const std::vector<Face_fate>& fates) {
    for(Part& part : parts.all)
      part.depth = std::size_t(
          std::count_if(part.around.begin(), part.around.end(),
                        [&](std::uint32_t outer) { return fates[outer] == Face_fate::KEPT; }));
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
  Crossings crossings_;               // of the mesh as it is
  std::vector<char> was_open_;        // by face of the mesh, whether its part had a boundary
  std::vector<std::uint32_t> pieces_; // by face of the mesh, the number of its part
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
