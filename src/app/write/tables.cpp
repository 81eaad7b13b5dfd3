// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/tables.h"

#include "words.h"
#include "write/files.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>

namespace htloops {
namespace {

std::string name_of_loop(std::size_t loop) {
  return "pair " + std::to_string(loop / 2) + (loop % 2 == 0 ? ", handle" : ", tunnel");
}

// "2 with pair 0, handle; -1 with itself"
std::string words(const std::vector<Loop_linking::Number>& numbers, std::size_t loop) {
  constexpr std::size_t largest_number_of_numbers = 4;
  std::string text;
  for(std::size_t i = 0; i < numbers.size() && i < largest_number_of_numbers; ++i)
    text += (text.empty() ? "" : "; ") + std::to_string(numbers[i].second) + " with " +
            (numbers[i].first == loop ? "itself" : name_of_loop(numbers[i].first));
  return text + (numbers.size() > largest_number_of_numbers ? "; ..." : "");
}

/// By two components, how often which of their loops are linked.
using Component_links =
    std::map<std::array<std::size_t, 2>, std::map<std::array<std::size_t, 2>, std::int64_t>>;

// Loops of different components have one linking number, whichever is pushed.
void add_links(std::size_t loop,
               const Loop_linking& linking,
               const std::vector<std::size_t>& components,
               Component_links& links) {
  for(const auto& [other, number] : linking.row) {
    const std::size_t i = (std::min)(loop, other), j = (std::max)(loop, other);
    const auto [first, last] = std::minmax(components[i / 2], components[j / 2]);
    if(first != last)
      links[{first, last}][{i, j}] = std::abs(number);
  }
}

// "components 0 and 1 are linked once (pair 0, tunnel, with pair 1, tunnel)"
std::vector<std::string> lines_of_links(const Component_links& links) {
  constexpr std::size_t most_loops = 4;
  std::vector<std::string> lines;
  for(const auto& [both, numbers] : links) {
    std::string line = "components " + std::to_string(both[0]) + " and " + std::to_string(both[1]) +
                       " are linked ";
    std::size_t count = 0;
    for(const auto& [loops, number] : numbers) {
      if(count == most_loops) {
        line +=
            ", and by " + counted(numbers.size() - count, "more pair", "more pairs") + " of loops";
        break;
      }
      line += (count++ == 0 ? "" : ", ") +
              (number == 1   ? std::string("once")
               : number == 2 ? std::string("twice")
                             : std::to_string(number) + " times") +
              " (" + name_of_loop(loops[0]) + ", with " + name_of_loop(loops[1]) + ")";
    }
    lines.push_back(line);
  }
  return lines;
}

std::string in_colour(const std::string& text, Loop_type type) {
  const auto [red, green, blue] = colour_of(type);
  return formatted("\033[38;2;%d;%d;%dm", red, green, blue) + text + "\033[0m";
}

// As wide as the column is.
std::string padded(const Table_column& column, const std::string& cell) {
  return formatted("%*s", column.is_number ? column.width : -column.width, cell.c_str());
}

// Texts in columns; those that tell of a kind of loops in its colour.
template <typename Columns>
std::string
row(const Columns& columns, const std::vector<std::string>& cells, bool use_colour = false) {
  std::string line;
  for(std::size_t i = 0; i < cells.size(); ++i) {
    const std::string cell = padded(columns[i], cells[i]);
    line += i == 0 ? "" : "  ";
    line += use_colour && columns[i].kind ? in_colour(cell, *columns[i].kind) : cell;
  }
  return line + "\n";
}

// The rows that `row(i)` makes; of a long table only the first and the last ones, unless all are to
// be shown.
template <typename Row> std::string table_rows(std::size_t count, bool show_all, Row row) {
  constexpr std::size_t longest_whole_table = 40;
  constexpr std::size_t first_rows = 20;
  constexpr std::size_t last_rows = 5;
  const bool is_whole = show_all || count <= longest_whole_table;
  std::string rows;
  for(std::size_t i = 0; i < count; ++i) {
    if(!is_whole && i == first_rows) {
      i = count - last_rows;
      rows += "  ... " + std::to_string(i - first_rows) + " more (--all-rows shows them)\n";
    }
    rows += row(i);
  }
  return rows;
}

template <typename Columns> std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for(const Table_column& column : columns)
    names.push_back(column.name);
  return names;
}

// A table of which `cells(i)` are the rows; nothing if there are none.
template <typename Columns, typename Cells>
std::string
table(const Columns& columns, std::size_t count, const Table_options& options, Cells cells) {
  if(count == 0)
    return "";
  return row(columns, names_of(columns), options.use_colour) +
         table_rows(count, options.show_all,
                    [&](std::size_t i) { return row(columns, cells(i), options.use_colour); });
}

double total_length(const Pairs& pairs, Loop_type type) {
  double sum = 0.;
  for(const Pair& pair : pairs)
    sum += pair.loop(type).length();
  return sum;
}

// Where a mesh is coarser than the paper takes for granted; only the reference solver looks for it.
std::string remarks(const CGAL::Handle_tunnel_loops::Field_resolution& resolution) {
  if(resolution.is_resolved())
    return "";
  std::string text;
  for(const auto& [number, one, many] :
      {std::tuple(resolution.handles_within_steps, "handle passed in one step",
                  "handles passed in one step"),
       std::tuple(resolution.rests, "rest", "rests"),
       std::tuple(resolution.early_vertices, "vertex reached ahead of the front",
                  "vertices reached ahead of the front"),
       std::tuple(resolution.events_in_seed_region, "event next to the seed",
                  "events next to the seed")})
    if(number > 0)
      text += (text.empty() ? " " : ", ") + counted(number, one, many);
  return "the mesh is coarse for the field:" + text + "\n";
}

// Why loops do not bound on their sides, where that was wanted.
std::string reasons(const Answer& answer, bool show_all) {
  if(answer.certificate.basis_kind != Basis_kind::PURE)
    return "";
  const std::vector<std::string> lines = remarks_on_sides(answer.certificate, answer.components);
  constexpr std::size_t most_lines = 5;
  const std::size_t shown = show_all ? lines.size() : (std::min)(lines.size(), most_lines);
  std::string text;
  for(std::size_t i = 0; i < shown; ++i)
    text += "  " + lines[i] + "\n";
  if(shown < lines.size())
    text += "  ... " + std::to_string(lines.size() - shown) + " more (--all-rows shows them)\n";
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

// What it is, with the axis of space that a bore is along, up to a quarter of a degree.
std::string words_of(const Listed_hole& hole) {
  constexpr double cosine = 0.99999;
  if(!hole.bore)
    return hole.word();
  for(int i = 0; i < 3; ++i)
    if(std::abs(hole.bore->axis[i]) > cosine)
      return hole.word() + std::string(" along ") + "xyz"[i];
  return hole.word() + std::string(", oblique");
}

// How far it is from a cylinder, or the loop around it from a circle.
std::string off_round(const Listed_hole& hole) {
  return hole.bore ? formatted("%.2g", hole.bore->deviation)
                   : formatted("%.2g%%", 100. * hole.out_of_roundness);
}

std::string centre_of(const Loop& curve) {
  const Point p = middle_of(CGAL::bbox_3(curve.points().begin(), curve.points().end()));
  return formatted("(%.4g, %.4g, %.4g)", p.x(), p.y(), p.z());
}

std::string name_of_node(const Reeb_answer& answer, std::size_t node) {
  return name_of(answer.graph[node].type) + (" " + std::to_string(node));
}

std::string name_of_node(const Skeleton_answer& answer, std::size_t point) {
  return name_of_point(answer.graph, point) + (" " + std::to_string(point));
}

// How many points of each kind there are that are no bends.
std::string words_of_nodes(const Skeleton_graph& graph) {
  std::map<std::string, std::size_t> count;
  for(const auto v : CGAL::make_range(vertices(graph)))
    ++count[name_of_point(graph, v)];
  std::string text;
  for(const auto& [one, many] :
      {std::pair("joint", "joints"), std::pair("end", "ends"), std::pair("inlet", "inlets")})
    if(count[one] > 0)
      text += ", " + counted(count[one], one, many);
  return text;
}

std::string words_of_proof(const Skeleton_answer& answer) {
  const std::size_t edges = num_edges(answer.graph), cycles = number_of_cycles(answer.graph);
  if(edges == 0)
    return "certified: no edges, and no cycles, as there are no handles\n";
  return "certified: " +
         (edges == 1
              ? "the only edge lies inside"
              : "all " + std::to_string(edges) + " edges lie inside and meet only at common ends") +
         "; " +
         (cycles == 0 ? "no cycles, as there are no handles\n"
          : cycles == 1
              ? "the cycle is a basis of H1 of the solid\n"
              : "the " + std::to_string(cycles) + " cycles are a basis of H1 of the solid\n");
}

// What has been proved, or why it has not.
std::string words_of_certificate(const Skeleton_answer& answer) {
  std::string text = answer.certificate().taken_alone;
  if(!text.empty())
    text += "\n";
  if(answer.certificate())
    return text + words_of_proof(answer);
  constexpr std::size_t most_lines = 5;
  const std::vector<std::string> failures = lines_of(answer.certificate().failure);
  text += "not certified:\n";
  for(std::size_t i = 0; i < (std::min)(failures.size(), most_lines); ++i)
    text += "  " + failures[i] + "\n";
  if(failures.size() > most_lines)
    text += "  ... " + std::to_string(failures.size() - most_lines) + " more\n";
  const std::size_t edges = num_edges(answer.graph);
  if(edges == 0)
    return text;
  return text + std::to_string(edges - answer.certificate().edges_outside.size()) + " of " +
         counted(edges, "edge lies", "edges lie") + " inside\n";
}

std::string row(const Refused_handle& handle, const std::string& name) {
  return padded(removal_columns[0], name) + formatted("  refused  %12.6g  ", handle.length) +
         handle.reason + "\n";
}

// First the handles, then the necks, each in words.
template <typename Handle, typename Words>
std::string rows(const std::vector<Handle>& handles,
                 const std::vector<Handle>& necks,
                 bool show_all,
                 const Words& words) {
  return table_rows(
             handles.size(), show_all,
             [&](std::size_t i) { return words(handles[i], std::to_string(handles[i].pair)); }) +
         table_rows(necks.size(), show_all, [&](std::size_t i) { return words(necks[i], "neck"); });
}

// "30 cut, 13 filled"
std::string list_of_ways(const std::vector<Removed_handle>& handles) {
  constexpr std::pair<std::string_view, const char*> participles[] = {
      {"cut", "cut"}, {"fill", "filled"}, {"out", "taken out"}, {"plug", "plugged"}};
  std::string list;
  for(const auto& [name, participle] : participles) {
    const auto count = std::count_if(handles.begin(), handles.end(),
                                     [&name = name](const auto& h) { return name_of(h) == name; });
    if(count > 0)
      list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + participle;
  }
  return list;
}

} // namespace

std::string
table_of_changes(const std::string& file, const std::vector<Change>& changes, bool is_dry_run) {
  if(changes.empty())
    return "htloops: " + file + (is_dry_run ? " needs" : " needed") + " no repair\n";
  std::string table = "htloops: " + file + (is_dry_run ? " would be" : " was") + " repaired:\n";
  for(const Change& change : changes)
    table += formatted("%9zu  ", change.count) + change.words + "\n";
  return table;
}

const char* word_for_side(const Loop_linking& linking) {
  return !linking.problem.empty()   ? "undecided"
         : linking.bounds_inside()  ? "inside"
         : linking.bounds_outside() ? "outside"
                                    : "neither";
}

const char* word_for_side_alone(const Loop_linking& linking) {
  return !linking.problem.empty()           ? "undecided"
         : linking.bounds_inside_component  ? "inside"
         : linking.bounds_outside_component ? "outside"
                                            : "neither";
}

std::string summary_of_sides(const Certificate& certificate) {
  const std::size_t pairs = certificate.linking.size() / 2;
  if(pairs == 0)
    return "";
  const std::size_t handles = *certificate.handles_bound_inside,
                    tunnels = *certificate.tunnels_bound_outside,
                    handles_alone = certificate.handles_bound_inside_alone.value_or(handles),
                    tunnels_alone = certificate.tunnels_bound_outside_alone.value_or(tunnels);
  return std::to_string(handles) + " of " +
         counted(pairs, "handle loop bounds", "handle loops bound") + " inside, " +
         std::to_string(tunnels) + " of " + counted(pairs, "tunnel loop", "tunnel loops") +
         " outside" +
         (handles_alone == handles && tunnels_alone == tunnels
              ? ""
              : "; within each component " + std::to_string(handles_alone) + " and " +
                    std::to_string(tunnels_alone));
}

std::vector<std::string> remarks_on_sides(const Certificate& certificate,
                                          const std::vector<std::size_t>& components) {
  Component_links links;
  std::vector<std::string> lines;
  for(std::size_t i = 0; i < certificate.linking.size(); ++i) {
    const Loop_linking& linking = certificate.linking[i];
    if(!linking.problem.empty())
      lines.push_back(name_of_loop(i) + ": undecided, " + linking.problem);
    else if(linking.bounds_inside() || linking.bounds_outside())
      continue;
    else if(!components.empty() &&
            (linking.bounds_inside_component || linking.bounds_outside_component))
      add_links(i, linking, components, links);
    else
      lines.push_back(
          name_of_loop(i) +
          ": bounds on neither side; its linking numbers with loops pushed outward are (" +
          words(linking.row, i) + "), those of loops with it pushed outward are (" +
          words(linking.column, i) + ")");
  }
  std::vector<std::string> all = lines_of_links(links);
  all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

Pair_columns::Pair_columns(const Pair_listing& listing)
    : measures(has_measures(listing))
    , costs(!listing.empty() && listing.front().costs.has_value()) {}

namespace {

constexpr Table_column pair_columns[] = {
    {"pair", 5, true, {}, "The number of the pair of loops"},
    {"handle", 12, true, Loop_type::HANDLE, "The length of the handle loop, around the handle"},
    {"tunnel", 12, true, Loop_type::TUNNEL, "The length of the tunnel loop, through the hole"},
    {"size",
     8,
     true,
     {},
     "The length of the shorter loop, as a fraction of the diagonal of the bounding box of the "
     "mesh"},
    {"diameter",
     10,
     true,
     {},
     "The diameter of the round bore; otherwise that of the circle that fits the tunnel loop best"},
    {"of", 14, false, {}, "What the diameter measures: a bore, with its axis, or another hole"},
    {"off round",
     9,
     true,
     {},
     "Of a bore, the largest deviation of its wall from a cylinder; of another hole, the largest "
     "radius of its tunnel loop less the smallest one, over the diameter"},
    {"depth", 8, true, {}, "The length of the bore along its axis"},
    {"wall",
     10,
     true,
     {},
     "The diameter of a circle as long as the handle loop, which goes around the wall beside the "
     "hole"}};

constexpr Table_column measure_columns[] = {
    {"thickness",
     14,
     true,
     {},
     "The diameter of the largest ball that can move around the handle inside the solid"},
    {"clear width",
     14,
     true,
     {},
     "The diameter of the largest ball that can pass through the hole"}};

constexpr Table_column cost_columns[] = {
    {"cut area", 10, true, {}, "The area of new faces, if the handle is cut"},
    {"cut removes", 11, true, {}, "The volume of the solid that a cut of the handle removes"},
    {"fill area", 10, true, {}, "The area of new faces, if the hole is filled"},
    {"fill adds", 10, true, {}, "The volume that filling the hole adds to the solid"}};

constexpr Table_column place_columns[] = {
    {"center",
     34,
     false,
     {},
     "Of a bore, on its axis, in the middle; otherwise of the bounding box of the shorter loop"},
    {"bounding box",
     0,
     false,
     {},
     "The extents of the bounding box of the shorter loop along x, y and z"}};

} // namespace

std::vector<Table_column> columns_of(const Pair_columns& wanted) {
  std::vector<Table_column> columns(std::begin(pair_columns), std::end(pair_columns));
  if(wanted.measures)
    columns.insert(columns.end(), std::begin(measure_columns), std::end(measure_columns));
  if(wanted.costs)
    columns.insert(columns.end(), std::begin(cost_columns), std::end(cost_columns));
  columns.insert(columns.end(), std::begin(place_columns), std::end(place_columns));
  return columns;
}

bool has_measures(const Pair_listing& listing) {
  return std::any_of(listing.begin(), listing.end(),
                     [](const Listed_pair& pair) { return pair.measure.has_value(); });
}

void add_costs(const std::optional<Costs::value_type>& costs, std::vector<std::string>& cells) {
  const auto add = [&](std::optional<Removed_handle> Costs::value_type::*way, double sign) {
    const bool is_known = costs && (*costs).*way;
    cells.push_back(is_known ? formatted("%.4g", ((*costs).*way)->area) : "");
    cells.push_back(is_known ? formatted("%.4g", 0. + sign * ((*costs).*way)->volume) : "");
  };
  add(&Costs::value_type::cut, 1.);
  add(&Costs::value_type::fill, -1.); // which puts in, and does not take away
}

std::vector<std::string> cells_of(const Listed_pair& pair, const Pair_columns& wanted) {
  const CGAL::Bbox_3& box = pair.box;
  const std::array<double, 3> extents = {box.max(0) - box.min(0), box.max(1) - box.min(1),
                                         box.max(2) - box.min(2)};
  const double extent = *std::max_element(extents.begin(), extents.end());
  const auto [x, y, z] =
      without_rounding({pair.centre.x(), pair.centre.y(), pair.centre.z()}, extent);
  const auto [width, depth, height] = without_rounding(extents, extent);
  std::vector<std::string> cells = {std::to_string(pair.pair),
                                    formatted("%.6g", pair.handle_length),
                                    formatted("%.6g", pair.tunnel_length),
                                    formatted("%.3g%%", 100. * pair.size),
                                    formatted("%.6g", pair.hole.diameter),
                                    words_of(pair.hole),
                                    off_round(pair.hole),
                                    pair.hole.bore ? formatted("%.6g", pair.hole.bore->length) : "",
                                    formatted("%.6g", pair.hole.wall_diameter)};
  if(wanted.measures)
    for(const auto range : {&Listed_measure::thickness_range, &Listed_measure::clear_width_range})
      cells.push_back(pair.measure
                          ? words_of((*pair.measure).*range,
                                     [](double diameter) { return formatted("%.4g", diameter); })
                          : "");
  if(wanted.costs)
    add_costs(pair.costs, cells);
  cells.push_back(formatted("(%.4g, %.4g, %.4g)", x, y, z));
  cells.push_back(formatted("%.3g x %.3g x %.3g", width, depth, height));
  return cells;
}

std::string three_digits(double number) {
  constexpr double least = 1e-3, most = 1e6;
  if(!(number == 0. || (number >= least && number < most)))
    return formatted("%.3g", number);
  int digits = 2; // behind the point
  for(double power = 10.; digits > 0 && power <= number; power *= 10.)
    --digits;
  for(double power = 1.; number > 0. && power > number; power /= 10.)
    ++digits;
  return formatted("%.*f", digits, number);
}

// Where bores are in parts: those that are listed, each once.
std::string words_of_drillings(const Pair_listing& listing) {
  std::map<std::size_t, std::vector<std::string>> pairs; // by drilling
  for(const Listed_pair& pair : listing)
    if(const auto& bore = pair.hole.bore)
      pairs[bore->drilling].push_back(std::to_string(pair.pair));
  std::string parts;
  for(const auto& [drilling, numbers] : pairs)
    if(numbers.size() > 1)
      parts += (parts.empty() ? "" : "; ") + boost::algorithm::join(numbers, ", ");
  return parts.empty() ? ""
                       : counted(pairs.size(), "bore", "bores") +
                             ", some of which others cut into parts: pairs " + parts + "\n";
}

// The reasons, each once, with the number of pairs that it stands for.
std::string why_not_measured(const Pair_listing& listing) {
  std::map<std::string, std::size_t> count;
  for(const Listed_pair& pair : listing)
    if(pair.measure && !pair.measure->why.empty())
      ++count[pair.measure->why];
  std::string text;
  for(const auto& [why, number] : count)
    text += counted(number, "pair is", "pairs are") + " not measured: " + why + "\n";
  return text;
}

std::string table_of_pairs(const Pair_listing& listing, const Table_options& options) {
  const Pair_columns columns(listing);
  return table(columns_of(columns), listing.size(), options,
               [&](std::size_t i) { return cells_of(listing[i], columns); }) +
         words_of_drillings(listing) + why_not_measured(listing);
}

std::string words_of_unit(Unit unit) {
  return unit == Unit::NONE
             ? ""
             : "lengths in the unit of the file: " + std::string(words_of(unit).name) + "\n";
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
    text += has_boundary ? "no pairs; all boundary curves except one per component are a basis of "
                           "H1(S; Z)\n"
                         : "no loops\n";
  else
    text += counted(answer.pairs.size(), "pair", "pairs") +
            " of loops, certified as a basis of H1(S; Z)" +
            (has_boundary ? " with all boundary curves except one per component\n" : "\n") +
            formatted("total length %.6g of the handles, %.6g of the tunnels\n",
                      total_length(answer.pairs, Loop_type::HANDLE),
                      total_length(answer.pairs, Loop_type::TUNNEL));
  const std::string sides = summary_of_sides(answer.certificate);
  if(!sides.empty())
    text += sides + "\n" + reasons(answer, options.show_all);
  text += words_of_unit(answer.unit);
  if(statistics.was_ended_by_time)
    text += "the search for shorter loops stopped at its time budget\n";
  return text + remarks(statistics.resolution) +
         formatted("%.2f s after %.2f s of reading, backend %s, ", answer.total_seconds,
                   read_seconds, answer.backend.c_str()) +
         counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") + "\n" +
         (options.is_verbose && !statistics.fallback.empty()
              ? "no device was used: " + statistics.fallback + "\n"
              : "");
}

std::string table_of(const std::vector<Table_column>& columns,
                     const std::vector<std::vector<std::string>>& rows,
                     bool show_all) {
  return table(columns, rows.size(), {show_all}, [&](std::size_t i) { return rows[i]; });
}

std::string table_of_boundaries(const Boundaries& boundaries, bool show_all) {
  const std::vector<Loop>& curves = boundaries.curves;
  const bool has_waists = !boundaries.waists.empty();
  std::vector<Table_column> columns = {{"boundary", 8, true}, {"length", 12, true}};
  if(has_waists)
    columns.push_back({"waist", 12, true});
  columns.insert(columns.end(), {{"edges", 8, true}, {"center", 0, false}});
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_tuple(curves[a].length(), a) < std::make_tuple(curves[b].length(), b);
  });
  return table(columns, curves.size(), {show_all}, [&](std::size_t row) {
    const std::size_t i = order[row];
    std::vector<std::string> cells = {std::to_string(i), formatted("%.6g", curves[i].length())};
    const Loop* waist = boundaries.waist(i);
    if(has_waists)
      cells.push_back(waist ? formatted("%.6g", waist->length()) : "none");
    cells.insert(cells.end(), {std::to_string(curves[i].size()), centre_of(curves[i])});
    return cells;
  });
}

