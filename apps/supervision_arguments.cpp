#include "apps/supervision_arguments.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::app {
namespace {

constexpr const char* token_variable = "MUROSIMF_SUPERVISION_TOKEN";

/// What is wrong with it is told without the folder in which it is for a while.
void load_state_of_supervisor(scene::Scene& scene, const std::string& bytes) {
  constexpr const char* name = "of_a_supervisor.state";
  try {
    recording::load_state_bytes(scene, bytes, name);
  } catch (const SetupError& error) {
    const std::string text = error.what();
    throw SetupError(text.find(name) == std::string::npos ? text : text.substr(text.find(name)));
  }
}

}  // namespace

Option add_supervision(const Command& command, SupervisionArguments& arguments) {
  const Option where = command.add("--supervise", arguments.where,
                                   "Let programs that present the printed token steer the run: PORT of this computer "
                                   "alone, or HOST:PORT");
  command.add("--paused", arguments.paused, "Begin paused, until a client continues the run").needs(where);
  command
      .add("--supervise-from", arguments.folders,
           "Supervisors may choose scenes from this folder, too, besides that of the scene and its models")
      .one_at_a_time()
      .needs(where);
  return where;
}

void check(const SupervisionArguments& arguments) {
  std::error_code error;
  for (const std::string& folder : arguments.folders) {
    if (!std::filesystem::is_directory(folder, error)) {
      throw SetupError(fmt::format("--supervise-from: there is no folder '{}'", folder));
    }
  }
}

std::unique_ptr<supervise::Supervision> supervision_of(session::Session& session, const SupervisionArguments& arguments,
                                                       supervise::SupervisionOptions options) {
  if (arguments.where.empty()) return nullptr;
  options.say = [](const std::string& line) { say_warning(line); };
  options.load = load_state_of_supervisor;
  const char* token = std::getenv(token_variable);
  if (token) options.token = token;
  try {
    options.address = network::parse_address(arguments.where);
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("--supervise: {}", error.what()));
  }
  auto supervision = with_context("--supervise", [&] { return supervise::supervise(session, options); });
  say_note(fmt::format("supervision on {}, token {}", to_text(supervision->address()),
                       options.token.empty() ? supervision->token() : std::string("of ") + token_variable));
  return supervision;
}

}  // namespace murosimf::app
