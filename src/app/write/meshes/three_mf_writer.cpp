// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "numbers.h"
#include "write/Zip_archive.h"
#include "write/meshes/writers.h"

#include <utility>

namespace htloops {
namespace {

constexpr char types[] =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";

constexpr char relations[] =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

std::string model_of(const Written_mesh& written) {
  const Unit unit = written.facts.unit == Unit::NONE ? Unit::MILLIMETER : written.facts.unit;
  std::string model =
      R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit=")" +
      std::string(words_of(unit).name) +
      R"(" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">htloops</metadata>
<resources><object id="1" type="model"><mesh>
<vertices>
)";
  const auto add_row = [&model](const char* element, const auto& names, const auto& row) {
    model += element;
    for(std::size_t i = 0; i < 3; ++i) {
      model += names[i];
      append_number(model, static_cast<double>(row[i]));
      model += '"';
    }
    model += "/>\n";
  };
  constexpr const char* places[] = {" x=\"", " y=\"", " z=\""};
  constexpr const char* corners[] = {" v1=\"", " v2=\"", " v3=\""};
  for(const auto& point : written.mesh.points)
    add_row("<vertex", places, point);
  model += "</vertices>\n<triangles>\n";
  for(const auto& triangle : written.mesh.triangles)
    add_row("<triangle", corners, triangle);
  return model +
         "</triangles>\n</mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n"
         "</model>\n";
}

} // namespace

void write_3mf(Text_writer& out, const Written_mesh& written) {
  Zip_archive archive;
  archive.add("[Content_Types].xml", types);
  archive.add("_rels/.rels", relations);
  archive.add("3D/3dmodel.model", model_of(written));
  out << std::move(archive).finish();
}

} // namespace htloops
