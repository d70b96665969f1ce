#include "murosimf/soccer/obstacle_map.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::soccer {

std::optional<ObstacleSighting> obstacle_of(const Blob& blob, const imaging::Lens& lens, const CameraPose& pose,
                                            double radius, double farthest) noexcept {
  MUROSIMF_ASSERT(radius >= 0 && farthest > 0);
  const imaging::LensSpec& picture = lens.spec();
  // The foot of the obstacle is out of the picture: its distance is unknown.
  if (blob.bottom >= picture.height - 1) return std::nullopt;
  const auto foot = on_ground(lens, pose, {blob.lowest.u, blob.lowest.v + 0.5});
  if (!foot) return std::nullopt;
  const Vec3d eye{pose.eye.x, pose.eye.y, 0}, sight = *foot - eye;
  const double distance = norm(sight);
  if (distance <= 0 || distance > farthest) return std::nullopt;
  return ObstacleSighting{*foot + (radius / distance) * sight, blob.left > 0 && blob.right < picture.width - 1};
}

void ObstacleMap::state(StateArchive& archive) {
  archive.elements(std::span<Obstacle>(obstacles_));
  archive(count_);
  if (count_ > most_obstacles) throw SetupError("it has more obstacles than there is room for");
}

void ObstacleMap::see(const Vec3d& place, bool whole, double same) noexcept {
  MUROSIMF_ASSERT(count_ <= most_obstacles);
  Obstacle* nearest = nullptr;
  double least = same;
  for (std::size_t i = 0; i < count_; ++i) {
    const double away = norm(Vec3d(obstacles_[i].place - place));
    if (away >= least) continue;
    least = away;
    nearest = &obstacles_[i];
  }
  if (nearest == nullptr) {
    if (count_ < most_obstacles) obstacles_[count_++] = {place, 1};
    return;
  }
  ++nearest->sightings;
  // A mean at first, then a filter: the odometry drifts, so that old sightings lose their weight.
  if (whole) nearest->place += std::max(0.2, 1.0 / nearest->sightings) * (place - nearest->place);
}

}  // namespace murosimf::soccer
