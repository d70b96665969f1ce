#include "apps/supervision_arguments.h"

#include <cstdlib>

#include <fmt/format.h>

#include "apps/last_words.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::app {
namespace {

constexpr const char* token_variable = "MUROSIMF_SUPERVISION_TOKEN";

}  // namespace

Option add_supervision(const Command& command, SupervisionArguments& arguments) {
  const Option where = command.add("--supervise", arguments.where,
                                   "Let others steer the run who know the token that is printed: PORT of this computer "
                                   "alone, or HOST:PORT");
  command.add("--paused", arguments.paused, "Begin paused, until somebody has it go on").needs(where);
  return where;
}

std::unique_ptr<supervise::Supervision> supervision_of(session::Session& session, const SupervisionArguments& arguments,
                                                       supervise::SupervisionOptions options) {
  if (arguments.where.empty()) return nullptr;
  options.say = [](const std::string& line) { say_warning(line); };
  options.load = [](scene::Scene& scene, const std::string& bytes) {
    recording::load_state_bytes(scene, bytes, "of_a_supervisor.state");
  };
  const char* token = std::getenv(token_variable);
  if (token) options.token = token;
  try {
    options.address = wire::parse_address(arguments.where);
  } catch (const wire::WireError& error) {
    throw SetupError(fmt::format("--supervise: {}", error.what()));
  }
  auto supervision = with_context("--supervise", [&] { return supervise::supervise(session, options); });
  say_note(fmt::format("supervision on {}, token {}", to_text(supervision->address()),
                       options.token.empty() ? supervision->token() : std::string("of ") + token_variable));
  return supervision;
}

}  // namespace murosimf::app
