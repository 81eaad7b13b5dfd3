// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/self_contact.h"

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>

#include <CGAL/tags.h>

namespace htloops {
namespace {

namespace internal = CGAL::Handle_tunnel_loops::internal;

class Watch_by_function final : public internal::Watch
{
public:
  explicit Watch_by_function(const std::function<void()>& look)
      : look_(look) {}

  void look() override { look_(); }

private:
  const std::function<void()>& look_;
};

} // namespace

bool touches_itself(const Mesh& mesh, const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<CGAL::Parallel_if_available_tag>();
  return internal::touches_itself(execution.watched_by(watch), mesh, get(CGAL::vertex_point, mesh),
                                  get(boost::vertex_index, mesh));
}

} // namespace htloops