std::vector<Listed_arc> list_arcs(const Mesh& mesh, const Reeb_answer& answer) {
  const std::vector<double> girths = girths_of(mesh, answer);
  std::vector<Listed_arc> arcs;
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    arcs.push_back({arc.index, arc.length, girths[arc.index], arc.vertices.size(),
                    name_of_node(answer, source(e, answer.graph)),
                    name_of_node(answer, target(e, answer.graph))});
  }
  std::stable_sort(arcs.begin(), arcs.end(),
                   [](const Listed_arc& a, const Listed_arc& b) { return a.length > b.length; });
  return arcs;
}

std::vector<std::string> cells_of(const Listed_arc& arc) {
  return {std::to_string(arc.arc),
          formatted("%.6g", arc.length),
          arc.girth > 0. ? formatted("%.6g", arc.girth) : "",
          std::to_string(arc.number_of_vertices),
          arc.from,
          arc.to};
}

std::string table_of_arcs(const std::vector<Listed_arc>& arcs, bool show_all) {
  return table(arc_columns, arcs.size(), {show_all},
               [&](std::size_t i) { return cells_of(arcs[i]); });
}

void write_arc_csv(const std::string& target, const std::vector<Listed_arc>& arcs) {
  Text_writer out(target);
  out << "arc,length,girth,vertices,from,to\n";
  for(const Listed_arc& arc : arcs)
    out << arc.arc << ',' << arc.length << ',' << arc.girth << ',' << arc.number_of_vertices << ','
        << arc.from << ',' << arc.to << '\n';
  out.finish();
}

