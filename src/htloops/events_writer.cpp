// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "events_writer.h"

#include "text_writer.h"

#include <cmath>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Field_resolution;
using CGAL::Handle_tunnel_loops::Front_event;

void write_resolution(Text_writer& out, const Field_resolution& resolution) {
  out << "  \"resolution\": { \"is_resolved\": " << (resolution.is_resolved() ? "true" : "false")
      << ", \"handles_within_steps\": " << resolution.handles_within_steps
      << ", \"rests\": " << resolution.rests
      << ", \"early_vertices\": " << resolution.early_vertices
      << ", \"events_in_seed_region\": " << resolution.events_in_seed_region << " },\n";
}

void write_fronts(Text_writer& out, const std::vector<Front_event::Front>& fronts) {
  const char* separator = "";
  out << '[';
  for(const Front_event::Front& front : fronts) {
    out << separator << "{ \"layer\": " << front.layer << ", \"length\": ";
    if(std::isfinite(front.length))
      out << front.length;
    else
      out << "null";
    out << " }";
    separator = ", ";
  }
  out << ']';
}

void write_event(Text_writer& out, const Front_event& event) {
  out << "    { \"type\": \"" << CGAL::Handle_tunnel_loops::front_event_name(event.type)
      << "\", \"step\": " << event.step << ", \"vertex\": " << event.vertex << ", \"before\": ";
  write_fronts(out, event.before);
  out << ", \"after\": ";
  write_fronts(out, event.after);
  out << " }";
}

} // namespace

void write_events(const std::string& target, const Answer& answer) {
  Text_writer out(target);
  out << "{ \"format\": \"htloops-events/1\",\n";
  if(answer.backend == "reference")
    write_resolution(out, answer.statistics.resolution);
  out << "  \"events\": [";
  const char* separator = "\n";
  for(const Front_event& event : answer.statistics.front_events) {
    out << separator;
    write_event(out, event);
    separator = ",\n";
  }
  out << (answer.statistics.front_events.empty() ? "]\n" : "\n  ]\n") << "}\n";
  out.finish();
}

} // namespace htloops
