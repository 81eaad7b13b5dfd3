// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "window/base64.h"
#include "window/packing.h"
#include "write/bytes.h"
#include "write/meshes/single_precision.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htloops {
namespace {

template <typename Written, typename Number>
void write_array(Text_writer& out,
                 const char* intent,
                 const char* type,
                 const std::vector<std::array<Number, 3>>& rows,
                 const char* space,
                 Number scale = 1) {
  std::string bytes;
  for(const auto& row : rows)
    for(const Number x : row)
      append_bytes(bytes, static_cast<Written>(scale * x));
  out << "<DataArray Intent=\"NIFTI_INTENT_" << intent << "\" DataType=\"NIFTI_TYPE_" << type
      << "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"" << rows.size()
      << "\" Dim1=\"3\" Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" "
         "ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData></MetaData>\n"
      << space << "<Data>"
      << htl_window::base64_of(htl_window::deflated(bytes, htl_window::Frame::ZLIB))
      << "</Data>\n</DataArray>\n";
}

constexpr char same_space[] =
    "<CoordinateSystemTransformMatrix>\n<DataSpace>NIFTI_XFORM_UNKNOWN</DataSpace>\n"
    "<TransformedSpace>NIFTI_XFORM_UNKNOWN</TransformedSpace>\n"
    "<MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData>\n"
    "</CoordinateSystemTransformMatrix>\n";

} // namespace

void write_gifti(Text_writer& out, const Written_mesh& written) {
  const double scale = scale_to_millimeters(written);
  check_single_precision(written, scale);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
         "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n<MetaData></MetaData>\n"
         "<LabelTable></LabelTable>\n";
  write_array<float>(out, "POINTSET", "FLOAT32", written.mesh.points, same_space, scale);
  write_array<std::int32_t>(out, "TRIANGLE", "INT32", written.mesh.triangles, "");
  out << "</GIFTI>\n";
}

} // namespace htloops
