/// record_options.h - the options of `murosimf run` that record it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "murosimf/files/files_read.h"
#include "murosimf/recording/recorder.h"

namespace murosimf::app {

struct RecordOptions {
  std::string file;               ///< MCAP; empty: nothing is recorded
  double rate = 100;              ///< [Hz]
  std::vector<std::string> what;  ///< of recording::recordable(); none: what usually is
};

void add_record(const Command& command, RecordOptions& options);

/// Throws SetupError if the file could not be written now.
void check(const RecordOptions& options);

/// Null if nothing is recorded. `files`: notes what the scene is read from, until the first step. Before that. Throws SetupError.
[[nodiscard]] std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                                 const files::FilesRead& files);

/// Writes what is left, and a layout for Foxglove beside the recording. Says what went wrong, once; whether nothing did.
[[nodiscard]] bool finish(recording::Recorder& recorder, const scene::RunReport& report, const RecordOptions& options);

}  // namespace murosimf::app