std::vector<std::size_t> arcs_by_length(const Skeleton_answer& answer) {
  std::vector<std::size_t> order(answer.arcs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&answer](std::size_t a, std::size_t b) {
    return answer.arcs[a].length > answer.arcs[b].length;
  });
  return order;
}

std::vector<std::string> cells_of(const Skeleton_answer& answer, std::size_t number) {
  const Skeleton_arc& arc = answer.arcs[number];
  const double chord = chord_of(answer.graph, arc);
  return {std::to_string(number),
          formatted("%.6g", arc.length),
          formatted("%.4g", arc.smallest_radius),
          formatted("%.4g", arc.mean_radius),
          chord > 0. ? formatted("%.3f", arc.length / chord) : "",
          arc.is_on_cycle ? "yes" : "",
          name_of_node(answer, arc.points.front()),
          name_of_node(answer, arc.points.back())};
}

std::string table_of_arcs(const Skeleton_answer& answer, bool show_all) {
  const std::vector<std::size_t> order = arcs_by_length(answer);
  return table(skeleton_columns, order.size(), {show_all},
               [&](std::size_t i) { return cells_of(answer, order[i]); });
}

std::string summary(const Skeleton_answer& answer, double read_seconds) {
  const auto& statistics = answer.statistics;
  std::string text = "genus " + std::to_string(statistics.genus) + " in " +
                     counted(statistics.number_of_components, "component", "components");
  if(statistics.number_of_boundaries > 0)
    text += ", " + counted(statistics.number_of_boundaries, "boundary curve", "boundary curves");
  text += ": " + counted(answer.arcs.size(), "arc", "arcs") + ", " +
          counted(number_of_cycles(answer.graph), "cycle", "cycles") +
          words_of_nodes(answer.graph) + "\n" + words_of_certificate(answer) +
          formatted("%.2f s (%.2f s for loops) after %.2f s of reading, ", answer.total_seconds,
                    answer.statistics.seconds_of_loops, read_seconds);
  return text + counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") +
         "\n";
}

