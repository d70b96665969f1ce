#include "apps/state_saver.h"

#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/record_options.h"
#include "apps/results.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

StateSaver::StateSaver(const std::vector<std::string>& at, const std::string& at_end) : at_end_(at_end) {
  for (const std::string& text : at) {
    const auto colon = text.find(':');
    double s = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), s);
    const bool good = colon != std::string::npos && error == std::errc{} && end == text.data() + colon;
    if (!good || !(s >= 0 && s <= scene_file::longest_duration) || colon + 1 == text.size()) {
      throw SetupError(fmt::format("--save-at '{}': write TIME:FILE, like 2.5:walk.state", text));
    }
    requests_.push_back({.time = from_seconds(s), .text = text, .file = text.substr(colon + 1)});
    files::claim_output("--save-at " + text.substr(0, colon), requests_.back().file);
  }
  if (!at_end.empty()) files::claim_output("--save-state", at_end);
}

void StateSaver::begin(scene::Scene& scene, const files::FilesRead& files, const recording::RunDescription& run) {
  scene_ = &scene;
  const recording::RecordedPaths paths(files.list(), files.names());
  recording::RunDescription described = run;
  described.names = files.names();
  options_ = {.program = this_program(),
              .command_line = paths.in_command_line(command_line()),
              .run = paths.in_description(std::move(described)),
              .files = recording::files_now(files.list(), paths),
              .paths = paths};
  for (Request& request : requests_) {
    if (request.time < scene.simulation().now()) continue;
    scene.simulation().at(request.time, [this, &request] {
      save(request.file);  // that it cannot is a warning of the run
      request.done = true;
    });
  }
}

void StateSaver::save(const std::string& file) { recording::write_state(*scene_, file, options_); }

bool StateSaver::finish() {
  Results results;
  bool all = true;
  for (Request& request : requests_) {
    if (!request.done && request.time == scene_->simulation().now()) {
      results.write([&] { save(request.file); });
      request.done = true;
    }
    if (request.done) continue;
    say_warning(fmt::format("--save-at '{}': there is no such state", request.text));
    all = false;
  }
  if (!at_end_.empty()) results.write([&] { save(at_end_); });
  return all && results.all();
}

}  // namespace murosimf::app
