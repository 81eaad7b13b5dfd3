// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "system/console.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <memory>
#include <windows.h>

#include <shellapi.h> // after windows.h
#else
#include <fcntl.h>
#include <unistd.h>
#endif

namespace htloops {

#ifdef _WIN32

namespace {

std::string in_utf8(const wchar_t* text) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string utf8(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, utf8.data(), size, nullptr, nullptr);
  utf8.resize(utf8.size() - 1); // the zero
  return utf8;
}

} // namespace

bool is_terminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }

// Lines end as everywhere; the console takes UTF-8, and the codes of colours and of progress bars.
void prepare_standard_streams() {
  for(std::FILE* stream : {stdin, stdout, stderr})
    if(_fileno(stream) >= 0)
      _setmode(_fileno(stream), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  for(const DWORD number : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
    const HANDLE console = GetStdHandle(number);
    DWORD mode = 0;
    if(GetConsoleMode(console, &mode) != 0)
      SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
}

std::vector<std::string> words_of_command_line(int, char**) {
  int number = 0;
  const std::unique_ptr<wchar_t*, HLOCAL(WINAPI*)(HLOCAL)> words(
      CommandLineToArgvW(GetCommandLineW(), &number), LocalFree);
  std::vector<std::string> texts;
  for(int i = 1; i < number; ++i)
    texts.push_back(in_utf8(words.get()[i]));
  return texts;
}

#else

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

void prepare_standard_streams() {
  for(int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if(fcntl(stream, F_GETFD) == -1)
      open("/dev/null",
           stream == STDIN_FILENO ? O_WRONLY : O_RDONLY); // what it is for fails as before
}

std::vector<std::string> words_of_command_line(int argc, char** argv) {
  return argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>();
}

#endif

} // namespace htloops
