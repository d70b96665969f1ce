#include "apps/command_line.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/version.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

OptionText text_of(const CLI::Option& option, const Offers& offers) {
  const bool positional = option.get_positional();
  const auto offer = offers.find(&option);
  const auto& names = option.get_lnames();
  return {.name = names.empty() ? option.get_name(true) : "--" + names.front(),
          .meaning = option.get_description(),
          .positional = positional,
          .takes_value = option.get_items_expected_max() > 0,
          .offer = offer == offers.end() ? Offer{} : offer->second};
}

/// Of the first that is neither `--plugin` nor its file.
int first_word(int argc, const char* const* argv) {
  int word = 1;
  while (word + 1 < argc && std::string_view(argv[word]) == "--plugin") word += 2;
  return word;
}

}  // namespace

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("MuRoSimF: teams of humanoid robots at exchangeable levels of physical detail",
                                      "murosimf")) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version_text());
  app_->add_option("--plugin", plugins_, "Load this shared library first: it may add commands, too")
      ->allow_extra_args(false);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add(const std::string& name, const std::string& meaning, std::function<int()> action) {
  const auto known = commands_of(*app_);
  if (std::ranges::any_of(known, [&](const CLI::App* command) { return command->get_name() == name; })) {
    throw SetupError(fmt::format("there is a command '{}' already; choose another name", name));
  }
  CLI::App* command = app_->add_subcommand(name, meaning);
  command->callback([this, action = std::move(action)] { exit_code_ = action(); });
  return {*command, offers_};
}

std::vector<std::string> CommandLine::leading_plugins(int argc, const char* const* argv) {
  std::vector<std::string> files;
  for (int file = 2; file < first_word(argc, argv); file += 2) files.emplace_back(argv[file]);
  return files;
}

int CommandLine::run(int argc, char** argv) {
  const int first = first_word(argc, argv);
  if (first < argc) refuse_unknown_command(argv[first]);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_->exit(error);  // --help, --version
    say_error(error.what(), "; --help shows what there is");
    return user_error;
  }
  return exit_code_;
}

std::vector<CommandText> CommandLine::commands() const {
  std::vector<CommandText> texts;
  for (const CLI::App* command : commands_of(*app_)) {
    texts.push_back({command->get_name(), command->get_description(), {}});
    for (const CLI::Option* option : command->get_options()) texts.back().options.push_back(text_of(*option, offers_));
  }
  return texts;
}

/// The parser would only say that a command is required.
void CommandLine::refuse_unknown_command(const std::string& name) const {
  if (name.starts_with('-')) return;
  std::vector<std::string_view> names;
  for (const CLI::App* command : commands_of(*app_)) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw SetupError(unknown_name("command", name, names));
  }
}

}  // namespace murosimf::app
