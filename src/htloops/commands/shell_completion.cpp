// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/shell_completion.h"

#include <algorithm>
#include <map>

namespace htloops {
namespace {

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

} // namespace

std::vector<std::string> known_shells() {
  std::vector<std::string> shells;
  for(const auto& [shell, completion] : completions)
    shells.push_back(shell);
  return shells;
}

std::string shell_completion(const std::string& shell, const Told_command& tool) {
  return completions.at(shell)(tool);
}

} // namespace htloops
