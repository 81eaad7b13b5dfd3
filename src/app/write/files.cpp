// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/files.h"

#include "file_names.h"
#include "interrupt.h"
#include "system/files.h"
#include "window/packing.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <system_error>

namespace htloops {
namespace {

namespace fs = std::filesystem;

// Beside the file. Not with its name, which may be as long as a name can be.
std::string name_of_temporary(const fs::path& destination) {
  static std::random_device random;
  return name_of_path(destination.parent_path() / ("htloops.part-" + std::to_string(random())));
}

bool is_dangling_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(fs::symlink_status(path, error)) && !fs::exists(path, error);
}

} // namespace

void fail_to_write(const std::string& target, const std::string& reason) {
  throw_if_interrupted(); // while it waited, or by who does not read any more
  throw Unwritable("cannot write " + printable(target) + ": " + reason);
}

void fail_to_write(const std::string& target) { fail_to_write(target, std::strerror(errno)); }

Open_file open_file(const std::string& file, const char* mode, const std::string& target) {
  Open_file opened(open(file, mode));
  if(!opened)
    fail_to_write(target);
  return opened;
}

std::string destination_of(const std::string& target) {
  constexpr int largest_number_of_links = 40;
  std::error_code error;
  fs::path path = path_of(target);
  for(int i = 0; i < largest_number_of_links && is_dangling_link(path); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  // Of a name alone, of which nothing exists, the canonical path would be no whole one.
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  return name_of_path(error ? path : canonical);
}

// A name under which a file appears complete or not at all. What is to be seen is written to
// `temporary()`, in the same folder, and renamed by `commit()`; without that it is removed.
// What is no regular file (a device, a pipe) is written in place.
class Staged_path
{
public:
  explicit Staged_path(const std::string& target)
      : target_(target) {
    std::error_code error;
    const fs::file_status status = fs::status(path_of(destination_), error);
    if(fs::is_directory(status))
      fail_to_write(target, "it is a folder");
    if(fs::exists(status) && !fs::is_regular_file(status)) {
      temporary_ = destination_;
      return;
    }
    if(is_dangling_link(path_of(destination_)))
      fail_to_write(target, "it is a dangling link");
    if(fs::exists(status)) // renaming would replace a read-only file without asking
      open_file(destination_, "r+b", target);
    unfinished_.emplace();
    const std::string temporary = name_of_temporary(path_of(destination_));
    open_file(temporary, "wbx", target);
    temporary_ = temporary;
    if(fs::exists(status))
      fs::permissions(path_of(temporary_), status.permissions(), error);
  }

  ~Staged_path() {
    if(!is_committed_ && !is_in_place()) {
      std::error_code error;
      fs::remove(path_of(temporary_), error);
    }
  }

  const std::string& target() const { return target_; }
  const std::string& temporary() const { return temporary_; }

  void commit() {
    if(!is_in_place()) {
      std::error_code error;
      fs::rename(path_of(temporary_), path_of(destination_), error);
      if(error)
        fail_to_write(target_, error.message());
    }
    is_committed_ = true;
  }

private:
  bool is_in_place() const { return temporary_ == destination_; }

  const std::string target_; // as the user named it
  const std::string destination_ =
      destination_of(target_); // with symbolic links followed, so that a link stays one
  std::string temporary_;
  bool is_committed_ = false;
  std::optional<Unfinished_file> unfinished_; // while there is something to remove
};

void check_writable(const std::string& target) {
  if(target != "-")
    Staged_path{target};
  throw_if_interrupted();
}

Text_writer::Text_writer(const std::string& target)
    : is_packed_(without_gz(target) != target) {
  if(target == "-")
    return;
  path_ = std::make_unique<Staged_path>(target);
  file_ = open_file(path_->temporary(), "wb", target);
}

Text_writer::~Text_writer() = default;

void Text_writer::flush() {
  throw_if_interrupted();
  if(std::fwrite(buffer_.data(), 1, buffer_.size(), path_ ? file_.get() : stdout) != buffer_.size())
    fail_to_write(path_ ? path_->target() : "the standard output");
  buffer_.clear();
}

void Text_writer::finish() {
  if(is_packed_)
    buffer_ = htl_window::deflated(buffer_, htl_window::Frame::GZIP);
  flush();
  if(!path_) {
    if(std::fflush(stdout) != 0)
      fail_to_write("the standard output");
    return;
  }
  // Only a successful close tells that the last bytes found room on the disk.
  if(std::fclose(file_.release()) != 0)
    fail_to_write(path_->target());
  path_->commit();
}

void write_text(const std::string& target, std::string_view text) {
  Text_writer out(target);
  out << text;
  out.finish();
}

} // namespace htloops
