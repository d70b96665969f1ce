// `murosimf completion`: scripts that complete the command line, made of its definition.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/commands.h"

namespace murosimf::app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "--threads", without positional arguments.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// A shell's command whose output are the names that the first argument of a command can have; empty: files only.
std::string names_for(const std::string& command, const std::string& program) {
  if (command == "run" || command == "render" || command == "compare") return program + " list scenes 2>/dev/null";
  if (command == "check" || command == "convert") return program + " list models 2>/dev/null";
  if (command == "lens") return program + " list lenses 2>/dev/null";
  if (command == "list") return fmt::format("echo {}", fmt::join(list_kinds(), " "));
  if (command == "completion") return fmt::format("echo {}", fmt::join(completion_shells(), " "));
  return {};
}

std::string bash_script(const CLI::App& app) {
  std::string names, options, arguments;
  for (const CLI::App* command : commands_of(app)) {
    const std::string& name = command->get_name();
    names += name + " ";
    options += fmt::format("    {}) words=\"{}\" ;;\n", name, fmt::join(options_of(*command), " "));
    const std::string source = names_for(name, "\"${COMP_WORDS[0]}\"");
    if (!source.empty()) arguments += fmt::format("    {}) words=\"$({})\" ;;\n", name, source);
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

std::string zsh_script(const CLI::App& app) {
  std::string commands, options, arguments;
  for (const CLI::App* command : commands_of(app)) {
    const std::string& name = command->get_name();
    commands += "    " + zsh_item(name, command->get_description()) + "\n";
    std::string items;
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& long_name : option->get_lnames()) {
        items += " " + zsh_item("--" + long_name, option->get_description());
      }
    }
    options += fmt::format("    {}) items=({}) ;;\n", name, items);
    const std::string source = names_for(name, "$words[1]");
    if (!source.empty()) arguments += fmt::format("    {}) items=(${{=$({})}}) ;;\n", name, source);
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
                     commands, options, arguments);
}

}  // namespace

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells{"bash", "zsh"};
  return shells;
}

std::string completion_script(const CLI::App& app, std::string_view shell) {
  return shell == "zsh" ? zsh_script(app) : bash_script(app);
}

}  // namespace murosimf::app
