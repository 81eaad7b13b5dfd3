// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_REMOVAL_TARGETS_H
#define BENCHMARK_REMOVAL_TARGETS_H

#include "Removal_judge.h"

#include <cstdio>
#include <functional>
#include <string>

/// \file Removal_targets.h
/// What is aimed at in the removal of handles, and what has been reached.

namespace judge {

/// A number for each of many handles or meshes, and where it is largest.
class Measured
{
public:
  void add(const std::string& place, double value) { values_.emplace_back(value, place); }

  std::size_t size() const { return values_.size(); }

  std::size_t number_above(double limit) const {
    return std::size_t(std::count_if(values_.begin(), values_.end(),
                                     [&](const auto& entry) { return entry.first > limit; }));
  }

  double percentage_within(double limit) const {
    return values_.empty() ? 100. : 100. - 100. * double(number_above(limit)) / double(size());
  }

  /// the value that a share of all does not exceed.
  double quantile(double share) const {
    if(values_.empty())
      return 0.;
    std::vector<double> sorted;
    for(const auto& [value, place] : values_)
      sorted.push_back(value);
    std::sort(sorted.begin(), sorted.end());
    return sorted[(std::min)(sorted.size() - 1, std::size_t(share * double(sorted.size())))];
  }

  void print_worst(const char* what, double limit, std::size_t most = 12) const {
    std::vector<std::pair<double, std::string>> worst = values_;
    std::sort(worst.begin(), worst.end(), std::greater<>());
    worst.resize((std::min)({worst.size(), most, number_above(limit)}));
    if(!worst.empty())
      std::printf("\n%s, the worst:\n", what);
    for(const auto& [value, place] : worst)
      std::printf("- %s: %.3g\n", place.c_str(), value);
  }

private:
  std::vector<std::pair<double, std::string>> values_;
};

/// Sums up what was measured, beside what is aimed at.
class Removal_targets
{
public:
  void add(const std::string& mesh, const Report& report, const Removal_judge& judge) {
    for(const auto& handle : report.refused)
      refused_.push_back(mesh + " pair " + std::to_string(handle.pair) + ": " +
                         handle.reason.substr(0, 200));
    double most = 0.;
    for(const Verdict& verdict : judge.verdicts()) {
      const std::string place = mesh + " pair " + std::to_string(verdict.pair) + name(verdict.way) +
                                (verdict.is_mixed ? ", beside others" : "");
      add_volumes(place, verdict, judge.volume());
      circles_.add(place, verdict.circles);
      folds_.add(place, verdict.fold);
      by_own_loops_.add(place, verdict.displacement / verdict.length);
      const double displacement = verdict.displacement / verdict.longest;
      (verdict.is_mixed ? displacements_beside_ : displacements_of_handles_)
          .add(place, displacement);
      if(!verdict.is_mixed)
        most = (std::max)(most, displacement);
    }
    if(!judge.verdicts().empty())
      displacements_.add(mesh, most);
    if(judge.unclear_volume() > 1e-9 * judge.volume())
      unclear_.add(mesh, judge.unclear_volume() / judge.volume());
    lines_.add(mesh, judge.largest_error_of_lines() / judge.volume());
  }

  static void print_head() {
    std::printf("| mesh | faces | removed | refused | wrong volumes: net, in part, beside others | "
                "most circles | largest new fold | flush fills | displacement |");
  }

  static void print_row(const std::string& mesh,
                        std::size_t faces,
                        const Report& report,
                        const Removal_judge& judge) {
    Removal_targets own;
    own.add(mesh, report, judge);
    const auto& verdicts = judge.verdicts();
    std::printf("| %s | %zu | %zu | %zu | %zu, %zu, %zu | %.2f | %.0f | %zu | %.3f |", mesh.c_str(),
                faces, verdicts.size(), report.refused.size(), own.net_.number_above(1e-9),
                own.gross_.number_above(1e-9), own.mixed_.number_above(1e-9),
                own.circles_.quantile(1.), own.folds_.quantile(1.),
                std::size_t(std::count_if(verdicts.begin(), verdicts.end(),
                                          [](const Verdict& v) { return v.is_flush_fill(); })),
                own.displacements_.quantile(1.));
  }

  void add_times(const std::string& mesh, double ratio) { times_.add(mesh, ratio); }

  /// of the default over the best single way.
  void
  add_ratio(const std::string& place, double ratio, bool is_flush_fill, bool is_nearly_flush_fill) {
    ratios_.add(place, ratio);
    if(!is_flush_fill)
      ratios_not_flush_.add(place, ratio);
    if(!is_nearly_flush_fill)
      ratios_of_others_.add(place, ratio);
  }

