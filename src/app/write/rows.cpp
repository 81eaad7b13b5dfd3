// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/rows.h"

#include "file_names.h"
#include "write/documents.h"
#include "write/tables.h"
#include "write/throat_tables.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

namespace htloops {
namespace {

void write_sides(Text& out, const Answer& answer, std::size_t pair) {
  const auto& linking = answer.certificate.linking;
  for(std::size_t loop = 2 * pair; loop < 2 * pair + 2; ++loop)
    out << ',' << (linking.empty() ? "" : word_for_side(linking[loop]));
}

// What tells a program for tables that a cell is a formula.
bool looks_like_formula(const std::string& cell) {
  return !cell.empty() && std::strchr("=+-@", cell.front()) != nullptr;
}

// The cells between the name of the mesh and the error are a comma each, and one more.
std::size_t columns_before_error(Row_kind kind) {
  const std::string header = kind == Row_kind::THROATS ? throat_header : pair_header;
  return static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
}

void write_pair_row(Text& out, const Mesh_line& line, const Listed_pair& pair) {
  out << as_cell(line.mesh_file) << ',' << pair.pair << ',' << pair.handle_length << ','
      << pair.tunnel_length << ',' << pair.size;
  write_sides(out, line.answer, pair.pair);
  out << ',' << pair.centre.x() << ',' << pair.centre.y() << ',' << pair.centre.z();
  for(int i = 0; i < 3; ++i)
    out << ',' << pair.box.min(i);
  for(int i = 0; i < 3; ++i)
    out << ',' << pair.box.max(i);
  const Listed_hole& hole = pair.hole;
  out << ',' << hole.diameter << ',' << hole.word();
  if(const auto& bore = hole.bore)
    out << ',' << bore->axis[0] << ',' << bore->axis[1] << ',' << bore->axis[2] << ','
        << bore->length << ',' << bore->deviation << ',';
  else
    out << ",,,,,," << hole.out_of_roundness;
  out << ',' << hole.wall_diameter << ',' << line.answer.statistics.genus << ',';
}

void write_ball(Text& out, const std::optional<Listed_ball>& ball) {
  if(!ball) {
    out << ",,,,,";
    return;
  }
  out << ',' << ball->diameter << ',' << ball->error;
  for(int i = 0; i < 3; ++i)
    out << ',' << ball->throat[i];
}

void write_measure(Text& out, const Listed_measure& measure) {
  write_ball(out, measure.thickness);
  write_ball(out, measure.clear_width);
  out << ',' << as_cell(measure.why);
}

bool has_measures(Row_kind kind) {
  return kind == Row_kind::MEASURED_PAIRS || kind == Row_kind::PAIRS_WITH_COSTS;
}

void write_way(Text& out, const std::optional<Removed_handle>& way, const std::string& why) {
  if(way)
    out << ',' << way->area << ',' << way->volume << ',';
  else
    out << ",,," << as_cell(why);
}

void write_removal(Text& out, const Listed_removal& removal) {
  if(removal.done)
    out << ',' << name_of(*removal.done) << ',' << removal.done->area << ',' << removal.done->volume
        << ',';
  else
    out << ",,,," << (removal.refused ? as_cell(removal.refused->reason) : "");
}

// The cells after those of all pairs, empty where nothing is known.
void write_rest(Text& out, Row_kind kind, Unit unit, const Listed_pair* pair) {
  if(has_measures(kind))
    write_measure(out, pair != nullptr && pair->measure ? *pair->measure : Listed_measure());
  if(kind == Row_kind::PAIRS_WITH_COSTS) {
    const auto costs = pair != nullptr && pair->costs ? *pair->costs : Costs::value_type();
    write_way(out, costs.cut, costs.why_no_cut);
    write_way(out, costs.fill, costs.why_no_fill);
  }
  if(kind == Row_kind::REMOVALS)
    write_removal(out, pair != nullptr && pair->removal ? *pair->removal : Listed_removal());
  out << ',' << words_of(unit).name << '\n';
}

Json json_of(const Listed_ball& ball) {
  return {{"diameter", ball.diameter},
          {"error", ball.error},
          {"throat", {ball.throat.x(), ball.throat.y(), ball.throat.z()}}};
}

void add_measure(Json& pair, const Listed_measure& measure) {
  if(measure.thickness)
    pair["thickness"] = json_of(*measure.thickness);
  if(measure.clear_width)
    pair["clear_width"] = json_of(*measure.clear_width);
  if(!measure.why.empty())
    pair["not_measured_because"] = measure.why;
}

Json json_of(const Mesh_line& line) {
  Json json = {{"mesh", as_utf8(line.mesh_file)}, {"exit", line.exit_code}};
  if(line.exit_code != 0) {
    json["error"] = line.error;
    return json;
  }
  const auto& statistics = line.answer.statistics;
  json["vertices"] = line.number_of_vertices;
  json["faces"] = line.number_of_faces;
  json["components"] = statistics.number_of_components;
  json["boundaries"] = statistics.number_of_boundaries;
  json["genus"] = statistics.genus;
  if(line.answer.unit != Unit::NONE)
    json["unit"] = words_of(line.answer.unit).name;
  const auto& certificate = line.answer.certificate;
  if(!certificate.linking.empty()) {
    json["handles_bound_inside"] = certificate.handles_bound_inside.value_or(0);
    json["tunnels_bound_outside"] = certificate.tunnels_bound_outside.value_or(0);
  }
  json["pairs"] = Json::array();
  for(const Listed_pair& pair : line.listing) {
    Json listed = {
        {"pair", pair.pair}, {"handle", pair.handle_length},   {"tunnel", pair.tunnel_length},
        {"size", pair.size}, {"diameter", pair.hole.diameter}, {"diameter_of", pair.hole.word()}};
    if(pair.measure)
      add_measure(listed, *pair.measure);
    if(pair.costs)
      add_costs(listed, *pair.costs);
    json["pairs"].push_back(std::move(listed));
  }
  json["boundary_lengths"] = Json::array();
  for(const Loop& curve : line.answer.boundaries.curves)
    json["boundary_lengths"].push_back(curve.length());
  json["ended_by_time"] = line.answer.statistics.was_ended_by_time;
  json["seconds"] = {{"read", line.read_seconds}, {"total", line.answer.total_seconds}};
  return json;
}

int width_of(const std::vector<std::string>& mesh_files) {
  std::size_t width = 4;
  for(const std::string& file : mesh_files)
    width = (std::max)(width, number_of_characters(printable(file)));
  return static_cast<int>((std::min)(width, std::size_t(48)));
}

std::string padded(const std::string& name, int width) {
  const std::size_t size = number_of_characters(name), wanted = static_cast<std::size_t>(width);
  return name + std::string(size < wanted ? wanted - size : 0, ' ');
}

// In words; a dash if there is none.
std::string least_diameter(const Pair_listing& listing, Range_of_diameters Listed_measure::*range) {
  std::optional<Range_of_diameters> least;
  for(const Listed_pair& pair : listing)
    if(pair.measure) {
      const auto& [low, high] = (*pair.measure).*range;
      least = least
                  ? Range_of_diameters{(std::min)(least->least, low), (std::min)(least->most, high)}
                  : Range_of_diameters{low, high};
    }
  const auto print = [](double diameter) { return formatted("%.3g", diameter); };
  return least ? words_of(*least, print) : "-";
}

} // namespace

std::string as_cell(const std::string& text) {
  std::string cell = printable(text);
  if(looks_like_formula(cell))
    cell.insert(cell.begin(), '\'');
  if(cell.find_first_of(",\"") == std::string::npos)
    return cell;
  return '"' + boost::algorithm::replace_all_copy(cell, "\"", "\"\"") + '"';
}

std::string header_of_rows(Row_kind kind) {
  return (kind == Row_kind::THROATS ? throat_header : pair_header) +
         std::string(has_measures(kind) ? measure_header : "") +
         (kind == Row_kind::PAIRS_WITH_COSTS ? cost_header : "") +
         (kind == Row_kind::REMOVALS ? removal_header : "") + unit_header + "\n";
}

void write_rows(Text& out, const Mesh_line& line, Row_kind kind) {
  const std::size_t commas = columns_before_error(kind);
  const Unit unit = line.answer.unit;
  const bool has_throats = kind == Row_kind::THROATS && !line.answer.throats.all.empty();
  if(line.exit_code != 0) {
    out << as_cell(line.mesh_file) << std::string(commas, ',')
        << as_cell(boost::algorithm::replace_all_copy(line.error, "\n", " "));
    write_rest(out, kind, unit, nullptr);
  } else if(has_throats)
    for(const Throat& throat : line.answer.throats.all) {
      write_throat_row(out, line.mesh_file, line.answer.throats, throat,
                       line.answer.statistics.genus);
      write_rest(out, kind, unit, nullptr);
    }
  else if(kind == Row_kind::THROATS || line.listing.empty()) {
    out << as_cell(line.mesh_file) << std::string(commas - 1, ',') << line.answer.statistics.genus
        << ',';
    write_rest(out, kind, unit, nullptr);
  } else
    for(const Listed_pair& pair : line.listing) {
      write_pair_row(out, line, pair);
      write_rest(out, kind, unit, &pair);
    }
}

void write_mesh_line(Text& out, const Mesh_line& line) { out << text_of(json_of(line)) << '\n'; }

std::string header_of_lines(const std::vector<std::string>& mesh_files, Row_kind kind) {
  return padded("mesh", width_of(mesh_files)) +
         formatted("  %9s  %6s  %6s  %6s  %9s  %9s", "faces", "comp.", "bound.", "genus",
                   "smallest", "largest") +
         (has_measures(kind) ? formatted("  %14s  %14s", "thinnest", "narrowest") : "") +
         formatted("  %8s\n", "seconds");
}

std::string
row_of(const Mesh_line& line, const std::vector<std::string>& mesh_files, Row_kind kind) {
  const std::string name = padded(printable(line.mesh_file), width_of(mesh_files));
  if(line.exit_code != 0)
    return name + formatted("  no answer (exit code %d)\n", line.exit_code);
  const auto& statistics = line.answer.statistics;
  const auto by_size = [](const Listed_pair& a, const Listed_pair& b) { return a.size < b.size; };
  const auto [least, most] = std::minmax_element(line.listing.begin(), line.listing.end(), by_size);
  const auto size = [&](Pair_listing::const_iterator pair) {
    return pair == line.listing.end() ? std::string("-") : formatted("%.3g%%", 100. * pair->size);
  };
  return name +
         formatted("  %9zu  %6zu  %6zu  %6zu  %9s  %9s", line.number_of_faces,
                   statistics.number_of_components, statistics.number_of_boundaries,
                   statistics.genus, size(least).c_str(), size(most).c_str()) +
         (has_measures(kind)
              ? formatted("  %14s  %14s",
                          least_diameter(line.listing, &Listed_measure::thickness_range).c_str(),
                          least_diameter(line.listing, &Listed_measure::clear_width_range).c_str())
              : "") +
         formatted("  %8.2f\n", line.read_seconds + line.answer.total_seconds);
}

} // namespace htloops
