/// command_line.h - the commands of the program: each adds itself with its options, and the one that the user names runs.
///
/// A command is a source apps/NAME.cpp that defines add_NAME, and one line in the list of apps/main.cpp:
///
///     struct PlotOptions {
///       std::string file;  ///< CSV
///     };
///
///     void define(const Command& command, PlotOptions& options) {
///       command.add("file", options.file, "Table (CSV) with a header and the time in its first column").required();
///     }
///
///     int plot(const PlotOptions& options) { ... }  // the exit code; SetupError for users' errors
///
///     void add_plot(CommandLine& line) { line.add<PlotOptions>("plot", "Draw numbers over time", define, plot); }
///
/// --help, completions and the manual page are made of that.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"

namespace murosimf::app {

/// The texts of an option.
struct OptionText {
  std::string name;  ///< "--threads"; of a positional argument: "scene"
  std::string meaning;
  bool positional = false, takes_value = false;
  Offer offer;
};

struct CommandText {
  std::string name, meaning;
  std::vector<OptionText> options;  ///< as they were added, behind --help
};

class CommandLine {
 public:
  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// A command whose options `define` adds; `action` gets them and returns the exit code.
  template <class Options>
  void add(const std::string& name, const std::string& meaning, void (*define)(const Command&, Options&),
           int (*action)(const Options&)) {
    const auto options = std::make_shared<Options>();
    define(add(name, meaning, [options, action] { return action(*options); }), *options);
  }
  /// One whose options, if it has any, `action` holds. Throws SetupError if the name is taken.
  Command add(const std::string& name, const std::string& meaning, std::function<int()> action);

  /// Files of `--plugin FILE` in front of the command; these may add commands, so they are loaded before anything is read.
  [[nodiscard]] static std::vector<std::string> leading_plugins(int argc, const char* const* argv);

  /// Runs the command of the user and returns the exit code. Prints errors in the command line; throws what a command throws.
  int run(int argc, char** argv);

  [[nodiscard]] std::vector<CommandText> commands() const;

 private:
  void refuse_unknown_command(const std::string& name) const;

  std::unique_ptr<CLI::App> app_;
  Offers offers_;
  std::vector<std::string> plugins_;  // loaded already
  int exit_code_ = 0;
};

}  // namespace murosimf::app