  void print() const {
    std::printf("\n| | aim | reached |\n|---|---|---|\n");
    print_volumes();
    print_surfaces();
    if(times_.size() != 0)
      std::printf("| removing / loops: median, 90%%, most, meshes within 3 | - | %.2f, "
                  "%.2f, %.2f, %.1f%% |\n",
                  times_.quantile(0.5), times_.quantile(0.9), times_.quantile(1.),
                  times_.percentage_within(3.));
    print_ratios();
    print_worst();
  }

private:
  static const char* name(Way way) {
    return way == Way::CUT ? " (cut)" : way == Way::FILL ? " (filled)" : " (whole)";
  }

  void add_volumes(const std::string& place, const Verdict& verdict, double volume) {
    const bool is_wrong = verdict.wrong_net() > 1e-9 * volume;
    if(verdict.is_mixed)
      mixed_.add(place, (std::max)(verdict.wrong_net(), verdict.wrong_gross()) / volume);
    else if(is_wrong)
      net_.add(place, verdict.wrong_net() / volume);
    else
      gross_.add(place, verdict.wrong_gross() / volume);
  }

  void print_volumes() const {
    std::printf("| handles refused | at most 10 | %zu of %zu |\n", refused_.size(),
                refused_.size() + circles_.size());
    std::printf("| fills that take solid away, cuts that add some, beyond 1e-9 of the volume | 0 | "
                "%zu |\n| the same in part, while the sum is right | 0 | %zu |\n"
                "| the same where handles beside were removed in other ways | 0 | %zu of %zu |\n"
                "| meshes with volume that is of no single handle | - | %zu |\n",
                net_.number_above(1e-9), gross_.number_above(1e-9), mixed_.number_above(1e-9),
                mixed_.size(), unclear_.size());
  }

  void print_surfaces() const {
    std::printf("| single caps of over 3 circles | 0 | %zu (most %.2f) |\n"
                "| new folds above 150 degrees | 0 | %zu (most %.1f, above 120: %zu) |\n",
                circles_.number_above(3.), circles_.quantile(1.), folds_.number_above(150.),
                folds_.quantile(1.), folds_.number_above(120.));
    std::printf("| largest displacement in lengths of the loop: median over meshes, 90%%, most | "
                "0.18, -, 0.5 | %.3f, %.3f, %.3f |\n",
                displacements_.quantile(0.5), displacements_.quantile(0.9),
                displacements_.quantile(1.));
    std::printf("| handles beside which others were removed in other ways, displaced by over 0.5 | "
                "0 | %zu (most %.3f) |\n"
                "| handles displaced by over half the loop that they were removed along, not the "
                "longer one if whole | - | %zu (most %.3f) |\n",
                displacements_beside_.number_above(0.5), displacements_beside_.quantile(1.),
                by_own_loops_.number_above(0.5), by_own_loops_.quantile(1.));
  }

  void print_ratios() const {
    if(ratios_.size() == 0)
      return;
    std::printf("| change of volume by default at most 1.1 times the best single way | 95%% | "
                "%.1f%% of %zu |\n",
                ratios_.percentage_within(1.1), ratios_.size());
    std::printf("| the same without bores that are closed flush | 95%% | %.1f%% of %zu |\n",
                ratios_not_flush_.percentage_within(1.1), ratios_not_flush_.size());
    std::printf("| the same without those that are closed nearly flush | 95%% | %.1f%% of %zu |\n",
                ratios_of_others_.percentage_within(1.1), ratios_of_others_.size());
  }

  void print_worst() const {
    std::printf("\nrefused:\n");
    for(const std::string& handle : refused_)
      std::printf("- %s\n", handle.c_str());
    net_.print_worst("wrong volume over all", 1e-9, 100);
    gross_.print_worst("wrong volume in part, over all", 1e-9, 30);
    mixed_.print_worst("wrong volume beside other ways, over all", 1e-9, 30);
    unclear_.print_worst("volume of no single handle, over all", 1e-9);
    lines_.print_worst("errors of volumes along lines, over all", 1e-5);
    circles_.print_worst("caps in circles", 2.);
    folds_.print_worst("new folds in degrees", 120., 30);
    displacements_of_handles_.print_worst("displacement in lengths of the loop", 0.25, 30);
    displacements_beside_.print_worst("displacement beside others, in lengths of the loop", 0.5,
                                      30);
    by_own_loops_.print_worst("displacement in lengths of the loop removed along", 0.5, 30);
    times_.print_worst("removing / loops", 3., 30);
    ratios_of_others_.print_worst("default over the best single way, not nearly flush", 1.1, 60);
    ratios_.print_worst("default over the best single way", 1.1, 30);
  }

  std::vector<std::string> refused_;
  Measured net_, gross_, mixed_, unclear_, lines_, circles_, folds_, displacements_,
      displacements_of_handles_, displacements_beside_, by_own_loops_, times_, ratios_,
      ratios_not_flush_, ratios_of_others_;
};

} // namespace judge

#endif // BENCHMARK_REMOVAL_TARGETS_H
