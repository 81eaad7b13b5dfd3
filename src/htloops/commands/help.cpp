// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/failure.h"
#include "app/file_names.h"
#include "app/words.h"
#include "commands/command.h"
#include "commands/options.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace htloops {
namespace {

// Completions and the manual page are read off the parser, so that they cannot say anything else.

std::string first_of(const std::vector<std::string>& names) {
  return names.empty() ? "" : names.front();
}

// The names of an option, without their dashes; empty if there is none.
std::string long_name(const CLI::Option& option) { return first_of(option.get_lnames()); }
std::string short_name(const CLI::Option& option) { return first_of(option.get_snames()); }

// What its value is called; empty if it takes none.
std::string value_of(const CLI::Option& option) {
  if(option.get_items_expected_max() <= 0)
    return "";
  return option.get_option_text().empty() ? "VALUE" : option.get_option_text();
}

// Those that it can take, of "TEXT:{pure,shortest}" these two; empty if that is no short list.
std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  std::vector<std::string> values;
  if(begin == std::string::npos || end == std::string::npos)
    return values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for(std::string value; std::getline(list, value, ',');)
    values.push_back(value);
  return values;
}

bool names_file(const CLI::Option& option) {
  return option.get_type_name() == input_file || option.get_type_name() == output_file;
}

// What is given to a command without a name, or with one.
std::vector<const CLI::Option*> options_of(const CLI::App& command, bool is_positional = false) {
  return command.get_options([is_positional](const CLI::Option* option) {
    return option->get_positional() == is_positional;
  });
}

// The values of what is given without a name, if that is one only.
std::vector<std::string> argument_values(const CLI::App& command) {
  const auto arguments = options_of(command, true);
  return arguments.empty() ? std::vector<std::string>() : values_of(*arguments.back());
}

