// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "arrays.h"
#include "functions.h"
#include "watch.h"

#include "generators/generators.h"

#include <map>
#include <string>

namespace htl_python {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

const generators::Kind& kind_of(const std::string& name) {
  std::string names;
  for(const generators::Kind& kind : generators::kinds()) {
    if(name == kind.name)
      return kind;
    names += std::string(names.empty() ? "" : ", ") + kind.name;
  }
  throw std::invalid_argument("there is no kind '" + name + "' of test meshes; the kinds are " +
                              names);
}

py::tuple generate(const std::string& name, const py::dict& given, const Watch& watch) {
  const generators::Kind& kind = kind_of(name);
  generators::Request request;
  generators::Hole_request holes;
  request.faces = kind.default_faces;
  request.genus = kind.default_genus;
  const std::map<std::string, std::size_t*> numbers = {
      {"faces", &request.faces},     {"genus", &request.genus},
      {"parts", &request.parts},     {"long_way", &request.p},
      {"short_way", &request.q},     {"frequency", &request.frequency},
      {"bridges", &request.bridges}, {"tunnels", &request.tunnels},
      {"necks", &request.necks},     {"holes", &holes.number},
      {"hole_faces", &holes.faces}};
  for(const auto& [key, value] : given) {
    const auto option = py::cast<std::string>(key);
    const auto number = numbers.find(option);
    if(option == "seed")
      request.seed = py::cast<unsigned>(value);
    else if(number != numbers.end())
      *number->second = py::cast<std::size_t>(value);
    else
      throw py::type_error("generate() has no option '" + option + "'");
  }
  const generators::Soup soup = compute(0, watch, [&] {
    const generators::Watch_guard guard([](std::size_t) { htloops::throw_if_interrupted(); });
    generators::Soup whole = generators::make(kind, request);
    return holes.number > 0 ? generators::with_holes(whole, holes) : whole;
  });
  return py::make_tuple(rows_of<double>(soup.points), rows_of<std::int64_t>(soup.triangles));
}

py::dict kinds() {
  py::dict kinds;
  for(const generators::Kind& kind : generators::kinds())
    kinds[kind.name] = kind.description;
  return kinds;
}

} // namespace

void add_generators(py::module_& module) {
  module.def("generate", &generate);
  module.def("kinds", &kinds);
}

} // namespace htl_python
