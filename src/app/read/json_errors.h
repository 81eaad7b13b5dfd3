// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_JSON_ERRORS_H
#define HTLOOPS_JSON_ERRORS_H

#include <string>
#include <string_view>

namespace htloops {

/// says what the JSON library says of a text that is no JSON: where, what stands there, and what is
/// expected instead. Other messages are returned as they are.
std::string words_of_json_error(const std::string& message, std::string_view text);

} // namespace htloops

#endif // HTLOOPS_JSON_ERRORS_H
