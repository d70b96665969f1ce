/// recording_header.h - what a recording says of its run besides frames: how it was begun, of which files, and what its report is.
///
/// It owns what names of files are called in a recording (recorded_paths.h).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/files/files_read.h"
#include "murosimf/recording/additions_now.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_paths.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

struct HeaderOptions {
  double rate = 0;  ///< [Hz] of frames
  std::string program, command_line;
  std::optional<RunDescription> run{};
  const files::FilesRead* files = nullptr;  ///< null: none
  const McapReader* files_of = nullptr;     ///< null: `files` are its own
};

class RecordingHeader {
 public:
  /// The scene outlives it.
  RecordingHeader(const scene::Scene& scene, HeaderOptions options)
      : scene_(scene), options_(std::move(options)), additions_(options_.files != nullptr) {}

  [[nodiscard]] const RecordedPaths& paths() const noexcept { return paths_; }

  /// Of a scene that is initialized, which has been read from all its files: what stands in them now. Throws SetupError.
  void take_files();
  /// Of a scene to which robots and bodies have come since take_files() or the last call: what they are, with what stands in their files now. Between
  /// two steps. Throws SetupError.
  void take_additions();
  /// What stands at the beginning of a file whose first frame is of the time `start`, with all that was taken. Throws SetupError if the file cannot be
  /// written, as the others.
  void write(McapWriter& file, Duration start);
  /// In a file that has begun: what was taken since.
  void write_additions(McapWriter& file);
  /// A text that belongs to the run, for write_end().
  void add_text(const std::string& name, const std::string& text) { texts_.emplace_back(name, text); }
  /// The report, and all texts.
  void write_end(McapWriter& file, const scene::RunReport& report);

 private:
  void attach(McapWriter& file, const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string run_json(Duration start) const;

  const scene::Scene& scene_;
  HeaderOptions options_;
  RecordedPaths paths_;
  AttachedFiles files_;  // not written yet
  AdditionsNow additions_;
  Duration first_{};
  std::vector<std::pair<std::string, std::string>> texts_;
};

/// The layout for Foxglove and Lichtblick (JSON) that shows these files: bodies, forces, joints and messages.
[[nodiscard]] std::string foxglove_layout(const std::vector<std::string>& robots);

}  // namespace murosimf::recording
