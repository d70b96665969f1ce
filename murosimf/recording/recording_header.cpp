#include "murosimf/recording/recording_header.h"

#include <fmt/format.h>

#include "murosimf/recording/state_file.h"

namespace murosimf::recording {

void RecordingHeader::take_files() {
  first_ = scene_.simulation().now();
  if (options_.files) {
    paths_ = RecordedPaths(options_.files->list(), options_.files->names());
    files_ = files_now(options_.files->list(), paths_);
    additions_.know(files_);
  }
  take_additions();
}

void RecordingHeader::take_additions() { additions_.take(scene_, first_, paths_); }

void RecordingHeader::write_additions(McapWriter& file) { additions_.write(file, scene_.simulation().now()); }

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
