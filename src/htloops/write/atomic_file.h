// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ATOMIC_FILE_H
#define HTLOOPS_ATOMIC_FILE_H

#include "terminal/interrupt.h"

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

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

} // namespace htloops

#endif // HTLOOPS_ATOMIC_FILE_H
