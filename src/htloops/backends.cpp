// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "backends.h"

#include "failure.h"
#include "host_backend.h"
#ifdef HTLOOPS_HAS_REFERENCE
#include "reference_backend.h"
#endif

#include <cstddef>

namespace htloops {
namespace {

#ifndef HTLOOPS_HAS_REFERENCE
constexpr std::nullptr_t solve_by_reference = nullptr;
#endif

// The fastest first. A new backend is a line here and a function that solves.
constexpr Backend backends[] = {
    {"cuda", true, false, nullptr},
    {"host", true, false, solve_on_host},
    {"reference", false, true, solve_by_reference},
};

const char automatic[] = "auto";

} // namespace

const Backend& choose_backend(const std::string& name) {
  for(const Backend& backend : backends)
    if(backend.solve != nullptr &&
       (name == automatic ? backend.is_chosen_by_auto : name == backend.name))
      return backend;
  throw Failure(Exit_code::NO_BACKEND, "this htloops was built without the backend " + name);
}

std::vector<std::string> names_of_backends() {
  std::vector<std::string> names = {automatic};
  for(const Backend& backend : backends)
    names.push_back(backend.name);
  return names;
}

} // namespace htloops
