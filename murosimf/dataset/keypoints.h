/// keypoints.h - where named points of things are seen.
#pragma once

#include "murosimf/dataset/annotation.h"
#include "murosimf/dataset/arrangement.h"

namespace murosimf::dataset {

/// Looks for points in one picture.
class KeypointFinder {
 public:
  KeypointFinder(const Viewpoint& from, const sensors::View& view) : from_(&from), view_(&view) {}

  /// A point of the ground: seen where the pixel shows ground or lines.
  [[nodiscard]] Keypoint on_ground(const Vec3d& place) const;
  /// A point of a goal: seen unless something stands in front of it.
  [[nodiscard]] Keypoint of_goal(const Vec3d& place) const;
  /// A point inside of the actor with this label: seen where the pixel shows its surface at most `depth` [m] in front of the point.
  [[nodiscard]] Keypoint inside(const Vec3d& place, std::uint16_t label, double depth) const;
  /// A point in the air beside something.
  [[nodiscard]] Keypoint free(const Vec3d& place) const;

 private:
  struct Found {
    Keypoint keypoint;
    std::uint16_t label = 0;
    double in_front = 0;  ///< [m] by which what the pixel shows is nearer
  };
  [[nodiscard]] Found find(const Vec3d& place) const;

  const Viewpoint* from_;
  const sensors::View* view_;
};

/// Those of a robot: base, joints, front (0.2 m before the base along its x).
[[nodiscard]] std::vector<Keypoint> robot_keypoints(const KeypointFinder& finder, const Actor& robot,
                                                    const PoseFrame& frame);

}  // namespace murosimf::dataset
