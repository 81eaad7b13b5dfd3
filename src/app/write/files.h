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
#include "interrupt.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace htloops {

/// the file that writing to `target` is to change: at the end of its symbolic links, whether or not
/// there is anything.
std::string destination_of(const std::string& target);

/// A name under which a file appears complete or not at all. What is to be seen is written to
/// `temporary()`, in the same folder, and renamed by `commit()`; without that it is removed.
/// What is no regular file (a device, a pipe) is written in place.
class Staged_path
{
public:
  /// throws `Failure` if there is no way to write `target`.
  explicit Staged_path(const std::string& target);
  ~Staged_path();
  Staged_path(const Staged_path&) = delete;
  Staged_path& operator=(const Staged_path&) = delete;

  const std::string& target() const { return target_; }
  const std::string& temporary() const { return temporary_; }

  void commit();

private:
  bool is_in_place() const { return temporary_ == destination_; }

  std::string target_;      // as the user named it
  std::string destination_; // with symbolic links followed, so that a link stays one
  std::string temporary_;
  bool is_committed_ = false;
  std::optional<Unfinished_file> unfinished_; // while there is something to remove
};

/// A file written through `Staged_path`; the name "-" is the standard output.
class Atomic_file
{
public:
  explicit Atomic_file(const std::string& target);
  ~Atomic_file();
  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  /// throws `Failure` if not everything could be written, on a full disk for example.
  void write(const char* data, std::size_t size);

  /// makes what has been written to the standard output visible.
  void show() {
    if(!path_)
      std::fflush(stream_);
  }

  /// closes the file and gives it its name; throws like `write()`.
  void commit();

private:
  std::optional<Staged_path> path_; // none for the standard output
  std::FILE* stream_;               // null when closed
};

/// throws `Failure` if a file of that name could not be written now, and `Interrupted` if a signal
/// came meanwhile; leaves no trace.
void check_writable(const std::string& target);

/// appends the shortest decimal number that reads back as exactly `value`.
void append_number(std::string& text, double value);

/// A text file written through a buffer; it appears under its name when `finish()` is called.
/// Throws `Failure` when the file cannot be written and `Interrupted` on Ctrl-C.
class Text_writer
{
public:
  explicit Text_writer(const std::string& target)
      : file_(target) {}

  Text_writer& operator<<(std::string_view text) {
    buffer_ += text;
    return flush_if_full();
  }

  Text_writer& operator<<(const char* text) { return *this << std::string_view(text); }

  Text_writer& operator<<(char c) {
    buffer_ += c;
    return *this;
  }

  Text_writer& operator<<(double value) {
    append_number(buffer_, value);
    return flush_if_full();
  }

  template <typename Integer>
  std::enable_if_t<std::is_integral_v<Integer>, Text_writer&> operator<<(Integer value) {
    buffer_ += std::to_string(value);
    return flush_if_full();
  }

  void finish();

  /// makes what has been written visible now, where there is a name for it already: on the standard
  /// output.
  void show();

private:
  static constexpr std::size_t buffer_size = std::size_t(1) << 18;

  Text_writer& flush_if_full() {
    if(buffer_.size() >= buffer_size)
      flush();
    return *this;
  }

  void flush();

  Atomic_file file_;
  std::string buffer_;
};

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

#endif // HTLOOPS_FILES_H
