// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/input_file.h"

#include "failure.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace htloops {
namespace {

[[noreturn]] void fail(const std::string& file) {
  throw Failure(Exit_code::UNREADABLE_FILE, "cannot read " + file + ": " + std::strerror(errno));
}

struct Close_file
{
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};

std::string read_whole_file(const std::string& file) {
  const std::unique_ptr<std::FILE, Close_file> stream(std::fopen(file.c_str(), "rb"));
  if(!stream)
    fail(file);
  std::error_code error; // of what is no regular file
  const std::uintmax_t expected_size = std::filesystem::file_size(file, error);
  std::string content;
  std::size_t size = 0;
  // One byte more than expected, so that a file that has not grown is read in one go.
  content.resize(error ? std::size_t(1) << 20 : static_cast<std::size_t>(expected_size) + 1);
  while(const std::size_t n = std::fread(&content[size], 1, content.size() - size, stream.get())) {
    size += n;
    if(size == content.size())
      content.resize(2 * size);
  }
  if(std::ferror(stream.get())) // of a folder, for example, which opens on some systems
    fail(file);
  content.resize(size);
  return content;
}

} // namespace

Input_file::Input_file(std::string name)
    : name_(std::move(name))
    , content_(read_whole_file(name_)) {}

void fail_to_read(const std::string& file, const std::string& problem) {
  throw Failure(Exit_code::UNREADABLE_FILE, file + ": " + problem);
}

} // namespace htloops
