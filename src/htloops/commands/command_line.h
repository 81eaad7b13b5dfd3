// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_COMMAND_LINE_H
#define HTLOOPS_COMMAND_LINE_H

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace htloops {

// What the command line has, as completions and the manual page tell it; read off the parser, so
// that they cannot say anything else.

/// An option, without its dashes.
struct Told_option
{
  std::string long_name;           ///< empty if there is none
  std::string short_name;          ///< empty if there is none
  std::string value;               ///< what its value is called; empty if it takes none
  std::vector<std::string> values; ///< those that it can take; empty if that is no short list
  bool is_file;                    ///< whether its value names a file
  std::string description;
};

/// A command, or a command of a command, such as the kinds of `generate`.
struct Told_command
{
  std::string name;
  std::string description;
  std::string footer;
  std::vector<std::string> arguments;       ///< what is given without a name
  std::vector<std::string> argument_values; ///< those of the only one; empty if they are no list
  std::vector<Told_option> options;
  std::vector<Told_command> commands;

  /// the first paragraph of the description, on one line.
  std::string summary() const;
};

Told_command told_command(const CLI::App& app);

} // namespace htloops

#endif // HTLOOPS_COMMAND_LINE_H
