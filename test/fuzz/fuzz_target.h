// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_FUZZ_TARGET_H
#define HTL_FUZZ_TARGET_H

#include <cstdio>
#include <cstdlib>
#include <string>

// What a target does with an input. It returns, whatever that is.
void fuzz_mesh_file(const std::string& format, const std::string& input);
void fuzz_loops_json(const std::string& input);
void fuzz_complexes(const std::string& input);

/// hands the input to the target of that name: loops_json, complexes, or a format of mesh files.
inline void fuzz(const std::string& target, const std::string& input) {
  if(target == "loops_json")
    fuzz_loops_json(input);
  else if(target == "complexes")
    fuzz_complexes(input);
  else
    fuzz_mesh_file(target, input);
}

/// ends the program if something does not hold.
inline void require(bool condition, const char* what) {
  if(condition)
    return;
  std::fprintf(stderr, "this does not hold: %s\n", what);
  std::abort();
}

#endif // HTL_FUZZ_TARGET_H
