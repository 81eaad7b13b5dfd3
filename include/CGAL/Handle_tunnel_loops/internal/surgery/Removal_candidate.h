// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_surgery.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How a region is laid along the loops of a handle.
struct Region_choice
{
  enum Style {
    STRIP,            ///< the faces at a loop, and some rings more
    BESIDE_LEFT,      ///< those at a loop some rings beside it
    BESIDE_RIGHT,     ///< ... on its other side
    SUBDIVIDED_STRIP, ///< the faces at a loop after a subdivision
    WHOLE,            ///< the faces at both loops, and some rings more
    KNOB              ///< the same, of a handle that sits on the surface like a knob on a lid
  };
  Style style;
  std::size_t loop; ///< the number of its choice
  int rings;

  /// whether its caps lie at the loop.
  bool is_at_loop() const { return style == STRIP || style == SUBDIVIDED_STRIP; }

  bool takes_both_loops() const { return style == WHOLE || style == KNOB; }

  /// whether it takes as many faces as there is room for.
  bool fits_into_room() const { return !takes_both_loops() && style != SUBDIVIDED_STRIP; }
};

/// all regions along the loops that are allowed, the first one first. All that is along one of the
/// two loops of a handle comes before what is along the other one; of other loops, the likely ones
/// along each come first.
inline std::vector<Region_choice> region_choices(const Removal_task& task) {
  using Choice = Region_choice;
  std::vector<std::size_t> allowed;
  for(std::size_t i = 0; i < task.choices.size(); ++i)
    if(task.choices[i].is_allowed)
      allowed.push_back(i);
  const bool are_both_allowed = task.has_both_loops() && allowed.size() == 2;
  std::vector<Choice> all;
  if(are_both_allowed)
    all.push_back({Choice::KNOB, 0, 8});
  for(std::size_t i : allowed)
    all.insert(all.end(), {{Choice::STRIP, i, 3},
                           {Choice::STRIP, i, 0},
                           {Choice::BESIDE_LEFT, i, 4},
                           {Choice::BESIDE_RIGHT, i, 4}});
  if(!task.has_both_loops())
    std::stable_partition(all.begin(), all.end(),
                          [](const Choice& c) { return c.style == Choice::STRIP && c.rings > 0; });
  if(are_both_allowed)
    for(int rings : {0, 1, 2, 4, 8, 12})
      all.push_back({Choice::WHOLE, 0, rings});
  for(std::size_t i : allowed)
    all.push_back({Choice::SUBDIVIDED_STRIP, i, 0});
  return all;
}

