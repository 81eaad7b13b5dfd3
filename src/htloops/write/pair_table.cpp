// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/pair_table.h"

#include "words.h"
#include "write/linking_words.h"
#include "write/loop_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace htloops {
namespace {

std::string in_colour(const std::string& text, CGAL::Loop_type type, bool use_colour) {
  if(!use_colour)
    return text;
  const auto [red, green, blue] = colour_of(type);
  return formatted("\033[38;2;%d;%d;%dm", red, green, blue) + text + "\033[0m";
}

// Texts in columns; those that tell of a kind of loops in its colour.
std::string row(const std::vector<std::string>& cells, bool use_colour) {
  std::string line;
  for(std::size_t i = 0; i < cells.size(); ++i) {
    const std::string cell = padded(pair_columns[i], cells[i]);
    line += i == 0 ? "" : "  ";
    line += i == 1   ? in_colour(cell, CGAL::Loop_type::HANDLE, use_colour)
            : i == 2 ? in_colour(cell, CGAL::Loop_type::TUNNEL, use_colour)
                     : cell;
  }
  return line + "\n";
}

std::string header(bool use_colour) {
  std::vector<std::string> names;
  for(const Table_column& column : pair_columns)
    names.push_back(column.name);
  return row(names, use_colour);
}

double total_length(const Pairs& pairs, CGAL::Loop_type type) {
  double sum = 0.;
  for(const Pair& pair : pairs)
    sum += pair.loop(type).length();
  return sum;
}

// Where a mesh is coarser than the paper takes for granted; only the reference solver looks for it.
std::string remarks(const CGAL::Handle_tunnel_loops::Field_resolution& resolution) {
  if(resolution.is_resolved())
    return "";
  std::string text = "the mesh is coarse for the field:";
  const char* separator = " ";
  const auto append = [&](std::size_t number, const char* one, const char* many) {
    if(number == 0)
      return;
    text += separator + counted(number, one, many);
    separator = ", ";
  };
  append(resolution.handles_within_steps, "handle passed in one step",
         "handles passed in one step");
  append(resolution.rests, "rest", "rests");
  append(resolution.early_vertices, "vertex reached ahead of the front",
         "vertices reached ahead of the front");
  append(resolution.events_in_seed_region, "event beside the seed", "events beside the seed");
  return text + "\n";
}

// Why loops do not bound on their sides, where that was wanted.
std::string reasons(const Answer& answer, bool show_all) {
  if(answer.certificate.basis_kind != CGAL::Handle_tunnel_loops::Basis_kind::PURE)
    return "";
  const std::vector<std::string> lines = remarks_on_sides(answer.certificate);
  constexpr std::size_t most_lines = 5;
  const std::size_t shown = show_all ? lines.size() : (std::min)(lines.size(), most_lines);
  std::string text;
  for(std::size_t i = 0; i < shown; ++i)
    text += "  " + lines[i] + "\n";
  if(shown < lines.size())
    text += "  ... " + std::to_string(lines.size() - shown) + " more (--all shows them)\n";
  return text;
}

// What is nothing but rounding beside the extent of a box is 0.
std::array<double, 3> without_rounding(const std::array<double, 3>& numbers, double extent) {
  std::array<double, 3> result = numbers;
  for(double& x : result)
    if(std::abs(x) < 1e-9 * extent)
      x = 0.;
  return result;
}

} // namespace

std::vector<std::string> cells_of(const Listed_pair& pair) {
  const CGAL::Bbox_3& box = pair.box;
  const std::array<double, 3> extents = {box.max(0) - box.min(0), box.max(1) - box.min(1),
                                         box.max(2) - box.min(2)};
  const double extent = *std::max_element(extents.begin(), extents.end());
  const auto [x, y, z] =
      without_rounding({pair.centre.x(), pair.centre.y(), pair.centre.z()}, extent);
  const auto [width, depth, height] = without_rounding(extents, extent);
  return {std::to_string(pair.pair),
          formatted("%.6g", pair.handle_length),
          formatted("%.6g", pair.tunnel_length),
          formatted("%.3g%%", 100. * pair.size),
          formatted("(%.4g, %.4g, %.4g)", x, y, z),
          formatted("%.3g x %.3g x %.3g", width, depth, height)};
}

std::string table_of_pairs(const Pair_listing& listing, const Table_options& options) {
  if(listing.empty())
    return "";
  return header(options.use_colour) +
         table_rows(listing.size(), options.show_all,
                    [&](std::size_t i) { return row(cells_of(listing[i]), options.use_colour); });
}

std::string summary(const Answer& answer, double read_seconds, const Table_options& options) {
  const auto& statistics = answer.statistics;
  std::string text = "genus " + std::to_string(statistics.genus) + " in " +
                     counted(statistics.number_of_components, "component", "components");
  const bool has_boundary = statistics.number_of_boundaries > 0;
  if(has_boundary)
    text += ", " + counted(statistics.number_of_boundaries, "boundary curve", "boundary curves");
  text += ": ";
  if(answer.pairs.empty())
    text += has_boundary ? "no pairs; the boundary curves but one of each component are a basis of "
                           "H1(S; Z)\n"
                         : "no loops\n";
  else
    text += counted(answer.pairs.size(), "pair", "pairs") +
            " of loops, certified as a basis of H1(S; Z)" +
            (has_boundary ? " with the boundary curves but one of each component\n" : "\n") +
            formatted("total length %.6g of the handles, %.6g of the tunnels\n",
                      total_length(answer.pairs, CGAL::Loop_type::HANDLE),
                      total_length(answer.pairs, CGAL::Loop_type::TUNNEL));
  const std::string sides = summary_of_sides(answer.certificate);
  if(!sides.empty())
    text += sides + "\n" + reasons(answer, options.show_all);
  return text + remarks(statistics.resolution) +
         formatted("%.2f s after %.2f s of reading, backend %s, ", answer.total_seconds,
                   read_seconds, answer.backend.c_str()) +
         counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") + "\n" +
         (options.is_verbose && !statistics.fallback.empty()
              ? "no device was used: " + statistics.fallback + "\n"
              : "");
}

} // namespace htloops
