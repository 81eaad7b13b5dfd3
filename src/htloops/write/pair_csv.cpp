// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/pair_csv.h"

#include "write/linking_words.h"

#include <cstddef>

namespace htloops {
namespace {

// A text as a cell.
std::string cell_of(const std::string& text) {
  if(text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string cell = "\"";
  for(const char c : text)
    cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + '"';
}

void write_sides(Text_writer& out, const Answer& answer, std::size_t pair) {
  const auto& linking = answer.certificate.linking;
  for(std::size_t loop = 2 * pair; loop < 2 * pair + 2; ++loop)
    out << ',' << (linking.empty() ? "" : word_for_side(linking[loop]));
}

} // namespace

Pair_csv_writer::Pair_csv_writer(const std::string& target)
    : out_(target) {
  out_ << "mesh,pair,handle_length,tunnel_length,size,handle_bounds,tunnel_bounds,"
          "x,y,z,xmin,ymin,zmin,xmax,ymax,zmax\n";
}

void Pair_csv_writer::add(const std::string& mesh_file,
                          const Answer& answer,
                          const Pair_listing& listing) {
  for(const Listed_pair& pair : listing) {
    out_ << cell_of(mesh_file) << ',' << pair.pair << ',' << pair.handle_length << ','
         << pair.tunnel_length << ',' << pair.size;
    write_sides(out_, answer, pair.pair);
    out_ << ',' << pair.centre.x() << ',' << pair.centre.y() << ',' << pair.centre.z();
    for(int i = 0; i < 3; ++i)
      out_ << ',' << pair.box.min(i);
    for(int i = 0; i < 3; ++i)
      out_ << ',' << pair.box.max(i);
    out_ << '\n';
  }
}

void write_pair_csv(const std::string& target,
                    const std::string& mesh_file,
                    const Answer& answer,
                    const Pair_listing& listing) {
  Pair_csv_writer writer(target);
  writer.add(mesh_file, answer, listing);
  writer.finish();
}

} // namespace htloops
