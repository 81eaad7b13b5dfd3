// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/handle_steps.h"

#include "clean/parts.h"
#include "clean/volume_change.h"
#include "solve/details.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace htloops {
namespace {

std::size_t number_of_channels(const Removal_report& report) {
  return report.removed.size() + report.removed_necks.size();
}

// The last one of those that lead to a wall is a neck.
std::string words_of_channels(const Removal_report& report) {
  double longest = 0.;
  for(const auto* some : {&report.removed, &report.removed_necks})
    for(const Removed_handle& channel : *some)
      longest = (std::max)(longest, channel.length);
  const std::size_t number = number_of_channels(report), walls = report.removed_necks.size();
  return counted(number, "channel", "channels") +
         formatted(" (perimeter %s%.4g), separating ", number > 1 ? "up to " : "", longest) +
         counted(walls, "inner wall", "inner walls");
}

Removal_answer remove_channels(const Mesh& mesh,
                               const Pairs& pairs,
                               double most,
                               const Clean_options& options,
                               Progress& progress) {
  Removal_options wanted;
  wanted.number_of_threads = options.number_of_threads;
  wanted.maximal_neck_length = most;
  wanted.only_channels = true;
  return remove_handles(mesh, pairs, wanted, progress);
}

// Of the piece where it is largest, once the inner walls go.
Volume_change change_by(const Mesh& mesh, const Changed_mesh& closed) {
  const Parts pieces = measured_parts(Changeable_copy(mesh).mesh),
              parts = measured_parts(Changeable_copy(closed.mesh).mesh);
  std::vector<double> outer(pieces.all.size(), 0.); // the volumes in outer walls
  for(std::size_t f = 0; f < closed.face_parents.size(); ++f)
    if(const std::int64_t parent = closed.face_parents[f]; parent != nothing_before) {
      double& most = outer[pieces.of_face[std::size_t(parent)]];
      most = (std::max)(most, parts.all[parts.of_face[f]].volume);
    }
  Volume_change largest{1., 1.};
  for(std::size_t i = 0; i < outer.size(); ++i)
    if(const Volume_change change{pieces.all[i].volume, outer[i]};
       change.before > 0. && std::abs(change.share()) > std::abs(largest.share()))
      largest = change;
  return largest;
}

// What a person may mean who finds that nothing was done.
std::string words_of_wider_channels(const Mesh& mesh,
                                    const Pairs& pairs,
                                    double most,
                                    const Clean_options& options,
                                    Progress& progress) {
  constexpr double times = 4.;
  constexpr std::ptrdiff_t most_handles = 30; // it takes time to try them
  if(std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) {
       return pair.tunnel().length() < times * most;
     }) > most_handles)
    return "";
  const Removal_answer answer = remove_channels(mesh, pairs, times * most, options, progress);
  if(number_of_channels(answer.report) == 0)
    return "";
  const Volume_change change = change_by(mesh, answer);
  return formatted("--channels %.3g%% would close ", 100. * times * most / diagonal_of(mesh)) +
         words_of_channels(answer.report) +
         (change.is_large() && options.has(Clean_step::SHELLS) ? ", and change " + change.words()
                                                               : "");
}

std::vector<std::size_t> pairs_of_noise(const Mesh& mesh,
                                        const Pairs& pairs,
                                        double diagonal,
                                        const Clean_options& options,
                                        Clean_record& record,
                                        Progress& progress) {
  const auto [value, is_share] = *options.noise_below;
  const double below = is_share ? value * diagonal : value;
  const Measures measures = find_measures(mesh, pairs, progress);
  if(!options.is_sure && !options.is_dry_run)
    check_noise(noise_sizes(pairs, measures),
                is_share ? formatted("%.6g%%", 100. * value) : formatted("%.6g", value), below,
                diagonal);
  const Noisy_pairs noisy = noisy_pairs(pairs, measures, below);
  record.undecided = noisy.undecided.size();
  for(std::size_t i : noisy.undecided)
    record.left.push_back("a handle: " + words_of_doubt(measures[i], pairs[i]));
  return noisy.below;
}

