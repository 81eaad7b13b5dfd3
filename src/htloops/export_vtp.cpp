// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "export_formats.h"

namespace htloops {
namespace {

class Vtp_writer
{
public:
  Vtp_writer(Text_writer& out, const Pairs& pairs)
      : out_(out)
      , pairs_(pairs) {}

  void write() {
    out_ << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
            "<Piece NumberOfPoints=\""
         << number_of_points(pairs_) << "\" NumberOfVerts=\"0\" NumberOfLines=\""
         << 2 * pairs_.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
    write_points();
    write_lines();
    write_data();
    out_ << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  void begin_array(const char* type, const char* name, const char* more = "") {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\"" << more
         << " format=\"ascii\">\n";
  }

  void end_array() { out_ << "</DataArray>\n"; }

  // an array with one value per loop, the result of `value(loop, type, pair)`.
  template <typename Value> void write_array(const char* type, const char* name, Value value) {
    begin_array(type, name);
    for_each_loop(pairs_, [&](const Loop& loop, CGAL::Loop_type loop_type, std::size_t pair) {
      out_ << value(loop, loop_type, pair) << '\n';
    });
    end_array();
  }

  void write_points() {
    out_ << "<Points>\n";
    begin_array("Float64", "Points", " NumberOfComponents=\"3\"");
    for_each_loop(pairs_, [this](const Loop& loop, CGAL::Loop_type, std::size_t) {
      for(const Point& point : loop.points())
        out_ << point << '\n';
    });
    end_array();
    out_ << "</Points>\n";
  }

  // A closed line names its first point again at the end.
  void write_lines() {
    out_ << "<Lines>\n";
    begin_array("Int64", "connectivity");
    std::size_t first = 0;
    for_each_loop(pairs_, [&](const Loop& loop, CGAL::Loop_type, std::size_t) {
      for(std::size_t i = 0; i < loop.size(); ++i)
        out_ << first + i << ' ';
      out_ << first << '\n';
      first += loop.size();
    });
    end_array();
    std::size_t end = 0;
    write_array("Int64", "offsets", [&end](const Loop& loop, CGAL::Loop_type, std::size_t) {
      return end += loop.size() + 1;
    });
    out_ << "</Lines>\n";
  }

  void write_data() {
    out_ << "<CellData Scalars=\"kind\">\n";
    // 0 is a handle, 1 a tunnel.
    write_array("UInt8", "kind", [](const Loop&, CGAL::Loop_type type, std::size_t) {
      return type == CGAL::Loop_type::HANDLE ? 0 : 1;
    });
    write_array("Int64", "pair",
                [](const Loop&, CGAL::Loop_type, std::size_t pair) { return pair; });
    write_array("Float64", "length",
                [](const Loop& loop, CGAL::Loop_type, std::size_t) { return loop.length(); });
    out_ << "</CellData>\n";
  }

  Text_writer& out_;
  const Pairs& pairs_;
};

} // namespace

void write_lines_vtp(Text_writer& out, const Pairs& pairs) { Vtp_writer(out, pairs).write(); }

} // namespace htloops
