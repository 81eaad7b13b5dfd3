// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WORKSPACE_POOL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WORKSPACE_POOL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Workspaces that are large to make and cheap to use again: as many as are in use at one time.
template <typename Workspace> class Workspace_pool
{
public:
  explicit Workspace_pool(std::function<std::unique_ptr<Workspace>()> make)
      : make_(std::move(make)) {}

  /// lends a workspace until the returned object goes out of scope.
  auto borrow() {
    const auto give_back = [this](Workspace* workspace) {
      const std::lock_guard<std::mutex> lock(mutex_);
      free_.emplace_back(workspace);
    };
    return std::unique_ptr<Workspace, decltype(give_back)>(take().release(), give_back);
  }

private:
  std::unique_ptr<Workspace> take() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!free_.empty()) {
        std::unique_ptr<Workspace> workspace = std::move(free_.back());
        free_.pop_back();
        return workspace;
      }
    }
    return make_();
  }

  std::function<std::unique_ptr<Workspace>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> free_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WORKSPACE_POOL_H
