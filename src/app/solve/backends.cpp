// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/backends.h"

#include "failure.h"
#include "solve/solvers.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace htloops {
namespace {

#ifndef CGAL_LINKED_WITH_CUDA
constexpr std::nullptr_t solve_on_device = nullptr, solve_on_device_if_available = nullptr;
constexpr std::nullptr_t diffuse_on_device = nullptr, diffuse_on_device_if_available = nullptr;
#endif
#ifndef HTLOOPS_HAS_REFERENCE
constexpr std::nullptr_t solve_by_reference = nullptr, diffuse_by_reference = nullptr;
#endif

// For "auto" the first that there is of those that may be chosen so. A new backend is a line here
// and a function that solves.
constexpr Backend backends[] = {
    {"auto", true, solve_on_device_if_available, diffuse_on_device_if_available},
    {"cuda", false, solve_on_device, diffuse_on_device},
    {"host", true, solve_on_host, diffuse_on_host},
    {"reference", false, solve_by_reference, diffuse_by_reference},
};

} // namespace

const Backend& choose_backend(const std::string& name) {
  const bool is_automatic = name == backends[0].name;
  for(const Backend& backend : backends)
    if(backend.solve != nullptr &&
       (is_automatic ? backend.is_chosen_by_auto : name == backend.name))
      return backend;
  throw Failure(Exit_code::NO_BACKEND, "this htloops was built without the backend " + name);
}

bool has_backend(const std::string& name) {
  return std::any_of(std::begin(backends), std::end(backends), [&](const Backend& backend) {
    return backend.solve != nullptr && name == backend.name;
  });
}

std::vector<std::string> names_of_backends() {
  std::vector<std::string> names;
  for(const Backend& backend : backends)
    names.push_back(backend.name);
  return names;
}

} // namespace htloops
