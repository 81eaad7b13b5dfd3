// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "loops_json_writer.h"

#include "json_pieces.h"
#include "linking_words.h"
#include "text_writer.h"

#include <optional>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Stage;

// The names of the backends and the stages need no escaping, so JSON is a matter of commas. It is
// written as it comes, as a thousand long loops are no tree to keep in memory.
class Loops_json_writer
{
public:
  Loops_json_writer(const std::string& target, const Mesh& mesh)
      : out_(target)
      , mesh_(mesh) {}

  void write(const Answer& answer, double read_seconds) {
    out_ << "{ \"format\": \"htloops/1\",\n";
    write_mesh(answer);
    out_ << "  \"backend\": \"" << answer.backend << "\", \"threads\": " << answer.number_of_threads
         << ",\n";
    write_timings(answer, read_seconds);
    write_certificate(answer);
    write_linking(answer.certificate.linking);
    write_pairs(answer);
    out_ << "}\n";
    out_.finish();
  }

private:
  void write_mesh(const Answer& answer) {
    out_ << "  \"mesh\": { \"vertices\": " << mesh_.number_of_vertices()
         << ", \"faces\": " << mesh_.number_of_faces()
         << ", \"components\": " << answer.statistics.number_of_components
         << ", \"genus\": " << answer.statistics.genus << " },\n";
  }

  void write_timings(const Answer& answer, double read_seconds) {
    out_ << "  \"timings\": { \"read\": ";
    write_json_number(out_, read_seconds);
    for(std::size_t i = 0; i < CGAL::Handle_tunnel_loops::number_of_stages; ++i) {
      const auto stage = static_cast<Stage>(i);
      out_ << ", \"" << CGAL::Handle_tunnel_loops::stage_name(stage) << "\": ";
      write_json_number(out_, answer.statistics.seconds_of(stage));
    }
    out_ << ", \"total\": ";
    write_json_number(out_, answer.total_seconds);
    out_ << " },\n";
  }

  void write_certificate(const Answer& answer) {
    const auto& certificate = answer.certificate;
    out_ << "  \"certificate\": { \"closed_on_surface\": " << word(certificate.closed_on_surface)
         << ", \"basis\": " << word(certificate.basis)
         << ", \"pairing\": " << word(certificate.pairing)
         << ", \"types\": " << word(certificate.types) << ", \"handles_bound_inside\": ";
    write_count(certificate.handles_bound_inside);
    out_ << ", \"tunnels_bound_outside\": ";
    write_count(certificate.tunnels_bound_outside);
    out_ << " },\n";
  }

  static const char* word(bool value) { return value ? "true" : "false"; }

  // Row, column and value, where loop 2k is handle k and loop 2k + 1 is tunnel k.
  void write_linking(const std::vector<CGAL::Handle_tunnel_loops::Loop_linking>& linking) {
    if(linking.empty())
      return;
    out_ << "  \"linking\": [";
    const char* separator = "";
    for(std::size_t i = 0; i < linking.size(); ++i)
      for(const auto& [j, value] : linking[i].row) {
        out_ << separator << '[' << i << ',' << j << ',' << value << ']';
        separator = ", ";
      }
    out_ << "],\n";
  }

  void write_pairs(const Answer& answer) {
    const Pairs& pairs = answer.pairs;
    const auto& linking = answer.certificate.linking;
    out_ << "  \"pairs\": [";
    for_each_loop(pairs, [&](const Loop& loop, CGAL::Loop_type type, std::size_t pair) {
      const bool is_first = type == CGAL::Loop_type::HANDLE;
      out_ << (!is_first   ? ",\n      \""
               : pair == 0 ? "\n    { \""
                           : ",\n    { \"")
           << name_of(type) << "\": ";
      write_loop(loop, linking.empty() ? nullptr : word_for_side(linking[2 * pair + !is_first]));
      out_ << (is_first ? "" : " }");
    });
    out_ << (pairs.empty() ? "]\n" : "\n  ]\n");
  }

  void write_loop(const Loop& loop, const char* side) {
    out_ << "{ \"length\": ";
    write_json_number(out_, loop.length());
    if(side != nullptr)
      out_ << ", \"bounds\": \"" << side << '"';
    out_ << ",\n        \"locations\": [";
    const char* separator = "";
    for(const Loop::Step& step : loop.steps()) {
      out_ << separator << '[' << mesh_.source(step.halfedge).idx() << ','
           << mesh_.target(step.halfedge).idx() << ',';
      write_json_number(out_, step.ratio);
      out_ << ']';
      separator = ", ";
    }
    out_ << "],\n        \"points\": [";
    separator = "";
    for(const Point& point : loop.points()) {
      out_ << separator;
      write_json_point(out_, point);
      separator = ", ";
    }
    out_ << "] }";
  }

  void write_count(const std::optional<std::size_t>& count) {
    if(count)
      out_ << *count;
    else
      out_ << "null";
  }

  Text_writer out_;
  const Mesh& mesh_;
};

} // namespace

void write_loops_json(const std::string& target,
                      const Mesh& mesh,
                      const Answer& answer,
                      double read_seconds) {
  Loops_json_writer(target, mesh).write(answer, read_seconds);
}

} // namespace htloops
