// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "system/files.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#endif

namespace htloops {

#ifdef _WIN32

std::FILE* open(const std::string& name, const char* mode) {
  const std::filesystem::path path = path_of(name);
  const std::string letters = mode;
  if(letters.find('x') == std::string::npos)
    return _wfopen(path.c_str(), std::wstring(letters.begin(), letters.end()).c_str());
  const int file =
      _wopen(path.c_str(), _O_CREAT | _O_EXCL | _O_WRONLY | _O_BINARY, _S_IREAD | _S_IWRITE);
  return file == -1 ? nullptr : _fdopen(file, "wb");
}

#else

std::FILE* open(const std::string& name, const char* mode) {
  return std::fopen(name.c_str(), mode);
}

#endif

} // namespace htloops
