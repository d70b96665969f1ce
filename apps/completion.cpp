// `murosimf completion`: scripts that complete the command line, made of its definition.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/command_line.h"
#include "apps/standard_output.h"

namespace murosimf::app {
namespace {

/// "--threads", without positional arguments.
std::vector<std::string> options_of(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options) {
    if (!option.positional) names.push_back(option.name);
  }
  return names;
}

/// A shell's command whose output are the names that the first argument of a command can have; empty: files only.
std::string names_for(const CommandText& command, const std::string& program) {
  const auto first = std::ranges::find_if(command.options, &OptionText::positional);
  if (first == command.options.end()) return {};
  const Offer& offer = first->offer;
  if (!offer.list.empty()) return fmt::format("{} list {} 2>/dev/null", program, offer.list);
  return offer.names.empty() ? "" : fmt::format("echo {}", fmt::join(offer.names, " "));
}

std::string bash_script(const std::vector<CommandText>& commands) {
  std::string names, options, arguments;
  for (const CommandText& command : commands) {
    names += command.name + " ";
    options += fmt::format("    {}) words=\"{}\" ;;\n", command.name, fmt::join(options_of(command), " "));
    const std::string source = names_for(command, "\"${COMP_WORDS[0]}\"");
    if (!source.empty()) arguments += fmt::format("    {}) words=\"$({})\" ;;\n", command.name, source);
  }
  return fmt::format(R"(# bash completion of murosimf, written by `murosimf completion bash`
_murosimf() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" words=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="{}--help --version"
  elif [[ "$current" == -* ]]; then
    case "${{COMP_WORDS[1]}}" in
{}    esac
  else
    case "${{COMP_WORDS[1]}}" in
{}    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _murosimf murosimf
)",
                     names, options, arguments);
}

/// Text in single quotes; a colon ends a name there.
std::string zsh_item(const std::string& name, const std::string& meaning) {
  std::string text = name + ":";
  for (const char c : meaning) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + text + "'";
}

std::string zsh_script(const std::vector<CommandText>& commands) {
  std::string names, options, arguments;
  for (const CommandText& command : commands) {
    names += "    " + zsh_item(command.name, command.meaning) + "\n";
    std::string items;
    for (const OptionText& option : command.options) {
      if (!option.positional) items += " " + zsh_item(option.name, option.meaning);
    }
    options += fmt::format("    {}) items=({}) ;;\n", command.name, items);
    const std::string source = names_for(command, "$words[1]");
    if (!source.empty()) arguments += fmt::format("    {}) items=(${{=$({})}}) ;;\n", command.name, source);
  }
  return fmt::format(R"(#compdef murosimf
# zsh completion of murosimf, written by `murosimf completion zsh`
local -a items
if (( CURRENT == 2 )); then
  items=(
{}  )
  _describe command items
elif [[ $words[CURRENT] == -* ]]; then
  case "$words[2]" in
{}  esac
  _describe -o option items
else
  case "$words[2]" in
{}  esac
  (( $#items )) && compadd -a items
  _files
fi
)",
                     names, options, arguments);
}

}  // namespace

void add_completion(CommandLine& line) {
  const std::vector<std::string> shells{"bash", "zsh"};
  const auto shell = std::make_shared<std::string>();
  const auto write_script = [&line, shell] {
    write_standard_output(*shell == "zsh" ? zsh_script(line.commands()) : bash_script(line.commands()));
    return 0;
  };
  line.add("completion", "Write a script that completes this command line in a shell", write_script)
      .add("shell", *shell, "bash or zsh")
      .required()
      .one_of(shells)
      .offers(shells);
}

}  // namespace murosimf::app
