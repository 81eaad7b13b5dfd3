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
#include "file_names.h"
#include "interrupt.h"
#include "read/unpacking.h"
#include "system/files.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

namespace htloops {
namespace {

[[noreturn]] void fail(const std::string& file) {
  throw_if_interrupted(); // while it waited
  throw Failure(Exit_code::UNREADABLE_FILE,
                "cannot read " + printable(file) + ": " + std::strerror(errno));
}

std::string read_to_the_end(std::FILE* stream, std::size_t expected_size, const std::string& name) {
  constexpr std::size_t piece = std::size_t(1) << 24; // to look for interrupts in between
  std::string content;
  std::size_t size = 0;
  // One byte more than expected, so that a file that has not grown needs no more room.
  content.reserve(expected_size + 1);
  for(;;) {
    if(size == content.capacity())
      content.reserve(2 * size);
    content.resize((std::min)(content.capacity(), size + piece));
    const std::size_t n = std::fread(&content[size], 1, content.size() - size, stream);
    throw_if_interrupted();
    if(n == 0)
      break;
    size += n;
  }
  if(std::ferror(stream)) // of a folder, for example, which opens on some systems
    fail(name);
  content.resize(size);
  return content;
}

std::string read_whole_file(const std::string& file) {
  constexpr std::size_t some = std::size_t(1) << 20;
  if(file == "-")
    return read_to_the_end(stdin, some, "the standard input");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(open(file, "rb"), std::fclose);
  if(!stream)
    fail(file);
  std::error_code error; // of what is no regular file
  const std::uintmax_t size = std::filesystem::file_size(path_of(file), error);
  return read_to_the_end(stream.get(), error ? some : static_cast<std::size_t>(size), file);
}

} // namespace

Input_file::Input_file(std::string name, const std::string& format)
    : name_(name == "-" ? "the standard input" : printable(name))
    , path_(name)
    , format_(format.empty() ? "" : "." + format) {
  set_content(read_whole_file(name));
}

void Input_file::set_content(std::string content) {
  if(content.compare(0, 2, "\x1F\x8B") == 0) {
    std::optional<std::string> bytes = unpacked(name_, content);
    if(!bytes)
      fail_to_read(name_, "its gzip data is damaged or truncated");
    content = std::move(*bytes);
  }
  if(content.empty())
    fail_to_read(name_, path_ == "-" ? "it is empty" : "the file is empty");
  content_ = std::make_shared<const std::string>(std::move(content));
}

bool Input_file::is_of_format(std::string_view extension) const {
  if(!format_.empty())
    return format_ == extension;
  std::string_view name = name_;
  if(boost::algorithm::iends_with(name, ".gz"))
    name.remove_suffix(3);
  return boost::algorithm::iends_with(name, extension);
}

void fail_to_read(const std::string& file, const std::string& problem) {
  throw Failure(Exit_code::UNREADABLE_FILE, file + ": " + problem);
}

} // namespace htloops
