/// assets.h - data shared by the scenes of one process, which makes further scenes cheap: robots read from their files, and fields.
///
///     auto assets = std::make_shared<scene::Assets>();
///     for (int i = 0; i < 1000; ++i) worlds.push_back(std::make_unique<scene::Scene>("walk", {.assets = assets}));
///
/// Any number of threads may build scenes with the same assets. Files are read once: later changes on the disk are seen by new
/// Assets only.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::scene {

/// A robot as described by its files.
struct RobotKind {
  ModelPtr model;
  std::vector<sensors::SensorSpec> sensors;
  std::vector<std::string> warnings;  ///< of reading
  std::vector<std::string> unused;    ///< words of the file without effect (robot_formats::Unused), each once
};

class Assets {
 public:
  /// Of the options only those of scenes matter: lenient, body, xacro. Throws SetupError: no such file, an error in it; then nothing is
  /// cached.
  [[nodiscard]] std::shared_ptr<const RobotKind> robot(const std::filesystem::path& file,
                                                       const robot_formats::ReaderOptions& options);

  /// Sets the result of robot() for this file and these options, whatever the file contains: for a robot that differs from its file.
  void put(const std::filesystem::path& file, const robot_formats::ReaderOptions& options, RobotKind kind);

  /// Returns the result of `make` at its first call with this key, which must identify it. Throws what make() throws.
  [[nodiscard]] ModelPtr model(const std::string& key, const std::function<ModelPtr()>& make);

 private:
  using RobotKey = std::tuple<std::filesystem::path, bool, std::string, std::map<std::string, std::string>>;
  static RobotKey key_of(const std::filesystem::path& file, const robot_formats::ReaderOptions& options);

  std::mutex mutex_;
  std::map<RobotKey, std::shared_ptr<const RobotKind>> robots_;
  std::map<std::string, ModelPtr> models_;
};

}  // namespace murosimf::scene
