// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/fates.h"

#include "clean/volume_change.h"
#include "words.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace htloops {
namespace {

// How much some parts are, or all that lie inside of no other one.
struct Amount
{
  std::size_t number = 0;
  double volume = 0., area = 0.;

  void add(const Part& part) {
    ++number;
    volume += part.volume;
    area += part.area;
  }

  bool is_less(double share, const Amount& whole) const {
    return volume < share * whole.volume &&
           area < (share > 0. ? internal::power(share, 2. / 3.) : 0.) * whole.area;
  }

  std::string words(const Amount& whole) const {
    return formatted("%.2g%% of the volume and %.2g%% of the area",
                     whole.volume > 0. ? 100. * volume / whole.volume : 0.,
                     100. * area / whole.area);
  }
};

class Judge_of_parts
{
public:
  Judge_of_parts(const Parts& parts,
                 const std::vector<char>& is_copy,
                 const std::vector<char>& was_open,
                 const std::vector<char>& is_separated,
                 const Clean_options& options)
      : parts_(parts.all)
      , is_copy_(is_copy)
      , was_open_(was_open)
      , is_separated_(is_separated)
      , options_(options) {
    result_.fates.assign(parts_.size(), Face_fate::KEPT);
    for(std::size_t i = 0; i < parts_.size(); ++i)
      if(const Part& part = parts_[i]; part.depth == 0 && !is_copy_[i]) {
        whole_.add(part);
        if(largest_ == nullptr || size_of(part) > size_of(*largest_))
          largest_ = &part;
      }
  }

  Part_fates operator()() {
    if(options_.has(Clean_step::SHELLS))
      drop_shells();
    if(options_.has(Clean_step::FLOATERS) && options_.floater_share > 0.) {
      drop_crumbs();
      drop_scraps();
    }
    return std::move(result_);
  }

private:
  using Numbers = std::vector<std::size_t>;

  static std::pair<double, double> size_of(const Part& part) { return {part.volume, part.area}; }

  // Numbers of parts for which that holds, inside of no other part, and but for the largest.
  template <typename Predicate> Numbers outer_parts(const Predicate& holds) const {
    Numbers numbers;
    for(std::size_t i = 0; i < parts_.size(); ++i)
      if(parts_[i].depth == 0 && !is_copy_[i] && &parts_[i] != largest_ && holds(parts_[i]))
        numbers.push_back(i);
    return numbers;
  }

  Amount amount_of(const Numbers& numbers) const {
    Amount amount;
    for(const std::size_t i : numbers)
      amount.add(parts_[i]);
    return amount;
  }

  void drop(const Numbers& numbers, Face_fate fate, Clean_record& record) {
    record.count += numbers.size();
    for(const std::size_t i : numbers)
      result_.fates[i] = fate;
  }

  void drop_crumbs() {
    constexpr double together = 5.;
    const double share = options_.floater_share;
    const auto is_small = [&](const Part& part) {
      Amount amount;
      amount.add(part);
      return part.is_closed && amount.is_less(share, whole_);
    };
    const Numbers crumbs =
        outer_parts([&](const Part& part) { return is_small(part) && !part.meets_others; });
    const std::size_t meeting = outer_parts(is_small).size() - crumbs.size();
    if(const Amount amount = amount_of(crumbs); amount.number > 0) {
      const std::string words =
          counted(amount.number, "small part", "small parts") + ", " + amount.words(whole_);
      if(amount.is_less(together * share, whole_)) {
        drop(crumbs, Face_fate::FLOATER, result_.floaters);
        result_.floaters.done.push_back("dropped " + words);
      } else
        result_.floaters.left.push_back(words + ": too much to drop");
    }
    if(meeting > 0)
      result_.floaters.left.push_back(
          counted(meeting, "small part that touches", "small parts that touch") + " others");
  }

  void drop_scraps() {
    constexpr double most = 0.01; // of the area
    const Numbers scraps = outer_parts([](const Part& part) { return !part.is_closed; });
    const Amount amount = amount_of(scraps);
    if(amount.number == 0)
      return;
    const std::string words = counted(amount.number, "part", "parts") +
                              " with a boundary that cannot be closed" +
                              formatted(", %.2g%% of the area", 100. * amount.area / whole_.area);
    if(amount.area < most * whole_.area) {
      drop(scraps, Face_fate::FLOATER, result_.floaters);
      result_.floaters.done.push_back("dropped " + words);
    } else
      result_.floaters.left.push_back(words);
  }

