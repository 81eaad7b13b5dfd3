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

#include "app/failure.h"
#include "app/version.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <exception>

namespace {

namespace py = pybind11;
namespace htl = CGAL::Handle_tunnel_loops;

void register_exceptions(py::module_& module) {
  py::register_exception<htl::Interrupted_exception>(module, "Interrupted", PyExc_RuntimeError);
  py::register_exception<htl_python::Mesh_error>(module, "MeshError", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch(const htloops::Failure& failure) {
      const bool is_file = failure.code() == htloops::Exit_code::UNREADABLE_FILE ||
                           dynamic_cast<const htloops::Unwritable*>(&failure) != nullptr;
      PyErr_SetString(is_file ? PyExc_OSError : PyExc_ValueError, failure.what());
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, module) {
  module.attr("version") = htloops::version();
  register_exceptions(module);
  py::class_<htl_python::Watch>(module, "Watch")
      .def(py::init<>())
      .def("stop", &htl_python::Watch::stop)
      .def_property_readonly("fraction", &htl_python::Watch::fraction);
  htl_python::add_cleaning(module);
  htl_python::add_drawing(module);
  htl_python::add_files(module);
  htl_python::add_generators(module);
  htl_python::add_loops(module);
  htl_python::add_reeb(module);
  htl_python::add_skeleton(module);
  htl_python::add_surgery(module);
  htl_python::add_throats(module);
}