/// Lays out the regions of a round so that no two of them share a vertex, and that none takes away
/// more than it must of the loops of others. Regions are proposed by many threads at a time as long
/// as none is claimed.
class Region_layout
{
public:
  explicit Region_layout(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , is_claimed_(mesh.vertex_bound(), 0)
      , number_of_walks_at_(mesh.vertex_bound(), 0) {}

  /// has the wider regions of others stay clear of the vertices of a loop, each once.
  void reserve(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      ++number_of_walks_at_[v];
  }

  /// with the region that is chosen, if there is such a one. \p reserved are the vertices that are
  /// reserved for this handle, in ascending order.
  std::optional<Handle_surgery> surgery(const Region_choice& choice,
                                        const std::vector<Closed_walk>& walks,
                                        const std::vector<Index>& reserved) const {
    if(choice.style == Region_choice::SUBDIVIDED_STRIP)
      return Handle_surgery::subdivided(mesh_, walks[choice.loop]);
    std::optional<Cut_region> region = choice.takes_both_loops()
                                           ? whole(choice, walks)
                                           : strip(choice, walks[choice.loop], reserved);
    if(!region)
      return std::nullopt;
    return Handle_surgery(mesh_, std::move(*region));
  }

  /// whether no region of the round that is claimed shares one of these vertices.
  bool is_free(const std::vector<Index>& vertices) const {
    return std::none_of(vertices.begin(), vertices.end(),
                        [this](Index v) { return is_claimed_[v]; });
  }

  /// makes one that has these vertices one of the round.
  void claim(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      is_claimed_[v] = 1;
  }

private:
  std::optional<Cut_region> whole(const Region_choice& choice,
                                  const std::vector<Closed_walk>& walks) const {
    std::vector<Index> vertices;
    for(const Closed_walk& walk : walks)
      vertices.insert(vertices.end(), walk.begin(), walk.end());
    std::vector<Index> faces = Cut_region::faces_at(mesh_, vertices);
    if(choice.style == Region_choice::KNOB)
      return is_compact(walks) ? knob(std::move(faces), choice.rings) : std::nullopt;
    for(int ring = 0; ring < choice.rings; ++ring)
      faces = Cut_region::with_ring(mesh_, faces);
    return Cut_region::whole(mesh_, std::move(faces));
  }

  // Whether no loop is many times as long as another one, as between two shells.
  static bool is_compact(const std::vector<Closed_walk>& walks) {
    const auto is_shorter = [](const Closed_walk& a, const Closed_walk& b) {
      return a.size() < b.size();
    };
    const auto [least, most] = std::minmax_element(walks.begin(), walks.end(), is_shorter);
    return most->size() <= 8 * least->size();
  }

  // The first ring around two loops beyond which the surface is like a lid. Nothing is left of the
  // handle if a disc takes the place of what is within.
  std::optional<Cut_region> knob(std::vector<Index> faces, int most_rings) const {
    int number_of_misses = 0;
    for(int ring = 0; ring < most_rings && number_of_misses < 2; ++ring) {
      faces = Cut_region::with_ring(mesh_, faces);
      std::optional<Cut_region> region = Cut_region::whole(mesh_, faces);
      if(!region) { // there is more than a handle
        ++number_of_misses;
        continue;
      }
      const Normals around = normals_around(*region);
      if(are_alike(around))
        return region;
      if(do_cancel(around))
        break; // and so they will for further rings
    }
    return std::nullopt;
  }

  using Normals = std::vector<Surgery_mesh::Kernel::Vector_3>;

  // Twice as long as the areas, of the faces just beyond the border; some may have none.
  Normals normals_around(const Cut_region& region) const {
    Normals normals;
    for(Index h : region.border(0)) {
      const Surgery_mesh::Face& c = mesh_.corners(mesh_.face(mesh_.twin(h)));
      const Surgery_mesh::Point& p = mesh_.point(c[0]);
      normals.push_back(CGAL::cross_product(mesh_.point(c[1]) - p, mesh_.point(c[2]) - p));
    }
    return normals;
  }

  static Normals::value_type sum(const Normals& normals) {
    return std::accumulate(normals.begin(), normals.end(), Normals::value_type(NULL_VECTOR));
  }

  // Whether each is within 60 degrees of their mean.
  static bool are_alike(const Normals& normals) {
    const auto mean = sum(normals);
    return std::all_of(normals.begin(), normals.end(), [&](const auto& n) {
      const double product = n * mean;
      return product > 0. && 4. * product * product >= n.squared_length() * mean.squared_length();
    });
  }

  // Whether they have all but no direction.
  static bool do_cancel(const Normals& normals) {
    double sum_of_areas = 0.;
    for(const auto& n : normals)
      sum_of_areas += std::sqrt(n.squared_length());
    return !(2. * std::sqrt(sum(normals).squared_length()) >= sum_of_areas);
  }

  std::optional<Cut_region> strip(const Region_choice& choice,
                                  const Closed_walk& walk,
                                  const std::vector<Index>& reserved) const {
    const std::optional<Cut_region> region = around(walk, choice.rings, reserved);
    if(choice.style == Region_choice::STRIP || !region)
      return region;
    if(region->number_of_borders() == 1)
      return std::nullopt;
    const std::size_t border = choice.style == Region_choice::BESIDE_LEFT ? 0 : 1;
    return Cut_region::around(mesh_, region->vertices_of(mesh_, border));
  }

  // As many rings as fit.
  std::optional<Cut_region>
  around(const Closed_walk& vertices, int rings, const std::vector<Index>& reserved) const {
    std::optional<Cut_region> region = Cut_region::around(mesh_, vertices);
    for(int ring = 0; region && ring < rings; ++ring)
      for(std::size_t border = 0; border < region->number_of_borders(); ++border)
        if(std::optional<Cut_region> wider = region->wider(mesh_, border))
          if(is_fit(*wider, border, vertices.size(), reserved))
            region = std::move(wider);
    return region;
  }

  bool is_fit(const Cut_region& region,
              std::size_t border,
              std::size_t length_of_walk,
              const std::vector<Index>& reserved) const {
    const bool is_strip = region.number_of_borders() == 2;
    if(is_strip && 4 * region.border(border).size() > 5 * length_of_walk + 8)
      return false;
    const Closed_walk ring = region.vertices_of(mesh_, border);
    return std::none_of(ring.begin(), ring.end(), [&](Index v) {
      return is_claimed_[v] || number_of_walks_at_[v] > 1 ||
             (number_of_walks_at_[v] == 1 && !is_in(v, reserved));
    });
  }

  const Surgery_mesh& mesh_;
  // By vertex.
  std::vector<char> is_claimed_;
  std::vector<Index> number_of_walks_at_;
};

/// A handle that is to be removed, with the loops and regions that are left to be tried, one after
/// the other.
class Removal_candidate
{
public:
  explicit Removal_candidate(Removal_task& task)
      : task_(&task)
      , choices_(region_choices(task))
      , is_damaged_(task.choices.size(), 0)
      , separates_(task.choices.size(), 0) {
    task.reasons.assign(task.choices.size(), std::string());
  }

