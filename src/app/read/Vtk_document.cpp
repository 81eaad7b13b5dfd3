// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/Vtk_document.h"

#include "read/unpacking.h"
#include "window/base64.h"

#include <cstdint>
#include <numeric>
#include <optional>

namespace htloops {
namespace {

struct Vtk_type
{
  const char* name;
  bool (*read)(Binary_source&, double&);
};

constexpr Vtk_type vtk_types[] = {
    {"Float64", read_as<double>},     {"Float32", read_as<float>},
    {"Int64", read_as<std::int64_t>}, {"UInt64", read_as<std::uint64_t>},
    {"Int32", read_as<std::int32_t>}, {"UInt32", read_as<std::uint32_t>},
    {"Int16", read_as<std::int16_t>}, {"UInt16", read_as<std::uint16_t>},
    {"Int8", read_as<std::int8_t>},   {"UInt8", read_as<std::uint8_t>},
};

std::size_t length_in_base64(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

} // namespace

Vtk_document::Vtk_document(const Input_file& file)
    : file_(file) {
  const std::string_view end = "</AppendedData></VTKFile>";
  std::string document(without_appended());
  if(appended_.data() != nullptr)
    document += end;
  tree_ = read_xml(file, document);
  const auto root = tree_.get_child_optional("VTKFile");
  if(!root)
    fail("it is not a VTK XML file");
  compressor_ = xml_attribute(*root, "compressor");
  is_little_endian_ = xml_attribute(*root, "byte_order") != "BigEndian";
  size_of_header_ = xml_attribute(*root, "header_type") == "UInt64" ? 8 : 4;
  if(const auto appended = root->get_child_optional("AppendedData"))
    is_appended_encoded_ = xml_attribute(*appended, "encoding") != "raw";
}

const Xml_tree* Vtk_document::data_set(const std::string& type) const {
  const auto found = tree_.get_child_optional("VTKFile." + type);
  return found ? &*found : nullptr;
}

// What is appended begins behind an underscore and need not be XML.
std::string_view Vtk_document::without_appended() {
  const std::string_view content = file_.content();
  const std::size_t element = content.find("<AppendedData");
  const std::size_t end = element == content.npos ? element : content.find('>', element);
  const std::size_t mark = end == content.npos ? end : content.find('_', end);
  if(mark == content.npos)
    return content;
  appended_ = content.substr(mark + 1);
  return content.substr(0, mark);
}

void Vtk_document::fail(const std::string& problem) const { fail_to_read(file_.name(), problem); }

Vtk_document::Numbers Vtk_document::array(const Xml_tree& piece,
                                          const std::string& section,
                                          const std::string& name) const {
  const auto arrays = piece.get_child_optional(section);
  if(!arrays)
    return {};
  for(const auto& [kind, array] : *arrays) {
    if(kind != "DataArray" || (!name.empty() && xml_attribute(array, "Name") != name))
      continue;
    if(xml_attribute(array, "format") == "ascii")
      return numbers_of_text(file_, array.data());
    const std::string bytes = bytes_of(array);
    return numbers_of_bytes(file_.name(), bytes, is_little_endian_,
                            reader_of(xml_attribute(array, "type")));
  }
  return {};
}

Read_number Vtk_document::reader_of(const std::string& type) const {
  for(const Vtk_type& known : vtk_types)
    if(type == known.name)
      return known.read;
  fail("numbers of the type " + in_quotes(type) + " are not supported");
}

std::string Vtk_document::bytes_of(const Xml_tree& array) const {
  if(is_packed() && compressor_ != "vtkZLibDataCompressor")
    fail("compression with " + in_quotes(compressor_) +
         " is not supported: save the file with ZLib, or without compression");
  const std::string format = xml_attribute(array, "format");
  if(format == "binary")
    return unpacked(htl_window::bytes_of_base64(array.data()));
  if(format != "appended")
    fail("an array has the unknown format " + in_quotes(format));
  const auto offset = array.get_optional<std::size_t>("<xmlattr>.offset");
  if(!offset || *offset >= appended_.size())
    fail("an array starts beyond the end of the file");
  const std::string_view rest = appended_.substr(*offset);
  return is_appended_encoded_ ? unpacked(decoded_from_appended(rest)) : unpacked(rest);
}

// The header of packed bytes is coded apart from them.
std::string Vtk_document::decoded_from_appended(std::string_view text) const {
  const auto decoded = [&text](std::size_t begin, std::size_t bytes) {
    return htl_window::bytes_of_base64(
        text.substr((std::min)(begin, text.size()), length_in_base64(bytes)));
  };
  const std::vector<std::size_t> first = header_of(decoded(0, size_of_header_));
  if(!is_packed())
    return decoded(0, size_of_header_ + first[0]);
  const std::size_t size = size_of_header_ * (first[0] + 3);
  std::string bytes = decoded(0, size);
  const std::vector<std::size_t> header = header_of(bytes);
  if(header.size() > 3)
    bytes += decoded(length_in_base64(size),
                     std::accumulate(header.begin() + 3, header.end(), std::size_t(0)));
  return bytes;
}

// Of bytes that are not packed, their number; else how many blocks there are, how long they and the
// last one are unpacked, and how long each is. As much of it as there is.
std::vector<std::size_t> Vtk_document::header_of(std::string_view bytes) const {
  Binary_source source(file_.name(), bytes, 0, is_little_endian_);
  std::vector<std::size_t> header;
  double number;
  const Read_number read_next =
      size_of_header_ == 8 ? read_as<std::uint64_t> : read_as<std::uint32_t>;
  for(std::size_t i = 0, size = 1; i < size && read_next(source, number); ++i) {
    if(!(number <= static_cast<double>(file_.content().size() << 10)))
      fail("an array has fewer bytes than declared");
    header.push_back(static_cast<std::size_t>(number));
    if(i == 0 && is_packed())
      size = header[0] + 3;
  }
  if(header.empty())
    fail("an array has fewer bytes than declared");
  return header;
}

std::string Vtk_document::unpacked(std::string_view bytes) const {
  const std::vector<std::size_t> header = header_of(bytes);
  std::size_t begin = header.size() * size_of_header_;
  const auto take = [&](std::size_t size) {
    if(bytes.size() - begin < size)
      fail("an array has fewer bytes than declared");
    const std::string_view part = bytes.substr(begin, size);
    begin += size;
    return part;
  };
  if(!is_packed())
    return std::string(take(header[0]));
  if(header.size() < 3 ? header[0] != 0 : header.size() != header[0] + 3)
    fail("an array has fewer blocks than declared");
  std::string all;
  for(std::size_t block = 3; block < header.size(); ++block) {
    const std::optional<std::string> part =
        htloops::unpacked(file_.name(), take(header[block]), htl_window::Frame::ZLIB, all.size());
    if(!part)
      fail("a block of an array is not a zlib stream");
    all += *part;
  }
  return all;
}

Vtk_document::Numbers Vtk_document::points(const Xml_tree& piece) const {
  Numbers x = array(piece, "Points", "");
  const auto announced = piece.get_optional<std::size_t>("<xmlattr>.NumberOfPoints");
  if(x.size() % 3 != 0 || (announced && x.size() / 3 != *announced))
    fail("a piece does not have the declared number of points with three coordinates");
  return x;
}

Vtk_document::Cells Vtk_document::cells(const Xml_tree& piece,
                                        const std::string& section,
                                        std::size_t first,
                                        std::size_t number_of_points) const {
  const Numbers numbers = array(piece, section, "connectivity");
  Cells cells;
  std::size_t begin = 0;
  for(const double end : array(piece, section, "offsets")) {
    cells.emplace_back();
    if(!(end >= static_cast<double>(begin) && end <= static_cast<double>(numbers.size())))
      fail("cell " + std::to_string(cells.size() - 1) + " has an invalid offset");
    for(; static_cast<double>(begin) < end; ++begin) {
      if(!(numbers[begin] >= 0. && numbers[begin] < static_cast<double>(number_of_points)))
        fail("cell " + std::to_string(cells.size() - 1) + " uses a point that does not exist");
      cells.back().push_back(first + static_cast<std::size_t>(numbers[begin]));
    }
  }
  if(begin != numbers.size())
    fail("its cells do not use the whole connectivity array");
  return cells;
}

} // namespace htloops
