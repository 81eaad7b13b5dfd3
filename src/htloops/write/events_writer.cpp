// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/events_writer.h"

#include "write/json_writer.h"

#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Field_resolution;
using CGAL::Handle_tunnel_loops::Front_event;

Json json_of(const Field_resolution& resolution) {
  return {{"is_resolved", resolution.is_resolved()},
          {"handles_within_steps", resolution.handles_within_steps},
          {"rests", resolution.rests},
          {"early_vertices", resolution.early_vertices},
          {"events_in_seed_region", resolution.events_in_seed_region}};
}

Json json_of(const std::vector<Front_event::Front>& fronts) {
  Json array = Json::array();
  for(const Front_event::Front& front : fronts)
    array.push_back({{"layer", front.layer}, {"length", front.length}});
  return array;
}

Json json_of(const Front_event& event) {
  return {{"type", CGAL::Handle_tunnel_loops::front_event_name(event.type)},
          {"step", event.step},
          {"vertex", event.vertex},
          {"before", json_of(event.before)},
          {"after", json_of(event.after)}};
}

} // namespace

void write_events(const std::string& target, const Answer& answer) {
  Json_writer out(target);
  out.member("format", "htloops-events/1");
  if(answer.backend == "reference")
    out.member("resolution", json_of(answer.statistics.resolution));
  out.array("events", answer.statistics.front_events,
            [](const Front_event& event) { return json_of(event); });
  out.finish();
}

} // namespace htloops
