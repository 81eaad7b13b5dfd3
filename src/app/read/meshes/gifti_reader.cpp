// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/readers.h"
#include "read/sources.h"
#include "read/unpacking.h"
#include "read/xml.h"
#include "window/base64.h"

#include <array>
#include <optional>

namespace htloops {
namespace {

// Arrays of points and of triangles, as text, or as bytes in base 64, packed by zlib or not.
class Gifti_reader
{
public:
  explicit Gifti_reader(const Input_file& file)
      : file_(file) {}

  Soup read() {
    const Xml_tree tree = read_xml(file_);
    const auto root = tree.get_child_optional("GIFTI");
    if(!root)
      fail_to_read(file_.name(), "it is not a GIFTI file");
    for(const auto& [kind, array] : *root)
      if(kind == "DataArray")
        read_array(array);
    if(!has_points_ || !has_triangles_)
      fail_to_read(file_.name(),
                   "it has data on a surface, but not the surface itself: use its .surf.gii file");
    check_corners(file_.name(), soup_);
    soup_.facts.unit = Unit::MILLIMETER;
    return std::move(soup_);
  }

private:
  void read_array(const Xml_tree& array) {
    const std::string intent = xml_attribute(array, "Intent");
    if(intent == "NIFTI_INTENT_POINTSET") {
      has_points_ = check_is_first(has_points_, "point sets");
      for_each_row(array,
                   [this](double x, double y, double z) { soup_.points.emplace_back(x, y, z); });
    } else if(intent == "NIFTI_INTENT_TRIANGLE") {
      has_triangles_ = check_is_first(has_triangles_, "triangle sets");
      for_each_row(array, [this](double a, double b, double c) {
        soup_.add_face(std::array<std::uint64_t, 3>{vertex(a), vertex(b), vertex(c)});
      });
    } else if(soup_.facts.unread.empty())
      soup_.facts.unread = {"vertex data"};
  }

  bool check_is_first(bool has_one, const char* what) const {
    if(has_one)
      fail_to_read(file_.name(), "it has several " + std::string(what));
    return true;
  }

  static std::uint64_t vertex(double number) {
    return number >= 0. && number < 4e9 ? static_cast<std::uint64_t>(number) : ~std::uint64_t(0);
  }

  // Numbers of a row are beside each other, or those of a column.
  template <typename Visit> void for_each_row(const Xml_tree& array, Visit visit) const {
    const std::vector<double> x = numbers_of(array);
    const std::size_t rows = array.get("<xmlattr>.Dim0", std::size_t(0));
    if(array.get("<xmlattr>.Dim1", 0) != 3 || rows > x.size() || x.size() != 3 * rows)
      fail_to_read(file_.name(), "an array does not have the declared number of values");
    const bool by_rows = xml_attribute(array, "ArrayIndexingOrder") != "ColumnMajorOrder";
    const std::size_t row = by_rows ? 3 : 1, column = by_rows ? 1 : rows;
    for(std::size_t i = 0; i < rows; ++i)
      visit(x[i * row], x[i * row + column], x[i * row + 2 * column]);
  }

  std::vector<double> numbers_of(const Xml_tree& array) const {
    const std::string encoding = xml_attribute(array, "Encoding"), text = array.get("Data", "");
    if(encoding == "ASCII")
      return numbers_of_text(file_, text);
    if(encoding == "ExternalFileBinary")
      fail_to_read(file_.name(), "its arrays are in another file, " +
                                     in_quotes(xml_attribute(array, "ExternalFileName")) +
                                     ": save it as one file");
    std::string bytes = htl_window::bytes_of_base64(text);
    if(encoding == "GZipBase64Binary") {
      std::optional<std::string> all = unpacked(file_.name(), bytes);
      if(!all)
        fail_to_read(file_.name(), "an array is not a zlib stream");
      bytes = std::move(*all);
    } else if(encoding != "Base64Binary")
      fail_to_read(file_.name(), "an array has the unknown encoding " + in_quotes(encoding));
    return numbers_of_bytes(file_.name(), bytes, xml_attribute(array, "Endian") != "BigEndian",
                            reader_of(xml_attribute(array, "DataType")));
  }

  Read_number reader_of(const std::string& type) const {
    if(type == "NIFTI_TYPE_FLOAT32")
      return read_as<float>;
    if(type == "NIFTI_TYPE_FLOAT64")
      return read_as<double>;
    if(type == "NIFTI_TYPE_INT32")
      return read_as<std::int32_t>;
    if(type == "NIFTI_TYPE_UINT8")
      return read_as<std::uint8_t>;
    fail_to_read(file_.name(), "an array has the unknown type " + in_quotes(type));
  }

  const Input_file& file_;
  Soup soup_;
  bool has_points_ = false, has_triangles_ = false;
};

} // namespace

Soup read_gifti(const Input_file& file) { return Gifti_reader(file).read(); }

} // namespace htloops
