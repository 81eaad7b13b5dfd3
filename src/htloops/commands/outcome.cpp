// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/outcome.h"

#include "failure.h"
#include "terminal/interrupt.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <exception>
#include <new>

namespace htloops {
namespace {

Outcome ended_by(Exit_code code, const char* message) { return {static_cast<int>(code), message}; }

Outcome interrupted() {
  return {128 + interrupting_signal(), "interrupted, nothing more is written"};
}

} // namespace

Outcome outcome_of(const std::function<void()>& action) {
  using namespace CGAL::Handle_tunnel_loops;
  try {
    action();
    return {};
  } catch(const Failure& failure) {
    return ended_by(failure.code(), failure.what());
  } catch(const Interrupted&) {
    return interrupted();
  } catch(const Interrupted_exception&) {
    return interrupted();
  } catch(const Invalid_mesh_exception& exception) {
    return ended_by(Exit_code::UNACCEPTABLE_MESH, exception.what());
  } catch(const Invalid_function_exception& exception) {
    return ended_by(Exit_code::WRONG_USAGE, exception.what());
  } catch(const std::bad_alloc&) {
    return ended_by(Exit_code::NOT_CERTIFIED, "out of memory");
  } catch(const std::exception& exception) {
    return ended_by(Exit_code::NOT_CERTIFIED, exception.what());
  }
}

} // namespace htloops
