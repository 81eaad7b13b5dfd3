// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EVENTS_WRITER_H
#define HTLOOPS_EVENTS_WRITER_H

#include "solve/answer.h"

#include <string>

namespace htloops {

/// writes the events of the fronts as JSON, format "htloops-events/1"; `target` may be "-". Only
/// the reference solver knows of a resolution. Throws `Failure` if the file cannot be written.
void write_events(const std::string& target, const Answer& answer);

} // namespace htloops

#endif // HTLOOPS_EVENTS_WRITER_H
