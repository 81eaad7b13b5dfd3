// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/man_page.h"

#include <sstream>

namespace htloops {
namespace {

// A text in which no character is a request.
std::string roff_of(const std::string& text) {
  std::string roff;
  bool begins = true;
  for(const char c : text) {
    if(begins && (c == '.' || c == '\''))
      roff += "\\&";
    begins = c == '\n';
    roff += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return roff;
}

// Blank lines are between paragraphs.
std::string paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string roff;
  for(std::string line; std::getline(lines, line);)
    roff += line.empty() ? ".PP\n" : roff_of(line) + "\n";
  return roff;
}

std::string as_it_is(const std::string& text) { return ".nf\n" + roff_of(text) + "\n.fi\n"; }

std::string option_entry(const Told_option& option) {
  std::string names;
  if(!option.short_name.empty())
    names = "\\fB\\-" + option.short_name + "\\fR";
  if(!option.long_name.empty())
    names += (names.empty() ? "" : ", ") + std::string("\\fB\\-\\-") + roff_of(option.long_name) +
             "\\fR";
  if(!option.value.empty())
    names += " \\fI" + roff_of(option.value) + "\\fR";
  return ".TP\n" + names + "\n" + paragraphs(option.description);
}

std::string command_section(const Told_command& command, const std::string& path) {
  const std::string name = path + " " + command.name;
  std::string text = ".SS " + roff_of(name);
  for(const std::string& argument : command.arguments)
    text += " " + roff_of(argument);
  text += "\n" + paragraphs(command.description);
  for(const Told_option& option : command.options)
    if(option.long_name != "help")
      text += option_entry(option);
  for(const Told_command& sub : command.commands)
    text += command_section(sub, name);
  return text;
}

} // namespace

std::string man_page(const Told_command& tool) {
  std::string text = ".TH HTLOOPS 1\n.SH NAME\nhtloops \\- handle and tunnel loops, and Reeb "
                     "graphs, of triangle meshes\n.SH SYNOPSIS\n\\fBhtloops\\fR \\fICOMMAND\\fR "
                     "[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" +
                     paragraphs(tool.description) + ".SH COMMANDS\n";
  for(const Told_command& command : tool.commands)
    text += command_section(command, tool.name);
  text += ".SH EXIT STATUS AND EXAMPLES\n" + as_it_is(tool.footer);
  for(const Told_command& command : tool.commands)
    if(!command.footer.empty())
      text += as_it_is(command.footer);
  return text;
}

} // namespace htloops
