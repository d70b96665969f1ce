/// assets.h - what scenes of one process share, so that the next scene costs little: robots that were read from their files, and fields.
///
///     auto assets = std::make_shared<scene::Assets>();
///     for (int i = 0; i < 1000; ++i) worlds.push_back(std::make_unique<scene::Scene>("walk", {.assets = assets}));
///
/// Any number of threads may build scenes with the same assets. Files are read once: what changes on the disk later is seen by new
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

/// A robot as its files say.
struct RobotKind {
  ModelPtr model;
  std::vector<sensors::SensorSpec> sensors;
  std::vector<std::string> warnings;  ///< of reading
  std::vector<std::string> unused;    ///< words of the file that have no effect (robot_formats::Unused), each once
};

class Assets {
 public:
  /// Of the options those count that scenes have: lenient, body, xacro. Throws SetupError: no such file, an error in it; nothing is kept
  /// then.
  [[nodiscard]] std::shared_ptr<const RobotKind> robot(const std::filesystem::path& file,
                                                       const robot_formats::ReaderOptions& options);

  /// What robot() returns for this file and these options from now on, whatever stands in it: a robot that is not quite as its file says.
  void put(const std::filesystem::path& file, const robot_formats::ReaderOptions& options, RobotKind kind);

  /// What `make` returns for the first who asks with this key, from which it must follow. Throws what make() throws.
  [[nodiscard]] ModelPtr model(const std::string& key, const std::function<ModelPtr()>& make);

 private:
  using RobotKey = std::tuple<std::filesystem::path, bool, std::string, std::map<std::string, std::string>>;
  static RobotKey key_of(const std::filesystem::path& file, const robot_formats::ReaderOptions& options);

  std::mutex mutex_;
  std::map<RobotKey, std::shared_ptr<const RobotKind>> robots_;
  std::map<std::string, ModelPtr> models_;
};

}  // namespace murosimf::scene
