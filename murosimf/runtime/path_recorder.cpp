#include "murosimf/runtime/path_recorder.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf {

PathRecorder::PathRecorder(Setup& setup, const std::vector<Entity*>& entities) {
  for (Entity* entity : entities) {
    Setup other = setup.of(*entity);
    add(other);
  }
}

void PathRecorder::add(Setup& setup) {
  positions_.push_back(setup.read(properties::position));
  paths_.push_back({&setup.entity(), {}});
}

void PathRecorder::entity_added(Setup& setup) {
  add(setup);
  paths_.back().points.reserve(most_points);
}

void PathRecorder::entity_taken_back(const Entity& entity) noexcept {
  if (paths_.empty() || paths_.back().entity != &entity) return;
  paths_.pop_back();
  positions_.pop_back();
}

/// Gives an entity that enters as many points as the others have: points of equal index belong to one time.
void PathRecorder::entity_entered(const Entity& entity) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    Path& path = paths_[i];
    if (path.entity == &entity && path.points.empty()) path.points.assign(paths_[0].points.size(), positions_[i][0]);
  }
}

void PathRecorder::initialize() {
  for (Path& path : paths_) path.points.reserve(most_points);
  calls_ = 0;
  every_ = 1;
  record();
}

void PathRecorder::state(StateArchive& archive) {
  std::size_t known = paths_.size();
  archive(known);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    if (i < known) {
      archive(paths_[i].points);
    } else {
      paths_[i].points.clear();  // was added since
    }
  }
  archive(calls_, every_);
}

void PathRecorder::step(const Instant&) noexcept {
  if (++calls_ % every_ == 0) record();
}

/// Removes every second point; the start stays, so the points are those of calls that are multiples of 2 every_.
void PathRecorder::thin_out() noexcept {
  for (Path& path : paths_) {
    MUROSIMF_ASSERT(path.points.size() == most_points && "all paths have as many points");
    for (std::size_t i = 0; 2 * i < most_points; ++i) path.points[i] = path.points[2 * i];
    path.points.resize(most_points / 2);
  }
  every_ *= 2;
}

void PathRecorder::record() noexcept {
  if (!paths_.empty() && paths_.front().points.size() == most_points) thin_out();
  MUROSIMF_ASSERT(paths_.size() == positions_.size());
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    MUROSIMF_ASSERT(paths_[i].points.size() < paths_[i].points.capacity() && "a step does not allocate");
    paths_[i].points.push_back(positions_[i][0]);
  }
}

}  // namespace murosimf
