#include "murosimf/dataset/keypoints.h"

#include <cmath>

namespace murosimf::dataset {
namespace {

constexpr double limb = 0.15;          // [m] joints are at most so deep inside
constexpr double front = 0.2;          // [m]
constexpr double same_depth = 0.03;    // [m]
constexpr double post_and_net = 0.15;  // [m] before the middle of a post's foot

Keypoint seen_if(bool seen, Keypoint keypoint) {
  if (seen) keypoint.seen = Seen::seen;
  return keypoint;
}

}  // namespace

/// A point beyond the borders is not in the picture.
KeypointFinder::Found KeypointFinder::find(const Vec3d& place) const {
  const Vec3d p = from_->in_camera(place);
  const auto pixel = from_->lens.project(p);
  if (!pixel) return {};
  const long u = std::lround(pixel->u), v = std::lround(pixel->v);
  if (u < 0 || v < 0 || u >= view_->labels.width() || v >= view_->labels.height()) return {};
  const auto column = static_cast<int>(u), row = static_cast<int>(v);
  return {{*pixel, Seen::hidden}, view_->labels(column, row), p.z - view_->depth(column, row)};
}

Keypoint KeypointFinder::on_ground(const Vec3d& place) const {
  const Found found = find(place);
  return seen_if(found.keypoint.seen == Seen::hidden &&
                     (found.label == sensors::label_ground || found.label == sensors::label_line),
                 found.keypoint);
}

Keypoint KeypointFinder::of_goal(const Vec3d& place) const {
  const Found found = find(place);
  return seen_if(found.keypoint.seen == Seen::hidden && found.label < sensors::label_moving_entity &&
                     found.in_front < post_and_net,
                 found.keypoint);
}

Keypoint KeypointFinder::inside(const Vec3d& place, std::uint16_t label, double depth) const {
  const Found found = find(place);
  return seen_if(found.keypoint.seen == Seen::hidden && found.label == label && found.in_front < depth, found.keypoint);
}

Keypoint KeypointFinder::free(const Vec3d& place) const {
  const Found found = find(place);
  return seen_if(found.keypoint.seen == Seen::hidden && found.in_front < same_depth, found.keypoint);
}

std::vector<Keypoint> robot_keypoints(const KeypointFinder& finder, const Actor& robot, const PoseFrame& frame) {
  const std::size_t first = frame.first[robot.place];
  const Vec3d& base = frame.position[first];
  std::vector<Keypoint> points{finder.inside(base, robot.label, limb)};
  for (const int joint : robot.entity->model().joints()) {
    points.push_back(finder.inside(frame.position[first + static_cast<std::size_t>(joint)], robot.label, limb));
  }
  points.push_back(finder.free(base + front * frame.orientation[first].x));
  return points;
}

}  // namespace murosimf::dataset
