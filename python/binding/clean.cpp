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

#include "app/clean/soup_cleaning.h"
#include "app/failure.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htl_python {
namespace {

using namespace py::literals;
using htloops::Clean_options;
using htloops::Clean_record;
using htloops::Clean_step;
using htloops::Relative_length;

// A length, and whether it is a share of the diagonal.
using Length = std::pair<double, bool>;

std::optional<Relative_length> relative(const std::optional<Length>& length) {
  return length ? std::optional(Relative_length{length->first, length->second}) : std::nullopt;
}

Clean_options clean_options(const py::dict& chosen) {
  Clean_options options;
  const auto skipped = py::cast<std::vector<std::string>>(chosen["skip"]);
  for(std::size_t i = 0; i < htloops::number_of_clean_steps; ++i)
    for(const std::string& name : skipped)
      if(name == htloops::name_of(static_cast<Clean_step>(i)))
        options.steps.reset(i);
  options.channel_length = relative(py::cast<std::optional<Length>>(chosen["channels"]));
  options.floater_share = py::cast<double>(chosen["floaters"]);
  options.genus = py::cast<std::optional<std::size_t>>(chosen["genus"]);
  options.noise_below = relative(py::cast<std::optional<Length>>(chosen["noise_below"]));
  options.is_sure = py::cast<bool>(chosen["force"]);
  return options;
}

py::dict words_of(const htloops::Mesh_state& state) {
  return py::dict("vertices"_a = state.vertices, "faces"_a = state.faces, "parts"_a = state.parts,
                  "boundaries"_a = state.boundaries, "genus"_a = state.genus,
                  "crossings"_a = state.crossings,
                  "volume"_a = state.boundaries == 0 ? py::object(py::float_(state.volume))
                                                     : py::object(py::none()));
}

py::dict words_of(const Clean_record& record) {
  return py::dict("step"_a = htloops::name_of(record.step), "count"_a = record.count,
                  "done"_a = record.done, "left"_a = record.left);
}

py::tuple clean(const py::array& points,
                const std::vector<py::array>& faces,
                const py::dict& chosen,
                int threads,
                Watch& watch) {
  Clean_options options = clean_options(chosen);
  options.number_of_threads = threads;
  const std::optional<Relative_length> weld =
      relative(py::cast<std::optional<Length>>(chosen["weld"]));
  htloops::Soup soup = soup_of(points, faces);
  const htloops::Cleaned_soup cleaned = compute(threads, watch, [&] {
    try {
      return htloops::clean(std::move(soup), options, weld, watch);
    } catch(const htloops::Failure& failure) {
      if(failure.code() == htloops::Exit_code::WRONG_USAGE)
        throw;
      throw Mesh_error(failure.what());
    }
  });
  py::list steps;
  for(const Clean_record& record : cleaned.records)
    steps.append(words_of(record));
  const py::tuple arrays = arrays_of(cleaned.mesh);
  return py::make_tuple(arrays[0], arrays[1], array_of(cleaned.face_origins),
                        py::dict("closed"_a = cleaned.is_closed(),
                                 "before"_a = words_of(cleaned.before),
                                 "after"_a = words_of(cleaned.after), "steps"_a = steps,
                                 "vertex_origin"_a = array_of(cleaned.vertex_origins),
                                 "face_parent"_a = array_of(cleaned.face_parents)));
}

} // namespace

void add_cleaning(py::module_& module) { module.def("clean", &clean); }

} // namespace htl_python
