#include "murosimf/scene/assets.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/robot/robot_reader.h"

namespace murosimf::scene {

Assets::RobotKey Assets::key_of(const std::filesystem::path& file, const robot_formats::ReaderOptions& options) {
  return {std::filesystem::absolute(file), options.lenient, options.body, options.xacro};
}

std::shared_ptr<const RobotKind> Assets::robot(const std::filesystem::path& file,
                                               const robot_formats::ReaderOptions& options) {
  // The lock is held while a file is read: two scenes that need the same robot read it once.
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const RobotKind>& known = robots_[key_of(file, options)];
  if (known) return known;
  robot::RobotFile read =
      robot::read_robot(file, {.lenient = options.lenient, .xacro = options.xacro, .body = options.body});
  RobotKind kind{std::move(read.model), std::move(read.sensors), std::move(read.warnings), {}};
  for (robot_formats::Unused& unused : read.description.unused) {
    if (std::ranges::find(kind.unused, unused.word) == kind.unused.end()) kind.unused.push_back(std::move(unused.word));
  }
  known = std::make_shared<const RobotKind>(std::move(kind));
  return known;
}

void Assets::put(const std::filesystem::path& file, const robot_formats::ReaderOptions& options, RobotKind kind) {
  MUROSIMF_ASSERT(kind.model != nullptr);
  const std::lock_guard lock(mutex_);
  robots_[key_of(file, options)] = std::make_shared<const RobotKind>(std::move(kind));
}

/// Made under the lock: scenes that are built at the same time must share one model.
ModelPtr Assets::model(const std::string& key, const std::function<ModelPtr()>& make) {
  MUROSIMF_ASSERT(make != nullptr);
  const std::lock_guard lock(mutex_);
  ModelPtr& known = models_[key];
  if (!known) known = make();
  return known;
}

}  // namespace murosimf::scene