// Which of them are meant, nobody can tell.
std::string words_of_left(const Mesh& mesh, const Pairs& pairs) {
  constexpr double small = 0.03;
  const auto number = std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) {
    return (std::min)(pair.handle().length(), pair.tunnel().length()) < small * diagonal_of(mesh);
  });
  return (pairs.size() == 1
              ? std::string("1 handle, ") + (number == 0 ? "without" : "with")
              : std::to_string(pairs.size()) + " handles, " +
                    (number == 0 ? "none" : std::to_string(number)) + " of them with") +
         " a loop shorter than 3% of the diagonal: use --noise-below or --genus to remove " +
         (pairs.size() == 1 ? "it" : "some");
}

} // namespace

Handle_step close_channels(const Mesh& mesh,
                           const Pairs& pairs,
                           double most,
                           const Clean_options& options,
                           Progress& progress) {
  Handle_step step{{Clean_step::CHANNELS}};
  Removal_answer answer = remove_channels(mesh, pairs, most, options, progress);
  const std::size_t number = number_of_channels(answer.report);
  if(number > 0 && options.has(Clean_step::SHELLS) && !options.channel_length && !options.is_sure)
    if(const Volume_change change = change_by(mesh, answer); change.is_large()) {
      step.record.left = {
          words_of_channels(answer.report) + ": filling the hollow would change " + change.words() +
          formatted("; use --channels %.3g%% to do it", 100. * most / diagonal_of(mesh))};
      return step;
    }
  step.record.count = number;
  if(number > 0) {
    step.record.done = {"closed " + words_of_channels(answer.report)};
    step.answer = std::move(answer);
    return step;
  }
  if(const std::string words = words_of_wider_channels(mesh, pairs, most, options, progress);
     !words.empty())
    step.record.left = {words};
  if(const std::size_t refused = answer.report.refused.size() + answer.report.refused_necks.size();
     refused > 0)
    step.record.left.push_back(
        counted(refused, "short hole", "short holes") +
        " cannot be filled: it is undecided whether they lead to an inner wall");
  return step;
}

Handle_step remove_small_handles(const Mesh& mesh,
                                 const Pairs& pairs,
                                 double diagonal,
                                 const Clean_options& options,
                                 Progress& progress) {
  Handle_step step{{Clean_step::HANDLES}};
  const auto& noise_below = options.noise_below;
  if(!noise_below && !options.genus && !pairs.empty())
    step.record.left = {words_of_left(mesh, pairs)};
  if(pairs.size() < options.genus.value_or(0))
    step.record.left = {counted(pairs.size(), "handle", "handles") + ", fewer than --genus " +
                        std::to_string(*options.genus)};
  if(pairs.size() <= options.genus.value_or(0) || !(noise_below || options.genus))
    return step;
  Removal_options wanted;
  wanted.number_of_threads = options.number_of_threads;
  if(options.genus)
    wanted.target_genus = *options.genus;
  if(noise_below)
    wanted.pairs = pairs_of_noise(mesh, pairs, diagonal, options, step.record, progress);
  Removal_answer answer = remove_handles(mesh, pairs, wanted, progress);
  step.record.count = answer.report.removed.size();
  if(step.record.count > 0)
    step.record.done = {"removed " + counted(step.record.count, "handle", "handles") + ", genus " +
                        std::to_string(answer.report.genus_before) + " -> " +
                        std::to_string(answer.report.genus_after)};
  for(const Refused_handle& refused : answer.report.refused)
    step.record.left.push_back(formatted("a handle with a loop of length %.4g: ", refused.length) +
                               refused.reason);
  if(step.record.count > 0)
    step.answer = std::move(answer);
  return step;
}

} // namespace htloops
