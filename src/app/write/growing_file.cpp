// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/growing_file.h"

#include "failure.h"
#include "file_names.h"
#include "interrupt.h"
#include "system/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace htloops {

namespace fs = std::filesystem;

Growing_file::Growing_file(const std::string& target, std::string header)
    : target_(target)
    , header_(std::move(header)) {}

std::string Growing_file::old_lines() const {
  std::error_code error;
  if(!fs::exists(path_of(target_), error))
    return "";
  if(!fs::is_regular_file(path_of(target_), error))
    throw wrong_usage(printable(target_) + " cannot be resumed: it is not a regular file");
  std::ifstream stream(path_of(target_), std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if(!stream.eof() && stream.fail())
    throw wrong_usage(printable(target_) + " cannot be resumed: it cannot be read");
  if(text.size() < header_.size() && header_.compare(0, text.size(), text) == 0)
    return "";
  if(text.compare(0, header_.size(), header_) != 0)
    throw wrong_usage(printable(target_) +
                      " cannot be resumed: its columns differ from those of these options");
  return text.substr(header_.size());
}

void Growing_file::go_on_after(const std::string& lines) {
  if(lines.empty())
    return;
  std::error_code error;
  size_ = header_.size() + lines.size();
  fs::resize_file(path_of(target_), size_, error);
  if(error)
    fail_to_write(target_, error.message());
}

std::FILE* Growing_file::stream() {
  if(target_ == "-")
    return stdout;
  if(file_)
    return file_.get();
  file_ = open_file(target_, size_ == 0 ? "wb" : "ab", target_);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  return file_.get();
}

// By one call of the system: who ends the program leaves all of it or nothing. What there was no
// room for is taken back.
void Growing_file::append(std::string_view lines) {
  throw_if_interrupted();
  const std::string text = (size_ == 0 ? header_ : "") + std::string(lines);
  std::FILE* const out = stream();
  if(std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0) {
    size_ += text.size();
    return;
  }
  const std::string reason = std::strerror(errno);
  std::error_code error;
  if(file_ && fs::is_regular_file(path_of(target_), error))
    fs::resize_file(path_of(target_), size_, error);
  fail_to_write(file_ ? target_ : "the standard output", reason);
}

} // namespace htloops