void write_arc_csv(const std::string& target, const Skeleton_answer& answer) {
  Text_writer out(target);
  out << "arc,component,length,smallest_radius,mean_radius,tortuosity,on_cycle,"
         "from,from_kind,to,to_kind\n";
  for(std::size_t i = 0; i < answer.arcs.size(); ++i) {
    const Skeleton_arc& arc = answer.arcs[i];
    const double chord = chord_of(answer.graph, arc);
    out << i << ',' << arc.component << ',' << arc.length << ',' << arc.smallest_radius << ','
        << arc.mean_radius << ',';
    if(chord > 0.)
      out << arc.length / chord;
    out << ',' << (arc.is_on_cycle ? 1 : 0);
    for(const std::size_t end : {arc.points.front(), arc.points.back()})
      out << ',' << end << ',' << name_of_point(answer.graph, end);
    out << '\n';
  }
  out.finish();
}

const char* name_of(const Removed_handle& handle) {
  switch(handle.by) {
  case Removal_way::CUT:
    return "cut";
  case Removal_way::FILL:
    return "fill";
  default:
    return handle.volume < 0. ? "plug" : "out";
  }
}

namespace {

std::string volume_if_any(double volume) { return volume > 0. ? formatted("%.4g", volume) : ""; }

// What a person would want to look at.
std::string words_of_harm(const Shape_change& change, double diagonal) {
  constexpr double most_moved = 0.05; // of the diagonal: no noise is as large
  const bool is_sharp = change.has_sharp_edge();
  const bool is_moved = change.displacement > most_moved * diagonal;
  return (is_sharp ? formatted("sharp edge of %.0f degrees left", change.sharpest_angle) : "") +
         (is_sharp && is_moved ? ", " : "") +
         (is_moved ? formatted("moves the surface by %.2g%% of the diagonal",
                               100. * change.displacement / diagonal)
                   : "");
}

} // namespace

