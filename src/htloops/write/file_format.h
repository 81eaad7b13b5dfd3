// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FILE_FORMAT_H
#define HTLOOPS_FILE_FORMAT_H

#include "failure.h"
#include "write/text_writer.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace htloops {

/// How the names of files of a format end, and what writes one; the first argument of `Writer` is
/// the `Text_writer`.
template <typename Writer> struct File_format
{
  std::string_view suffix;
  Writer* write;
};

/// the one of some formats that the name of a file tells; throws `Failure` if it tells none.
template <typename Writer, std::size_t n>
const File_format<Writer>& format_of(const std::string& file,
                                     const File_format<Writer> (&formats)[n]) {
  std::string known;
  for(const File_format<Writer>& format : formats) {
    if(file.size() > format.suffix.size() && boost::algorithm::iends_with(file, format.suffix))
      return format;
    known += " " + std::string(format.suffix);
  }
  throw Failure(Exit_code::WRONG_USAGE,
                "cannot write " + file + ": the name must end in one of" + known);
}

/// writes a file in the one of some formats that its name tells.
template <typename Writer, std::size_t n, typename... Contents>
void write_file(const std::string& file,
                const File_format<Writer> (&formats)[n],
                const Contents&... contents) {
  Text_writer out(file);
  format_of(file, formats).write(out, contents...);
  out.finish();
}

} // namespace htloops

#endif // HTLOOPS_FILE_FORMAT_H
