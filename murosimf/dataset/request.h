/// request.h - what a data set is asked to be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "murosimf/scene/scene_options.h"

namespace murosimf::dataset {

struct Request {
  std::filesystem::path folder;
  std::filesystem::path scene;                     ///< file, or name of one that comes with the program
  std::filesystem::path randomisation = "soccer";  ///< likewise
  std::uint64_t pictures = 0;
  int width = 640, height = 480;  ///< [px]
  bool normals = false;
  scene::SceneOptions options{};       ///< `threads` draw at the same time; `stop` ends it early
  std::vector<std::string> plugins{};  ///< files that are loaded: they may move robots otherwise
  std::string version;                 ///< of the program: another one may draw other pixels
  /// Called by one thread at a time with the number of pictures that are there.
  std::function<void(std::uint64_t)> progress{};
};

}  // namespace murosimf::dataset