std::vector<std::string>
cells_of(const Removed_handle& handle, const std::string& name, double diagonal) {
  return {name,
          name_of(handle),
          formatted("%.6g", handle.length),
          formatted("%.4g", handle.area),
          volume_if_any(handle.change.volume_removed),
          volume_if_any(handle.change.volume_added),
          formatted("%.2f", handle.change.cap_ratio),
          formatted("%.2f", handle.length > 0. ? handle.change.displacement / handle.length : 0.),
          formatted("%.0f", handle.change.sharpest_angle),
          words_of_harm(handle.change, diagonal)};
}

std::string table_of_removals(const Removal_report& report, double diagonal, bool show_all) {
  bool has_notes = false;
  for(const auto* some : {&report.removed, &report.removed_necks})
    for(const Removed_handle& handle : *some)
      has_notes |= !words_of_harm(handle.change, diagonal).empty();
  const auto with_notes = [&](std::vector<std::string> cells) {
    if(!has_notes || cells.back().empty()) // lines end in no blanks
      cells.pop_back();
    return row(removal_columns, cells);
  };
  const std::string removed = rows(report.removed, report.removed_necks, show_all,
                                   [&](const Removed_handle& handle, const std::string& name) {
                                     return with_notes(cells_of(handle, name, diagonal));
                                   });
  const std::string refused =
      rows(report.refused, report.refused_necks, show_all,
           [](const Refused_handle& handle, const std::string& name) { return row(handle, name); });
  std::string table;
  if(!removed.empty())
    table += with_notes(names_of(removal_columns)) + removed;
  if(!refused.empty())
    table += " pair  result         length  why\n" + refused;
  return table;
}

std::string summary(const Removal_report& report, bool is_dry_run) {
  const std::string by = list_of_ways(report.removed);
  std::string text =
      "genus " + std::to_string(report.genus_before) + " -> " + std::to_string(report.genus_after) +
      ", " + std::to_string(report.removed.size()) +
      (is_dry_run ? " would be removed" : " removed") + (by.empty() ? "" : " (" + by + ")") + ", " +
      std::to_string(report.refused.size()) + " refused\n";
  if(!report.removed_necks.empty() || !report.refused_necks.empty())
    text += counted(report.components_before, "component", "components") + " -> " +
            std::to_string(report.components_after) + ", " +
            counted(report.removed_necks.size(), "neck", "necks") + " cut, " +
            std::to_string(report.refused_necks.size()) + " refused\n";
  if(const std::size_t crossings = report.change().crossings; crossings > 0)
    text += counted(crossings, "more pair of faces intersects", "more pairs of faces intersect") +
            " than before\n";
  return text;
}

} // namespace htloops
