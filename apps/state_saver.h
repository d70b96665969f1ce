/// state_saver.h - writes the state of a run to files, at given times and at its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/files_read.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::app {

class StateSaver {
 public:
  /// `at`: each TIME:FILE; `at_end`: a file, empty for none. Throws SetupError if one could not be written now.
  StateSaver(const std::vector<std::string>& at, const std::string& at_end);

  /// When the scene is initialized, and a state loaded; it must outlive the run.
  void begin(scene::Scene& scene, const files::FilesRead& files, const recording::RunDescription& run);
  /// A state of now, as such a file. Throws SetupError.
  [[nodiscard]] std::string state_of(scene::Scene& scene) const { return recording::state_bytes(scene, options_); }
  /// Prints which states are missing or cannot be written; returns whether all are there.
  [[nodiscard]] bool finish();

 private:
  struct Request {
    Duration time{};
    std::string text;  ///< as it was given
    std::string file;
    bool done = false;
  };
  void save(const std::string& file);

  std::vector<Request> requests_;
  std::string at_end_;
  scene::Scene* scene_ = nullptr;
  recording::StateFileOptions options_;
};

}  // namespace murosimf::app
