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
#include "write/text_writer.h"

namespace htloops {
namespace {

void write_sides(Text_writer& out, const Answer& answer, std::size_t pair) {
  const auto& linking = answer.certificate.linking;
  for(std::size_t loop = 2 * pair; loop < 2 * pair + 2; ++loop)
    out << ',' << (linking.empty() ? "" : word_for_side(linking[loop]));
}

} // namespace

void write_pair_csv(const std::string& target, const Answer& answer, const Pair_listing& listing) {
  Text_writer out(target);
  out << "pair,handle_length,tunnel_length,size,handle_bounds,tunnel_bounds,"
         "x,y,z,xmin,ymin,zmin,xmax,ymax,zmax\n";
  for(const Listed_pair& pair : listing) {
    out << pair.pair << ',' << pair.handle_length << ',' << pair.tunnel_length << ',' << pair.size;
    write_sides(out, answer, pair.pair);
    out << ',' << pair.centre.x() << ',' << pair.centre.y() << ',' << pair.centre.z();
    for(int i = 0; i < 3; ++i)
      out << ',' << pair.box.min(i);
    for(int i = 0; i < 3; ++i)
      out << ',' << pair.box.max(i);
    out << '\n';
  }
  out.finish();
}

} // namespace htloops
