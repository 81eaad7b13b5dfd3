// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FILE_NAMES_H
#define HTLOOPS_FILE_NAMES_H

#include <cstddef>
#include <string>
#include <string_view>

namespace htloops {

// The name of a file may be of any bytes. What cannot stand in a text is written as a C program
// would: \n, \x1B, \xE9, \u202E. What is harmless stays as it is; doing it twice is doing it once.

/// as it can stand in a document: bytes that are no UTF-8 are written out.
std::string as_utf8(std::string_view name);

/// as a person can be shown it, on one line: so are characters that a terminal obeys, line breaks,
/// and those that turn the direction of writing.
std::string printable(std::string_view name);

/// the same of a message that has names in it, and lines of its own.
std::string printable_lines(std::string_view message);

/// how many characters it has, which is how wide it is, nearly.
std::size_t number_of_characters(std::string_view text);

} // namespace htloops

#endif // HTLOOPS_FILE_NAMES_H
