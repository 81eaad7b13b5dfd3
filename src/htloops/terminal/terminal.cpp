// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "terminal/terminal.h"

#include <cstdlib>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace htloops {

bool is_terminal(std::FILE* stream) {
#ifdef _WIN32
  return _isatty(_fileno(stream)) != 0;
#else
  return isatty(fileno(stream)) != 0;
#endif
}

bool use_colour(const std::string& when, std::FILE* stream) {
  if(when != "auto")
    return when == "always";
  const char* no_colour = std::getenv("NO_COLOR"); // see no-color.org
  return is_terminal(stream) && (no_colour == nullptr || *no_colour == '\0');
}

} // namespace htloops
