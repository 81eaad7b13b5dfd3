// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "fuzz_target.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
#ifdef HTL_FUZZED_FORMAT
  fuzz_mesh_file(HTL_FUZZED_FORMAT, input);
#else
  HTL_FUZZED_FUNCTION(input);
#endif
  return 0;
}