// Those of a command, such as the kinds of `generate`.
std::vector<const CLI::App*> commands_of(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

// The first paragraph of the description, on one line.
std::string summary_of(const CLI::App& command) {
  const std::string description = command.get_description();
  std::string text = description.substr(0, description.find("\n\n"));
  text.erase(text.find_last_not_of("\n ") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
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

std::string option_entry(const CLI::Option& option) {
  std::string names;
  if(!short_name(option).empty())
    names = "\\fB\\-" + short_name(option) + "\\fR";
  if(!long_name(option).empty())
    names += (names.empty() ? "" : ", ") + std::string("\\fB\\-\\-") + roff_of(long_name(option)) +
             "\\fR";
  if(!value_of(option).empty())
    names += " \\fI" + roff_of(value_of(option)) + "\\fR";
  return ".TP\n" + names + "\n" + paragraphs(option.get_description());
}

std::string command_section(const CLI::App& command, const std::string& path) {
  const std::string name = path + " " + command.get_name();
  std::string text = ".SS " + roff_of(name);
  for(const CLI::Option* argument : options_of(command, true))
    text += " " + roff_of(argument->get_name(true));
  text += "\n" + paragraphs(command.get_description());
  for(const CLI::Option* option : options_of(command))
    if(long_name(*option) != "help")
      text += option_entry(*option);
  for(const CLI::App* sub : commands_of(command))
    text += command_section(*sub, name);
  return text;
}

/// the manual page of the tool, for man(1).
std::string man_page(const CLI::App& tool) {
  std::string text = ".TH HTLOOPS 1\n.SH NAME\nhtloops \\- handle and tunnel loops, Reeb "
                     "graphs and curve skeletons of triangle meshes\n.SH SYNOPSIS\n\\fBhtloops\\fR "
                     "\\fICOMMAND\\fR "
                     "[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" +
                     paragraphs(tool.get_description()) + ".SH COMMANDS\n";
  for(const CLI::App* command : commands_of(tool))
    text += command_section(*command, tool.get_name());
  text += ".SH EXIT STATUS AND EXAMPLES\n" + as_it_is(tool.get_footer());
  for(const CLI::App* command : commands_of(tool))
    if(!command->get_footer().empty())
      text += as_it_is(command->get_footer());
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  return boost::algorithm::join(words, " ");
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
  return boost::algorithm::replace_all_copy(plain(text), ":", "\\:");
}

std::vector<std::string> names_of_commands(const CLI::App& command) {
  std::vector<std::string> names;
  for(const CLI::App* sub : commands_of(command))
    names.push_back(sub->get_name());
  return names;
}

// ---- bash

std::string bash_case(const CLI::App& command, const std::string& path) {
  std::vector<std::string> words = names_of_commands(command);
  std::string values;
  for(const CLI::Option* option : options_of(command)) {
    if(!long_name(*option).empty())
      words.push_back("--" + long_name(*option));
    if(!values_of(*option).empty())
      values +=
          "        --" + long_name(*option) + ") words='" + joined(values_of(*option)) + "' ;;\n";
    else if(!value_of(*option).empty())
      values += "        --" + long_name(*option) +
                (short_name(*option).empty() ? "" : "|-" + short_name(*option)) + ") return ;;\n";
  }
  std::string text = "    '" + path + "')\n      words='" + joined(words) + "'\n";
  if(!values.empty())
    text += "      case \"$before\" in\n" + values + "      esac\n";
  if(!argument_values(command).empty())
    text += "      [[ $now == -* ]] || COMPREPLY=($(compgen -W '" +
            joined(argument_values(command)) + "' -- \"$now\"))\n";
  text += "      ;;\n";
  for(const CLI::App* sub : commands_of(command))
    text += bash_case(*sub, path.empty() ? sub->get_name() : path + " " + sub->get_name());
  return text;
}

// Where nothing is proposed, names of files are.
std::string bash_completion(const CLI::App& tool) {
  std::string steps;
  for(const CLI::App* command : commands_of(tool)) {
    steps += "      '" + command->get_name() + "') [ -z \"$path\" ] && path=\"$word\" ;;\n";
    for(const CLI::App* sub : commands_of(*command))
      steps += "      '" + sub->get_name() + "') [ \"$path\" = " + command->get_name() +
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

std::string zsh_option(const CLI::Option& option) {
  std::string value;
  if(!values_of(option).empty())
    value = ":" + with_escaped_colons(value_of(option)) + ":(" + joined(values_of(option)) + ")";
  else if(names_file(option))
    value = ":" + with_escaped_colons(value_of(option)) + ":_files";
  else if(!value_of(option).empty())
    value = ":" + with_escaped_colons(value_of(option)) + ": ";
  const std::string text = "[" + with_escaped_colons(option.get_description()) + "]" + value + "'";
  std::string lines;
  if(!long_name(option).empty())
    lines += " \\\n        '*--" + long_name(option) + text;
  if(!short_name(option).empty())
    lines += " \\\n        '*-" + short_name(option) + text;
  return lines;
}

std::string zsh_function(const CLI::App& command, const std::string& name) {
  std::string text = name + "() {\n    local line state\n    _arguments -C";
  for(const CLI::Option* option : options_of(command))
    text += zsh_option(*option);
  if(!argument_values(command).empty())
    return text + " \\\n        '1:" +
           with_escaped_colons(options_of(command, true).back()->get_name(true)) + ":(" +
           joined(argument_values(command)) + ")'\n}\n";
  if(commands_of(command).empty())
    return text + " \\\n        '*:file:_files'\n}\n";
  text += " \\\n        '1:command:((";
  for(const CLI::App* sub : commands_of(command))
    text += sub->get_name() + "\\:\"" + with_escaped_colons(summary_of(*sub)) + "\" ";
  text += "))' \\\n        '*::argument:->arguments'\n    case \"$line[1]\" in\n";
  for(const CLI::App* sub : commands_of(command))
    text += "        " + sub->get_name() + ") " + name + "_" + sub->get_name() + " ;;\n";
  text += "    esac\n}\n";
  for(const CLI::App* sub : commands_of(command))
    text += zsh_function(*sub, name + "_" + sub->get_name());
  return text;
}

std::string zsh_completion(const CLI::App& tool) {
  return "#compdef htloops\n# htloops: completion for zsh\n" + zsh_function(tool, "_htloops") +
         "if [ \"$funcstack[1]\" = _htloops ]; then\n    _htloops \"$@\"\nelse\n"
         "    compdef _htloops htloops\nfi\n";
}

// ---- fish

// \p condition says where it holds.
std::string fish_lines(const CLI::App& command, const std::string& condition) {
  std::string text;
  const std::string begin = "complete -c htloops -n '" + condition + "'";
  for(const CLI::Option* option : options_of(command)) {
    text += begin;
    if(!long_name(*option).empty())
      text += " -l " + long_name(*option);
    if(!short_name(*option).empty())
      text += " -s " + short_name(*option);
    if(!values_of(*option).empty())
      text += " -x -a '" + joined(values_of(*option)) + "'";
    else if(!value_of(*option).empty())
      text += " -r";
    text += " -d '" + plain(option->get_description()) + "'\n";
  }
  if(!argument_values(command).empty())
    text += begin + " -f -a '" + joined(argument_values(command)) + "'\n";
  const std::string names = joined(names_of_commands(command));
  for(const CLI::App* sub : commands_of(command))
    text += begin + (names.empty() ? "" : " -f") + " -a " + sub->get_name() + " -d '" +
            plain(summary_of(*sub)) + "'\n";
  return text;
}

std::string fish_completion(const CLI::App& tool) {
  std::string text = "# htloops: completion for fish\n" + fish_lines(tool, "__fish_use_subcommand");
  for(const CLI::App* command : commands_of(tool)) {
    const std::string seen = "__fish_seen_subcommand_from " + command->get_name();
    const std::string kinds = joined(names_of_commands(*command));
    text += fish_lines(
        *command, kinds.empty() ? seen : seen + "; and not __fish_seen_subcommand_from " + kinds);
    for(const CLI::App* kind : commands_of(*command))
      text += fish_lines(*kind, seen + "; and __fish_seen_subcommand_from " + kind->get_name());
  }
  return text;
}

using Completion = std::string (*)(const CLI::App&);

// Scripts that make shells complete the words of the tool: commands, options, and values of options
// that are words of a list; elsewhere names of files.
const std::map<std::string, Completion> completions = {
    {"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};

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

std::string help_of(const CLI::App& tool, const std::vector<std::string>& words) {
  const CLI::App* command = &tool;
  std::string name = tool.get_name();
  for(const std::string& word : words) {
    const std::vector<const CLI::App*> all = commands_of(*command);
    const auto sub = std::find_if(all.begin(), all.end(),
                                  [&word](const CLI::App* one) { return one->get_name() == word; });
    if(sub == all.end())
      throw wrong_usage("there is no '" + name + " " + printable(word) + "'; see '" + name +
                        " --help'");
    command = *sub;
    name += " " + word;
  }
  return command->get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal);
}

constexpr char completion_examples[] = R"(Examples:
  source <(htloops completion bash)               for the current shell; after an installation,
                                                  completion works in all shells
)";

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

// What it needs, or goes with no other, is said in words.
std::string Help_formatter::make_option_opts(const CLI::Option* option) const {
  return option->get_items_expected_max() == 0 ? "" : CLI::Formatter::make_option_opts(option);
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
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* help = app.add_subcommand("help", "Prints this help, or the help of a command.\n");
  help->group(group);
  help->add_option("COMMAND", *words, "loops, generate torus, ...")->option_text(" ");
  complete_help(*help);
  help->callback([&app, words, &command] {
    command = [&app, words] { show_text(help_of(app, *words), false); };
  });
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand(
      "completion",
      "Prints a script that completes the commands and options of htloops in a shell.\n");
  completion->group(group);
  completion->add_option("SHELL", *shell, "bash, fish or zsh")
      ->option_text(" ")
      ->required()
      ->check(CLI::IsMember(completions));
  complete_help(*completion, completion_examples);
  completion->callback([&app, shell, &command] {
    command = [&app, shell] { show_text(completions.at(*shell)(app), false); };
  });
  CLI::App* man = app.add_subcommand("man", "Prints the manual page, for man(1).\n");
  man->group(group);
  complete_help(*man);
  man->callback([&app, &command] { command = [&app] { show_text(man_page(app), false); }; });
}

} // namespace htloops
