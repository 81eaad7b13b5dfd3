// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/channel_formats.h"

#include "write/files.h"
#include "write/tables.h"

#include <cmath>

namespace htloops {
namespace {

using Channels = std::vector<Channel>;

void check_room(const Point& p, double radius) {
  constexpr double least = -999.999, most = 9999.999, widest = 999.99;
  bool has_room = radius < widest;
  for(int i = 0; i < 3; ++i)
    has_room = has_room && least < p[i] && p[i] < most;
  if(!has_room)
    throw wrong_usage(
        "PDB coordinates are in Angstroms and must be between -999 and 9999: use .bild "
        "or .csv");
}

// A chain for each channel; its residue has the number of the pair.
void write_pdb(Text_writer& out, const Channels& channels) {
  out << "REMARK   1 Channels found by htloops: the B-factor column is the radius\n"
         "REMARK   1 In PyMOL, a line each: alter all, vdw=b\n"
         "REMARK   1                        rebuild\n"
         "REMARK   1                        show spheres\n";
  std::size_t first = 1;
  constexpr std::size_t most_atoms = 99999;
  std::string bonds;
  for(const Channel& channel : channels) {
    const char chain = static_cast<char>('A' + static_cast<char>(channel.pair % 26));
    const std::size_t n = channel.points.size();
    for(std::size_t i = 0; i < n; ++i) {
      const Point& p = channel.points[i];
      check_room(p, channel.radii[i]);
      out << formatted("HETATM%5zu  C   CHN %c%4zu    %8.3f%8.3f%8.3f  1.00%6.2f           C\n",
                       (first + i) % (most_atoms + 1), chain, channel.pair % 10000, p.x(), p.y(),
                       p.z(), channel.radii[i]);
      const std::size_t next = first + (i + 1) % n;
      if((i + 1 < n || channel.is_closed) && (std::max)(first + i, next) <= most_atoms)
        bonds += formatted("CONECT%5zu%5zu\n", first + i, next);
    }
    out << "TER\n";
    first += n;
  }
  out << bonds << "END\n";
}

void write_bild(Text_writer& out, const Channels& channels) {
  for(const Channel& channel : channels) {
    out << ".comment channel of pair " << channel.pair << ", diameter " << channel.diameter
        << "\n.color 0.20 0.45 0.75\n";
    for(std::size_t i = 0; i < channel.points.size(); ++i) {
      const Point& p = channel.points[i];
      out << ".sphere " << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << channel.radii[i] << '\n';
    }
  }
}

// Along each channel, how far, and how wide it is there.
void write_csv(Text_writer& out, const Channels& channels) {
  out << "pair,distance,radius,x,y,z\n";
  for(const Channel& channel : channels) {
    double distance = 0.;
    for(std::size_t i = 0; i < channel.points.size(); ++i) {
      const Point& p = channel.points[i];
      if(i > 0)
        distance += std::sqrt(CGAL::squared_distance(channel.points[i - 1], p));
      out << channel.pair << ',' << distance << ',' << channel.radii[i] << ',' << p.x() << ','
          << p.y() << ',' << p.z() << '\n';
    }
  }
}

constexpr File_format<void(Text_writer&, const Channels&)> channel_formats[] = {
    {".pdb", write_pdb}, {".bild", write_bild}, {".csv", write_csv}};

} // namespace

void check_channel_format(const std::string& file) { check_format(file, channel_formats); }

void write_channels(const std::string& file, const Channels& channels) {
  write_file(file, channel_formats, channels);
}

} // namespace htloops
