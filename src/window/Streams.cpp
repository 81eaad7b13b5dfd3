// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Streams.h"

#include "base64.h"
#include "deflate.h"

namespace htl_window {

Packed packed(const std::vector<const Stream*>& streams) {
  Packed result;
  std::string bytes;
  for(const Stream* stream : streams) {
    bytes += stream->bytes();
    result.lengths.push_back(stream->bytes().size());
  }
  result.text = base64_of(deflated(bytes));
  return result;
}

} // namespace htl_window
