// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/removal_json_writer.h"

#include "write/json_writer.h"
#include "write/removal_table.h"

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Refused_handle;
using CGAL::Handle_tunnel_loops::Removed_handle;

Json json_of(const Removed_handle& handle) {
  return {{"pair", handle.pair},
          {"by", name_of(handle.by)},
          {"length", handle.length},
          {"area", handle.area},
          {"volume", handle.volume}};
}

Json json_of(const Refused_handle& handle) {
  return {{"pair", handle.pair}, {"length", handle.length}, {"reason", handle.reason}};
}

// Necks are of no pair.
template <typename Necks> Json json_of_necks(const Necks& necks) {
  Json array = Json::array();
  for(const auto& neck : necks) {
    array.push_back(json_of(neck));
    array.back().erase("pair");
  }
  return array;
}

} // namespace

void write_removal_json(const std::string& file,
                        const CGAL::Handle_tunnel_loops::Removal_report& report) {
  const auto json = [](const auto& handle) { return json_of(handle); };
  Json_writer document(file);
  document.member("format", "htloops-remove/1");
  document.member("genus_before", report.genus_before);
  document.member("genus_after", report.genus_after);
  document.member("components_before", report.components_before);
  document.member("components_after", report.components_after);
  document.array("removed", report.removed, json);
  document.array("refused", report.refused, json);
  document.member("necks", {{"removed", json_of_necks(report.removed_necks)},
                            {"refused", json_of_necks(report.refused_necks)}});
  document.finish();
}

} // namespace htloops
