/// command_line.h - what the definition of the command line gives besides parsing: completions for shells, and a manual.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace murosimf::app {

/// Shells that have completions.
[[nodiscard]] const std::vector<std::string>& completion_shells();

/// A script that completes commands, options, and the names of scenes, models and lists. `shell`: bash or zsh.
[[nodiscard]] std::string completion_script(const CLI::App& app, std::string_view shell);

/// The manual page murosimf(1), for man (roff).
[[nodiscard]] std::string manual_page(const CLI::App& app);

/// What can be listed, by `murosimf list`.
[[nodiscard]] const std::vector<std::string>& list_kinds();

}  // namespace murosimf::app
