// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/removal_table.h"

#include "words.h"
#include "write/table_rows.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Refused_handle;
using CGAL::Handle_tunnel_loops::Removal_report;
using CGAL::Handle_tunnel_loops::Removal_way;
using CGAL::Handle_tunnel_loops::Removed_handle;

constexpr Removal_way ways[] = {Removal_way::CUT, Removal_way::FILL, Removal_way::WHOLE};

// As wide as the number of a pair.
constexpr char neck[] = " neck";

std::string number_of(std::size_t pair) { return formatted("%5zu", pair); }

std::string row(const Removed_handle& handle, const std::string& number) {
  return number + formatted("  %-5s  %12.6g  %12.6g  %12.6g\n", name_of(handle.by), handle.length,
                            handle.area, handle.volume);
}

std::string row(const Refused_handle& handle, const std::string& number) {
  return number + formatted("  stays  %12.6g  ", handle.length) + handle.reason + "\n";
}

// First the handles, then the necks.
template <typename Handle>
std::string
rows(const std::vector<Handle>& handles, const std::vector<Handle>& necks, bool show_all) {
  return table_rows(handles.size(), show_all,
                    [&](std::size_t i) { return row(handles[i], number_of(handles[i].pair)); }) +
         table_rows(necks.size(), show_all, [&](std::size_t i) { return row(necks[i], neck); });
}

// "30 cut, 13 filled"
std::string list_of_ways(const std::vector<Removed_handle>& handles) {
  constexpr const char* participles[] = {"cut", "filled", "taken out whole"};
  std::string list;
  for(const Removal_way way : ways) {
    const auto count = std::count_if(handles.begin(), handles.end(),
                                     [way](const Removed_handle& h) { return h.by == way; });
    if(count > 0)
      list += (list.empty() ? "" : ", ") + std::to_string(count) + " " +
              participles[static_cast<std::size_t>(way)];
  }
  return list;
}

} // namespace

const char* name_of(Removal_way way) {
  constexpr const char* names[] = {"cut", "fill", "whole"};
  return names[static_cast<std::size_t>(way)];
}

std::string table_of_removals(const Removal_report& report, bool show_all) {
  const std::string removed = rows(report.removed, report.removed_necks, show_all);
  const std::string refused = rows(report.refused, report.refused_necks, show_all);
  std::string table;
  if(!removed.empty())
    table += " pair  by           length          area        volume\n" + removed;
  if(!refused.empty())
    table += " pair  refused      length  why\n" + refused;
  return table;
}

std::string summary(const Removal_report& report) {
  const std::string by = list_of_ways(report.removed);
  std::string text = "genus " + std::to_string(report.genus_before) + " -> " +
                     std::to_string(report.genus_after) + ", " +
                     std::to_string(report.removed.size()) + " removed" +
                     (by.empty() ? "" : " (" + by + ")") + ", " +
                     std::to_string(report.refused.size()) + " refused\n";
  if(!report.removed_necks.empty() || !report.refused_necks.empty())
    text += counted(report.components_before, "component", "components") + " -> " +
            std::to_string(report.components_after) + ", " +
            counted(report.removed_necks.size(), "neck", "necks") + " cut, " +
            std::to_string(report.refused_necks.size()) + " refused\n";
  return text;
}

} // namespace htloops
