// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TABLE_ROWS_H
#define HTLOOPS_TABLE_ROWS_H

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace htloops {

/// a line of a table, or a part of one, as `std::snprintf()` writes it.
template <typename... Values> std::string formatted(const char* format, Values... values) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// A column of a table for a person.
struct Table_column
{
  const char* name;
  int width;      ///< 0: the last one
  bool is_number; ///< these stand to the right
};

/// what stands in a column, as wide as that is.
inline std::string padded(const Table_column& column, const std::string& cell) {
  return formatted("%*s", column.is_number ? column.width : -column.width, cell.c_str());
}

/// the rows that `row(i)` makes; of a long table only the first and the last ones, unless all are
/// to be shown.
template <typename Row> std::string table_rows(std::size_t count, bool show_all, Row row) {
  constexpr std::size_t longest_whole_table = 40;
  constexpr std::size_t first_rows = 20;
  constexpr std::size_t last_rows = 5;
  const bool is_whole = show_all || count <= longest_whole_table;
  std::string rows;
  for(std::size_t i = 0; i < count; ++i) {
    if(!is_whole && i == first_rows) {
      i = count - last_rows;
      rows += "  ... " + std::to_string(i - first_rows) + " more (--all shows them)\n";
    }
    rows += row(i);
  }
  return rows;
}

} // namespace htloops

#endif // HTLOOPS_TABLE_ROWS_H
