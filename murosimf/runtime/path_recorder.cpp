#include "murosimf/runtime/path_recorder.h"

#include "murosimf/model/properties.h"

namespace murosimf {

PathRecorder::PathRecorder(Setup& setup, const std::vector<Entity*>& entities) {
  for (Entity* entity : entities) {
    paths_.push_back({entity, {}});
    positions_.push_back(setup.of(*entity).read(properties::position));
  }
}

void PathRecorder::initialize() {
  for (Path& path : paths_) path.points.reserve(4096);
  record();
}

void PathRecorder::step(const Instant&) noexcept { record(); }

void PathRecorder::record() noexcept {
  for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].points.push_back(positions_[i][0]);
}

}  // namespace murosimf
