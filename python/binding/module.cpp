// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// The module that the package handle_tunnel_loops is a face of. It takes and returns arrays; what
// they are called and what can be asked of them is said in Python.

#include "files.h"
#include "generate.h"
#include "loops.h"
#include "reeb.h"
#include "surgery.h"
#include "waiting.h"

#include "htloops/failure.h"
#include "htloops/version.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <pybind11/stl.h>

namespace {

namespace py = pybind11;
namespace htl = CGAL::Handle_tunnel_loops;

// What the library throws, as exceptions of Python; the last one to be registered is asked first.
void register_exceptions(py::module_& module) {
  py::register_exception<htl::Interrupted_exception>(module, "Interrupted", PyExc_RuntimeError);
  py::register_exception<htl_python::Mesh_error>(module, "MeshError", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch(const htloops::Failure& failure) {
      const bool is_file = failure.code() == htloops::Exit_code::UNREADABLE_FILE;
      PyErr_SetString(is_file ? PyExc_OSError : PyExc_ValueError, failure.what());
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, module) {
  module.attr("version") = htloops::version();
  register_exceptions(module);
  py::module_::import("atexit").attr("register")(py::cpp_function(&htl_python::stop_waiting));
  module.def("read", &htl_python::read);
  module.def("repair", &htl_python::repair);
  module.def("loops", &htl_python::find_loops);
  module.def("certify", &htl_python::certify);
  module.def("write_page", &htl_python::write_page);
  module.def("reeb", &htl_python::find_reeb_graph);
  module.def("remove_handles", &htl_python::remove_handles);
  module.def("cut_to_disk", &htl_python::cut_to_disk);
  module.def("dual_cuts", &htl_python::dual_cuts);
  module.def("generate", &htl_python::generate);
  module.def("kinds", &htl_python::kinds);
}
