// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VTK_DOCUMENT_H
#define HTLOOPS_VTK_DOCUMENT_H

#include "read/input_file.h"
#include "read/sources.h"
#include "read/xml.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// A file of VTK's XML, with arrays as text, in base 64 or as bytes, within their elements or
/// appended, packed by zlib or not.
class Vtk_document
{
public:
  using Numbers = std::vector<double>;
  /// The numbers of the points of each cell.
  using Cells = std::vector<std::vector<std::size_t>>;

  /// Throws `Failure` if the file is none, is broken, or is packed by something else.
  explicit Vtk_document(const Input_file& file);

  /// its data set if it is of that type, `PolyData` say, else null.
  const Xml_tree* data_set(const std::string& type) const;

  /// calls `visit(piece)` for all pieces of a data set.
  template <typename Visit> static void for_each_piece(const Xml_tree& data_set, Visit visit) {
    for(const auto& [name, piece] : data_set)
      if(name == "Piece")
        visit(piece);
  }

  /// an array of a section of a piece, the first one if there is no name; empty if there is none.
  Numbers array(const Xml_tree& piece, const std::string& section, const std::string& name) const;

  /// the coordinates of the points of a piece, three of each. Throws `Failure` if there are not as
  /// many as it says.
  Numbers points(const Xml_tree& piece) const;

  /// the cells of a section of a piece of so many points, which are counted on from `first`. Throws
  /// `Failure` if a cell has a point that is not there, or if points are left over.
  Cells cells(const Xml_tree& piece,
              const std::string& section,
              std::size_t first,
              std::size_t number_of_points) const;

private:
  bool is_packed() const { return !compressor_.empty(); }
  std::string_view without_appended();
  [[noreturn]] void fail(const std::string& problem) const;
  std::string bytes_of(const Xml_tree& array) const;
  std::string decoded_from_appended(std::string_view text) const;
  std::vector<std::size_t> header_of(std::string_view bytes) const;
  std::string unpacked(std::string_view bytes) const;
  Read_number reader_of(const std::string& type) const;

  const Input_file& file_;
  std::string_view appended_; // behind the mark
  Xml_tree tree_;
  bool is_appended_encoded_ = false;
  std::string compressor_; // empty if nothing is packed
  bool is_little_endian_ = true;
  std::size_t size_of_header_ = 4; // of a number of it, in bytes
};

} // namespace htloops

#endif // HTLOOPS_VTK_DOCUMENT_H
