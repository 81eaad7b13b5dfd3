// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WEB_LANDING_PADS_H
#define HTL_WEB_LANDING_PADS_H

// Included before all else where WebAssembly has threads. What a landing pad and the library of
// exceptions tell each other, each thread needs for itself. So has the library it; Clang before 15
// takes what it finds under this name, and one place for all threads if it finds nothing.
#ifdef __cplusplus

extern "C" {

struct Htl_landing_pad
{
  unsigned index;
  const char* table;
  unsigned selector;
};

extern __thread Htl_landing_pad __wasm_lpad_context __attribute__((tls_model("local-exec")));

__attribute__((used)) inline void* htl_landing_pad() { return &__wasm_lpad_context; }
}

#endif

#endif
