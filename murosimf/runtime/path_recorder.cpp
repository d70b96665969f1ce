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
  for (Path& path : paths_) path.points.reserve(most_points);
  calls_ = 0;
  every_ = 1;
  record();
}

void PathRecorder::state(StateArchive& archive) {
  for (Path& path : paths_) archive(path.points);
  archive(calls_, every_);
}

void PathRecorder::step(const Instant&) noexcept {
  if (++calls_ % every_ == 0) record();
}

/// The start stays; so the points are those of calls that 2 every_ divides.
void PathRecorder::thin_out() noexcept {
  for (Path& path : paths_) {
    for (std::size_t i = 0; 2 * i < most_points; ++i) path.points[i] = path.points[2 * i];
    path.points.resize(most_points / 2);
  }
  every_ *= 2;
}

void PathRecorder::record() noexcept {
  if (!paths_.empty() && paths_.front().points.size() == most_points) thin_out();
  for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].points.push_back(positions_[i][0]);
}

}  // namespace murosimf
