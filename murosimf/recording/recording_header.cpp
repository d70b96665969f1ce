#include "murosimf/recording/recording_header.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "murosimf/recording/recorded_addition.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::recording {

void RecordingHeader::take_files() {
  first_ = scene_.simulation().now();
  if (options_.files) {
    paths_ = RecordedPaths(options_.files->list(), options_.files->names());
    files_ = files_now(options_.files->list(), paths_);
    for (const auto& [name, what] : files_.list.values) known_files_.insert(name);
  }
  take_additions();
}

void RecordingHeader::take_additions() {
  const std::vector<scene::Addition>& all = scene_.parts().additions;
  if (taken_ == all.size()) return;
  if (options_.files) take_files_of_additions();
  for (; taken_ < all.size(); ++taken_) additions_.push_back(json_of(all[taken_]));
}

/// Several of a kind are read once.
void RecordingHeader::take_files_of_additions() {
  const files::FilesRead& read = *scene_.parts().files_of_additions;
  paths_.extend(read.list(), read.names());
  std::vector<std::filesystem::path> added;
  for (const std::filesystem::path& file : read.list()) {
    if (known_files_.insert(paths_.reduced(file)).second) added.push_back(file);
  }
  AttachedFiles now = files_now(added, paths_);
  later_files_.list.name = now.list.name;
  later_files_.list.values.merge(now.list.values);
  later_files_.folders = std::move(now.folders);
  std::ranges::move(now.contents, std::back_inserter(later_files_.contents));
}

/// One that came before the first frame is part of all states.
std::string RecordingHeader::json_of(const scene::Addition& addition) const {
  const scene::SceneParts& parts = scene_.parts();
  RecordedAddition recorded{.what = addition.what};
  recorded.time = std::max(addition.time, first_);
  recorded.in_state = recorded.time == scene_.simulation().now();
  if (parts.outside.notes) recorded.channels = parts.outside.notes->names();
  if (options_.files) {
    RunDescription names;
    names.names = parts.files_of_additions->names();
    recorded.names = paths_.in_description(std::move(names)).names;
  }
  std::visit([&](auto& spec) { spec.model = paths_.in_text(spec.model); }, recorded.what);
  return to_json(recorded);
}

void RecordingHeader::write_additions(McapWriter& file) {
  if (!later_files_.list.values.empty()) attach_files(file, std::exchange(later_files_, {}));
  for (const std::string& addition : std::exchange(additions_, {})) {
    attach(file, fmt::format("{}{}.json", additions_prefix, ++written_), addition);
  }
}

void RecordingHeader::write(McapWriter& file, Duration start) {
  Metadata run = run_metadata(scene_, options_.program, paths_.in_command_line(options_.command_line));
  run.values["record_rate_hz"] = fmt::format("{}", options_.rate);
  file.add(run);
  std::vector<std::string> robots;
  for (const scene_file::RobotSpec& robot : scene_.spec().robots) robots.push_back(robot.name);
  attach(file, "layout.json", foxglove_layout(robots));
  if (options_.files) attach_files(file, files_);
  if (options_.files_of) copy_files(file, *options_.files_of);
  if (options_.run) attach(file, "run.json", run_json(start));
  write_additions(file);
}

std::string RecordingHeader::run_json(Duration start) const {
  RunDescription run = *options_.run;
  run.start = start;
  if (options_.files) {
    run.names = options_.files->names();
    run = paths_.in_description(std::move(run));
  }
  if (const ExternalInputLog* outside = scene_.parts().outside.notes.get()) {
    run.outside.clear();  // it is in the recording
    run.channels = outside->names();
  }
  return to_json(run);
}

void RecordingHeader::write_end(McapWriter& file, const scene::RunReport& report) {
  add_text("report.txt", paths_.in_text(scene::to_text(report)));
  add_text("report.json", paths_.in_text(scene::to_json(report)));
  for (const auto& [name, text] : texts_) attach(file, name, text);
}

void RecordingHeader::attach(McapWriter& file, const std::string& name, const std::string& text) const {
  file.attach(text_attachment(name, text, scene_.simulation().now()));
}

}  // namespace murosimf::recording
