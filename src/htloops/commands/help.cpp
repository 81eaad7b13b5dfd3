// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/help.h"

#include "app/words.h"
#include "commands/command.h"
#include "commands/options.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace htloops {
namespace {

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

// Of "TEXT:{pure,shortest}": these two.
std::vector<std::string> listed_values(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  std::vector<std::string> values;
  if(begin == std::string::npos || end == std::string::npos)
    return values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for(std::string value; std::getline(list, value, ',');)
    values.push_back(value);
  return values;
}

Told_option told_option(const CLI::Option& option) {
  Told_option told;
  if(!option.get_lnames().empty())
    told.long_name = option.get_lnames().front();
  if(!option.get_snames().empty())
    told.short_name = option.get_snames().front();
  const std::string type = option.get_type_name();
  if(option.get_items_expected_max() > 0)
    told.value = option.get_option_text().empty() ? "VALUE" : option.get_option_text();
  told.values = listed_values(type);
  told.is_file = type == input_file || type == output_file;
  told.description = option.get_description();
  return told;
}

std::string Told_command::summary() const {
  std::string text = description.substr(0, description.find("\n\n"));
  text.erase(text.find_last_not_of("\n ") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Told_command told_command(const CLI::App& app) {
  Told_command told{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}, {}};
  for(const CLI::Option* option : app.get_options())
    if(option->get_positional()) {
      told.arguments.push_back(option->get_name(true));
      told.argument_values = listed_values(option->get_type_name());
    } else
      told.options.push_back(told_option(*option));
  for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    told.commands.push_back(told_command(*command));
  return told;
}

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
  std::string roff;
  for(const std::string& line : lines_of(text))
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

/// the manual page of the tool, for man(1).
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

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for(const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

// On one line, without what a shell or its functions would take for something else.
std::string plain(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for(const char c : {'\'', '"', '`', '$', '\\'})
    text.erase(std::remove(text.begin(), text.end(), c), text.end());
  for(const auto& [c, other] : {std::pair('[', '('), std::pair(']', ')')})
    std::replace(text.begin(), text.end(), c, other);
  return text;
}

// The same where a colon ends a text, as in zsh.
std::string with_escaped_colons(const std::string& text) {
  std::string escaped;
  for(const char c : plain(text))
    escaped += c == ':' ? "\\:" : std::string(1, c);
  return escaped;
}

std::vector<std::string> names_of(const std::vector<Told_command>& commands) {
  std::vector<std::string> names;
  for(const Told_command& command : commands)
    names.push_back(command.name);
  return names;
}

// ---- bash

std::string bash_case(const Told_command& command, const std::string& path) {
  std::vector<std::string> words = names_of(command.commands);
  std::string values;
  for(const Told_option& option : command.options) {
    if(!option.long_name.empty())
      words.push_back("--" + option.long_name);
    if(!option.values.empty())
      values += "        --" + option.long_name + ") words='" + joined(option.values) + "' ;;\n";
    else if(!option.value.empty())
      values += "        --" + option.long_name +
                (option.short_name.empty() ? "" : "|-" + option.short_name) + ") return ;;\n";
  }
  std::string text = "    '" + path + "')\n      words='" + joined(words) + "'\n";
  if(!values.empty())
    text += "      case \"$before\" in\n" + values + "      esac\n";
  if(!command.argument_values.empty())
    text += "      [[ $now == -* ]] || COMPREPLY=($(compgen -W '" +
            joined(command.argument_values) + "' -- \"$now\"))\n";
  text += "      ;;\n";
  for(const Told_command& sub : command.commands)
    text += bash_case(sub, path.empty() ? sub.name : path + " " + sub.name);
  return text;
}

// Where nothing is proposed, names of files are.
std::string bash_completion(const Told_command& tool) {
  std::string steps;
  for(const Told_command& command : tool.commands) {
    steps += "      '" + command.name + "') [ -z \"$path\" ] && path=\"$word\" ;;\n";
    for(const Told_command& sub : command.commands)
      steps += "      '" + sub.name + "') [ \"$path\" = " + command.name +
               " ] && path=\"$path $word\" ;;\n";
  }
  return "# htloops: completion for bash\n"
         "_htloops() {\n"
         "  local word path='' words=''\n"
         "  local now=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \"$word\" in\n" +
         steps +
         "    esac\n"
         "  done\n"
         "  case \"$path\" in\n" +
         bash_case(tool, "") +
         "  esac\n"
         "  [[ $now == -* || -z $path || $path == generate || $before == --* ]] || return\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$now\"))\n"
         "}\n"
         "complete -o default -F _htloops htloops\n";
}

// ---- zsh

std::string zsh_option(const Told_option& option) {
  std::string value;
  if(!option.values.empty())
    value = ":" + with_escaped_colons(option.value) + ":(" + joined(option.values) + ")";
  else if(option.is_file)
    value = ":" + with_escaped_colons(option.value) + ":_files";
  else if(!option.value.empty())
    value = ":" + with_escaped_colons(option.value) + ": ";
  const std::string text = "[" + with_escaped_colons(option.description) + "]" + value + "'";
  std::string lines;
  if(!option.long_name.empty())
    lines += " \\\n        '*--" + option.long_name + text;
  if(!option.short_name.empty())
    lines += " \\\n        '*-" + option.short_name + text;
  return lines;
}

std::string zsh_function(const Told_command& command, const std::string& name) {
  std::string text = name + "() {\n    local line state\n    _arguments -C";
  for(const Told_option& option : command.options)
    text += zsh_option(option);
  if(!command.argument_values.empty())
    return text + " \\\n        '1:" + with_escaped_colons(joined(command.arguments)) + ":(" +
           joined(command.argument_values) + ")'\n}\n";
  if(command.commands.empty())
    return text + " \\\n        '*:file:_files'\n}\n";
  text += " \\\n        '1:command:((";
  for(const Told_command& sub : command.commands)
    text += sub.name + "\\:\"" + with_escaped_colons(sub.summary()) + "\" ";
  text += "))' \\\n        '*::argument:->arguments'\n    case \"$line[1]\" in\n";
  for(const Told_command& sub : command.commands)
    text += "        " + sub.name + ") " + name + "_" + sub.name + " ;;\n";
  text += "    esac\n}\n";
  for(const Told_command& sub : command.commands)
    text += zsh_function(sub, name + "_" + sub.name);
  return text;
}

std::string zsh_completion(const Told_command& tool) {
  return "#compdef htloops\n# htloops: completion for zsh\n" + zsh_function(tool, "_htloops") +
         "if [ \"$funcstack[1]\" = _htloops ]; then\n    _htloops \"$@\"\nelse\n"
         "    compdef _htloops htloops\nfi\n";
}

// ---- fish

// \p condition says where it holds.
std::string fish_lines(const Told_command& command, const std::string& condition) {
  std::string text;
  const std::string begin = "complete -c htloops -n '" + condition + "'";
  for(const Told_option& option : command.options) {
    text += begin;
    if(!option.long_name.empty())
      text += " -l " + option.long_name;
    if(!option.short_name.empty())
      text += " -s " + option.short_name;
    if(!option.values.empty())
      text += " -x -a '" + joined(option.values) + "'";
    else if(!option.value.empty())
      text += " -r";
    text += " -d '" + plain(option.description) + "'\n";
  }
  if(!command.argument_values.empty())
    text += begin + " -f -a '" + joined(command.argument_values) + "'\n";
  const std::string names = joined(names_of(command.commands));
  for(const Told_command& sub : command.commands)
    text += begin + (names.empty() ? "" : " -f") + " -a " + sub.name + " -d '" +
            plain(sub.summary()) + "'\n";
  return text;
}

std::string fish_completion(const Told_command& tool) {
  std::string text = "# htloops: completion for fish\n" + fish_lines(tool, "__fish_use_subcommand");
  for(const Told_command& command : tool.commands) {
    const std::string seen = "__fish_seen_subcommand_from " + command.name;
    const std::string kinds = joined(names_of(command.commands));
    text += fish_lines(
        command, kinds.empty() ? seen : seen + "; and not __fish_seen_subcommand_from " + kinds);
    for(const Told_command& kind : command.commands)
      text += fish_lines(kind, seen + "; and __fish_seen_subcommand_from " + kind.name);
  }
  return text;
}

using Completion = std::string (*)(const Told_command&);

const std::map<std::string, Completion> completions = {
    {"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};

/// bash, zsh and fish.
std::vector<std::string> known_shells() {
  std::vector<std::string> shells;
  for(const auto& [shell, completion] : completions)
    shells.push_back(shell);
  return shells;
}

/// a script that makes one of these shells complete the words of the tool: commands, options, and
/// values of options that are words of a list; elsewhere names of files.
std::string shell_completion(const std::string& shell, const Told_command& tool) {
  return completions.at(shell)(tool);
}

constexpr std::size_t left_column_width = 26;
constexpr std::size_t right_column_width = 72;

std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string lines, word;
  std::size_t width = 0;
  while(words >> word) {
    const bool fits = width + 1 + word.size() <= right_column_width;
    lines += (width == 0 ? "" : fits ? " " : "\n") + word;
    width = word.size() + (fits ? width + 1 : 0);
  }
  return lines;
}

constexpr char completion_examples[] =
    "Examples:\n"
    "  source <(htloops completion bash)               for this shell; an installed htloops is\n"
    "                                                  completed in each\n";

} // namespace

Help_formatter::Help_formatter(const std::string& subcommand) {
  column_width(left_column_width);
  label("SUBCOMMAND", subcommand);
  label("Positionals", "Arguments");
}

std::string
Help_formatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
  for(std::size_t at; (at = help.find("\n\n\n")) != std::string::npos;)
    help.erase(at, 1);
  help.erase(help.find_last_not_of('\n') + 1);
  return help + '\n';
}

std::string Help_formatter::make_subcommand(const CLI::App* command) const {
  const std::string description = command->get_description();
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_name(),
                           wrapped(description.substr(0, description.find("\n\n"))),
                           left_column_width);
  return out.str();
}

void complete_help(CLI::App& command, const std::string& footer) {
  command.set_help_flag("-h,--help", "this help")->group("Help");
  command.footer(footer);
}

void add_help_commands(CLI::App& app, Command& command) {
  const char group[] = "More help";
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand(
      "completion", "Prints a script that makes a shell complete the words of htloops.\n");
  completion->group(group);
  completion->add_option("SHELL", *shell, "bash, fish or zsh")
      ->option_text(" ")
      ->required()
      ->check(CLI::IsMember(known_shells()));
  complete_help(*completion, completion_examples);
  completion->callback([&app, shell, &command] {
    command = [&app, shell] { show_text(shell_completion(*shell, told_command(app)), false); };
  });
  CLI::App* man = app.add_subcommand("man", "Prints the manual page, for man(1).\n");
  man->group(group);
  complete_help(*man);
  man->callback(
      [&app, &command] { command = [&app] { show_text(man_page(told_command(app)), false); }; });
}

} // namespace htloops