  /// to be called once, before all else.
  void find_walks(const Surgery_mesh& mesh) {
    CGAL_precondition(walks_.empty());
    for(const Loop_choice& loop : task_->choices) {
      walks_.push_back(simple_part(led_off_boundary(mesh, walk_beside(mesh, loop.places))));
      lengths_.push_back(length(mesh, walks_.back()));
    }
  }

  Removal_task& task() const { return *task_; }

  bool is_done() const { return task_->is_done(); }

  /// by choice; those with less than three vertices are none.
  const std::vector<Closed_walk>& walks() const { return walks_; }

  const Region_choice& choice() const {
    CGAL_precondition(next_ < choices_.size());
    return choices_[next_];
  }

  /// of the loop of the present choice; empty if that has none.
  Closed_walk partner() const {
    return task_->has_both_loops() ? walks_[1 - choice().loop] : Closed_walk();
  }

  /// of the present choice, if there is one.
  std::optional<Handle_surgery>& surgery() { return surgery_; }

  /// the loop of the present choice wants to keep its place.
  void reserve(Region_layout& layout) {
    CGAL_precondition(!is_done());
    reserved_ = walks_[choice().loop];
    make_set(reserved_);
    layout.reserve(reserved_);
  }

  /// goes on to the first choice, from the present one on, of which there is a region.
  void propose(const Surgery_mesh& mesh, const Region_layout& layout) {
    if(surgery_ && !is_narrow_ && surgery_->is_up_to_date(mesh))
      return;
    is_narrow_ = false;
    surgery_.reset();
    while(!is_done()) {
      if(const char* why = why_not_at_all())
        fail(why);
      else if((surgery_ = layout.surgery(choice(), walks_, reserved_)))
        return;
      else
        fail(is_on_boundary(mesh, walks_[choice().loop]) ? "the loop comes to the boundary"
                                                         : "the mesh is too coarse along the loop",
             false);
    }
  }

  /// the present choice once more, with room for the regions that are claimed by now.
  void propose_again(const Region_layout& layout) {
    is_narrow_ = true;
    surgery_ = layout.surgery(choice(), walks_, reserved_);
  }

  /// gives the present choice up, and the task if that is the last one.
  void fail(const char* why, bool is_last_word = true) {
    CGAL_precondition(!is_done());
    std::string& reason = task_->reasons[choice().loop];
    if(is_last_word || reason.empty())
      reason = why;
    surgery_.reset();
    if(++next_ == choices_.size())
      task_->state = is_any_damaged() ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
  }

  /// gives the present choice up, and all others at its loop: caps that cross themselves do so
  /// wherever they lie there.
  void fail_at_loop() {
    const Region_choice failed = choice();
    const auto is_as_bad = [&](const Region_choice& other) {
      return failed.is_at_loop() && other.is_at_loop() && other.loop == failed.loop;
    };
    const auto others = choices_.begin() + static_cast<std::ptrdiff_t>(next_) + 1;
    choices_.erase(std::remove_if(others, choices_.end(), is_as_bad), choices_.end());
    fail("the caps would meet each other");
  }

  /// gives the loop of the present choice up: all strips along it separate the surface.
  void fail_along_loop() {
    separates_[choice().loop] = 1;
    fail(separates_the_surface);
  }

  /// leads a loop around what has taken the place of another handle. It is given up if it comes to
  /// a vertex twice then, or becomes much longer. Returns whether it was led.
  bool lead_around(const Surgery_mesh& mesh, const Detour& detour, std::size_t loop) {
    CGAL_precondition(!is_done());
    constexpr double most_growth = 1.5;
    Closed_walk& walk = walks_[loop];
    if(walk.size() < 3 || is_intact(mesh, walk))
      return false;
    walk = led_off_boundary(mesh, shortened(mesh, detour.around(walk)));
    if(!is_simple(walk) || length(mesh, walk) > most_growth * lengths_[loop])
      walk.clear();
    is_damaged_[loop] = true;
    return !walk.empty();
  }

private:
  const char* why_not_at_all() const {
    if(separates_[choice().loop] && !choice().takes_both_loops())
      return separates_the_surface;
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if((i == choice().loop || choice().takes_both_loops()) && walks_[i].size() < 3)
        return is_damaged_[i] ? "another handle was removed across the loop"
                              : "the loop is not simple";
    return nullptr;
  }

  bool is_any_damaged() const {
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if(is_damaged_[i] && task_->choices[i].is_allowed)
        return true;
    return false;
  }

  static constexpr const char* separates_the_surface = "the loop separates the surface";

  Removal_task* task_;
  std::vector<Closed_walk> walks_;
  std::vector<double> lengths_; // of these at first
  std::vector<Region_choice> choices_;
  std::vector<char> is_damaged_; // by choice, also if it could be led around
  std::vector<char> separates_;  // by choice
  std::size_t next_ = 0;
  std::vector<Index> reserved_; // in ascending order
  std::optional<Handle_surgery> surgery_;
  bool is_narrow_ = false; // because of regions of the round
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H
