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
#include "file_names.h"
#include "numbers.h"

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

/// throws the `Failure` of a file that cannot be written, `Interrupted` if a signal is why.
[[noreturn]] void fail_to_write(const std::string& target, const std::string& reason);
[[noreturn]] void fail_to_write(const std::string& target); ///< as `errno` says

struct Close_stream
{
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};

using Open_file = std::unique_ptr<std::FILE, Close_stream>;

/// opens a file as `std::fopen()` does, to write `target`; throws as `fail_to_write()` does.
Open_file open_file(const std::string& file, const char* mode, const std::string& target);

/// Words and numbers, one after the other. A number reads back as exactly itself.
class Text
{
public:
  Text() = default;
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;
  virtual ~Text() = default;

  Text& operator<<(std::string_view text) {
    buffer_ += text;
    return check_room();
  }

  Text& operator<<(const char* text) { return *this << std::string_view(text); }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number>, Text&> operator<<(Number value) {
    if constexpr(std::is_same_v<Number, char>)
      buffer_ += value;
    else if constexpr(std::is_integral_v<Number>)
      buffer_ += std::to_string(value);
    else
      append_number(buffer_, value);
    return check_room();
  }

  /// all of it, unless it goes elsewhere as it comes.
  const std::string& all() const { return buffer_; }

protected:
  std::string buffer_;

private:
  Text& check_room() {
    constexpr std::size_t buffer_size = std::size_t(1) << 18;
    if(buffer_.size() >= buffer_size)
      make_room();
    return *this;
  }

  /// moves what there is to where it goes.
  virtual void make_room() {}
};

class Staged_path;

/// A text file written through a buffer; it appears under its name when `finish()` is called,
/// packed by gzip if the name ends so. The name "-" is the standard output. Throws `Failure` when
/// the file cannot be written, on a full disk for example, and `Interrupted` on Ctrl-C.
class Text_writer : public Text
{
public:
  explicit Text_writer(const std::string& target);
  ~Text_writer() override;

  void finish();

private:
  void make_room() override {
    if(!is_packed_)
      flush();
  }

  void flush();

  std::unique_ptr<Staged_path> path_; // none for the standard output
  Open_file file_; // the same; closed first, as not every system removes an open file
  bool is_packed_;
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
  throw wrong_usage("cannot write " + printable(file) + ": the name must end in" +
                    (n == 1 ? "" : " one of") + known);
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