  // Of large parts, a wall of a bowl is not hidden by the other one.
  bool is_hidden(std::size_t part) const {
    constexpr double large = 0.01; // of the area
    const bool is_doubtful = was_open_[part] && parts_[part].area >= large * whole_.area;
    const std::vector<std::uint32_t>& around = parts_[part].around;
    return std::any_of(around.begin(), around.end(),
                       [&](std::uint32_t outer) { return !is_doubtful || !was_open_[outer]; });
  }

  // How often what is just outside of a part is wound around; what is there twice counts once, and
  // a hollow that is to go is none.
  int winding_around(std::size_t part) const {
    int winding = 0;
    for(const std::uint32_t outer : parts_[part].around)
      if(!is_copy_[outer] && !is_separated_[outer])
        winding += parts_[outer].orientation;
    return winding;
  }

  // What it does to the volume that a part is there; a wall amid solid does nothing.
  double share_in_volume(std::size_t part) const {
    const int out = winding_around(part), in = out + parts_[part].orientation;
    return double((in != 0) - (out != 0)) * parts_[part].volume;
  }

  std::uint32_t outermost_around(std::size_t part) const {
    const std::vector<std::uint32_t>& around = parts_[part].around;
    return *std::min_element(around.begin(), around.end(), [&](std::uint32_t a, std::uint32_t b) {
      return parts_[a].depth < parts_[b].depth;
    });
  }

  // Takes those from the hidden parts that it would do harm to drop, unasked.
  void keep_hollows(Numbers& hidden) {
    if(options_.is_sure)
      return;
    std::map<std::uint32_t, Numbers> walls; // by the part around them
    for(const std::size_t i : hidden)
      if(!is_separated_[i] && share_in_volume(i) != 0.)
        walls[outermost_around(i)].push_back(i);
    for(const auto& [outer, inner] : walls) {
      Volume_change change{parts_[outer].volume, parts_[outer].volume};
      for(const std::size_t i : inner)
        change.before += share_in_volume(i);
      if(!change.is_large())
        continue;
      for(const std::size_t i : inner)
        hidden.erase(std::find(hidden.begin(), hidden.end(), i));
      result_.shells.left.push_back(
          counted(inner.size(), "shell inside another part", "shells inside another part") +
          ": dropping " + (inner.size() == 1 ? "it" : "them") + " would change " + change.words() +
          "; use --yes to do it");
    }
  }

  void drop_shells() {
    Numbers hidden, copies;
    std::size_t in_doubt = 0;
    for(std::size_t i = 0; i < parts_.size(); ++i)
      if(is_copy_[i])
        copies.push_back(i);
      else if(is_hidden(i))
        hidden.push_back(i);
      else if(parts_[i].depth > 0)
        ++in_doubt;
    keep_hollows(hidden);
    drop(hidden, Face_fate::SHELL, result_.shells);
    if(!hidden.empty())
      result_.shells.done = {"dropped " + counted(hidden.size(), "shell inside another part",
                                                  "shells inside other parts")};
    drop(copies, Face_fate::SHELL, result_.shells);
    if(!copies.empty())
      result_.shells.done.push_back("dropped " + counted(copies.size(), "copy", "copies") +
                                    " of other parts at the same place");
    if(in_doubt > 0)
      result_.shells.left.push_back(
          counted(in_doubt, "part", "parts") +
          " inside another one, both with a boundary: perhaps one wall without its rim");
  }

  const std::vector<Part>& parts_;
  const std::vector<char>&is_copy_, &was_open_, &is_separated_;
  const Clean_options& options_;
  const Part* largest_ = nullptr;
  Amount whole_;
  Part_fates result_;
};

} // namespace

Part_fates fates_of(const Parts& parts,
                    const std::vector<char>& is_copy,
                    const std::vector<char>& was_open,
                    const std::vector<char>& is_separated,
                    const Clean_options& options) {
  return Judge_of_parts(parts, is_copy, was_open, is_separated, options)();
}

} // namespace htloops
