// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "reeb_json_writer.h"

#include "json_pieces.h"

namespace htloops {
namespace {

class Reeb_json_writer
{
public:
  Reeb_json_writer(const std::string& target, const Reeb_answer& answer)
      : out_(target)
      , answer_(answer) {}

  void write(const Mesh& mesh, double read_seconds) {
    const auto& statistics = answer_.statistics;
    out_ << "{ \"format\": \"htloops-reeb/1\",\n  \"mesh\": { \"vertices\": "
         << mesh.number_of_vertices() << ", \"faces\": " << mesh.number_of_faces()
         << ", \"components\": " << statistics.number_of_components
         << ", \"genus\": " << statistics.genus << " },\n  \"function\": \"" << answer_.function
         << "\", \"threads\": " << answer_.number_of_threads << ",\n";
    write_timings(read_seconds);
    out_ << "  \"cycles\": " << number_of_cycles(answer_) << ",\n";
    write_nodes();
    write_arcs();
    write_vertex_arc();
    out_ << "}\n";
    out_.finish();
  }

private:
  void write_timings(double read_seconds) {
    const auto& statistics = answer_.statistics;
    out_ << "  \"timings\": { \"read\": " << read_seconds
         << ", \"adaptor\": " << statistics.seconds_of_adaptor
         << ", \"function\": " << statistics.seconds_of_function
         << ", \"sweep\": " << statistics.seconds_of_sweep
         << ", \"finishing\": " << statistics.seconds_of_finishing
         << ", \"total\": " << answer_.total_seconds << " },\n";
  }

  void write_nodes() {
    out_ << "  \"nodes\": [";
    const char* separator = "\n";
    for(const auto v : CGAL::make_range(vertices(answer_.graph))) {
      const auto& node = answer_.graph[v];
      out_ << separator << "    { \"id\": " << v << ", \"type\": \"" << name_of(node.type)
           << "\", \"vertex\": " << node.vertex.idx() << ", \"value\": ";
      write_json_number(out_, node.value);
      out_ << ", \"position\": ";
      write_json_point(out_, node.point);
      out_ << " }";
      separator = ",\n";
    }
    out_ << "\n  ],\n";
  }

  void write_arcs() {
    out_ << "  \"arcs\": [";
    const char* separator = "\n";
    for(const auto e : CGAL::make_range(edges(answer_.graph))) {
      const auto& arc = answer_.graph[e];
      out_ << separator << "    { \"id\": " << arc.index
           << ", \"source\": " << source(e, answer_.graph)
           << ", \"target\": " << target(e, answer_.graph)
           << ", \"vertex_count\": " << arc.vertices.size() << ", \"length\": ";
      write_json_number(out_, arc.length);
      out_ << ",\n      \"polyline\": [";
      const char* comma = "";
      for(const Point& point : arc.polyline) {
        out_ << comma;
        write_json_point(out_, point);
        comma = ", ";
      }
      out_ << "] }";
      separator = ",\n";
    }
    out_ << "\n  ],\n";
  }

  // Vertices without faces are on no arc: null.
  void write_vertex_arc() {
    out_ << "  \"vertex_arc\": [";
    const char* comma = "";
    for(const std::size_t arc : answer_.vertex_arc) {
      out_ << comma;
      if(arc == Reeb_answer::no_arc)
        out_ << "null";
      else
        out_ << arc;
      comma = ",";
    }
    out_ << "]\n";
  }

  Text_writer out_;
  const Reeb_answer& answer_;
};

} // namespace

void write_reeb_json(const std::string& target,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     double read_seconds) {
  Reeb_json_writer(target, answer).write(mesh, read_seconds);
}

} // namespace htloops
