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

namespace htloops {
namespace {

// For "auto" the first that there is of those that may be chosen so. A new backend is one more
// here, and a file that says what it is.
const Backend* const backends[] = {&automatic_backend, &cuda_backend, &host_backend,
                                   &reference_backend};

} // namespace

#ifndef CGAL_LINKED_WITH_CUDA
const Backend cuda_backend = {"cuda", false, nullptr, nullptr};
const Backend automatic_backend = {"auto", true, nullptr, nullptr};
#endif
#ifndef HTLOOPS_HAS_REFERENCE
const Backend reference_backend = {"reference", false, nullptr, nullptr};
#endif

const Backend& choose_backend(const std::string& name) {
  const bool is_automatic = name == automatic_backend.name;
  for(const Backend* backend : backends)
    if(backend->solve != nullptr &&
       (is_automatic ? backend->is_chosen_by_auto : name == backend->name))
      return *backend;
  throw Failure(Exit_code::NO_BACKEND, "this htloops was built without the backend " + name);
}

std::vector<std::string> names_of_backends() {
  std::vector<std::string> names;
  for(const Backend* backend : backends)
    names.push_back(backend->name);
  return names;
}

} // namespace htloops
