// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FILES_H
#define HTLOOPS_FILES_H

#include "failure.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace htloops {

/// the file that writing to `target` is to change: at the end of its symbolic links, whether or not
/// there is anything.
std::string destination_of(const std::string& target);

/// throws `Failure` if a file of that name could not be written now, and `Interrupted` if a signal
/// came meanwhile; leaves no trace.
void check_writable(const std::string& target);

/// appends the shortest decimal number that reads back as exactly `value`.
void append_number(std::string& text, double value);

class Staged_path;

/// A text file written through a buffer; it appears under its name when `finish()` is called,
/// packed by gzip if the name ends so. The name "-" is the standard output. Throws `Failure` when
/// the file cannot be written, on a full disk for example, and `Interrupted` on Ctrl-C.
class Text_writer
{
public:
  explicit Text_writer(const std::string& target);
  ~Text_writer();

  Text_writer& operator<<(std::string_view text) {
    buffer_ += text;
    return flush_if_full();
  }

  Text_writer& operator<<(const char* text) { return *this << std::string_view(text); }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number>, Text_writer&> operator<<(Number value) {
    if constexpr(std::is_same_v<Number, char>)
      buffer_ += value;
    else if constexpr(std::is_integral_v<Number>)
      buffer_ += std::to_string(value);
    else
      append_number(buffer_, value);
    return flush_if_full();
  }

  void finish();

  /// makes what has been written visible now, where there is a name for it already: on the standard
  /// output.
  void show();

private:
  Text_writer& flush_if_full() {
    constexpr std::size_t buffer_size = std::size_t(1) << 18;
    if(buffer_.size() >= buffer_size && !is_packed_)
      flush();
    return *this;
  }

  void flush();

  std::unique_ptr<Staged_path> path_; // none for the standard output
  std::FILE* stream_;                 // null when closed
  bool is_packed_;
  std::string buffer_;
};

/// writes a file of one text.
void write_text(const std::string& target, std::string_view text);

/// How the names of files of a format end, and what writes one; the first argument of `Writer` is
/// the `Text_writer`.
template <typename Writer> struct File_format
{
  std::string_view suffix;
  Writer* write;
};

/// the name of a file without the end that says that gzip packs it.
inline std::string_view without_gz(std::string_view file) {
  return file.substr(0, file.size() - (boost::algorithm::iends_with(file, ".gz") ? 3 : 0));
}

/// the one of some formats that the name of a file tells, packed by gzip or not; throws `Failure`
/// if it tells none.
template <typename Writer, std::size_t n>
const File_format<Writer>& format_of(const std::string& file,
                                     const File_format<Writer> (&formats)[n]) {
  std::string known;
  const std::string_view name = without_gz(file);
  for(const File_format<Writer>& format : formats) {
    if(name.size() > format.suffix.size() && boost::algorithm::iends_with(name, format.suffix))
      return format;
    known += " " + std::string(format.suffix);
  }
  throw wrong_usage("cannot write " + file + ": the name must end in one of" + known);
}

/// throws the same; without a name, nothing is to be written.
template <typename Writer, std::size_t n>
void check_format(const std::string& file, const File_format<Writer> (&formats)[n]) {
  if(!file.empty())
    format_of(file, formats);
}

/// the same of the only format that there is.
inline void check_suffix(const std::string& file, std::string_view suffix) {
  const File_format<void()> formats[] = {{suffix, nullptr}};
  check_format(file, formats);
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

#endif // HTLOOPS_FILES_H
