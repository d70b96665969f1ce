/// camera_pose.h - estimates from a robot's own body: the pose of its camera above the ground, and its heading.
///
/// From sensors only: joint angles of the sensor `encoders`, put into the robot's model, and the orientation of the sensor
/// `imu`. The inertial sensor defines up; the ground is as far below the base as the lowest corner of a sole. The
/// camera is mounted as in its robot's file (CameraInfo::nominal) and the inertial sensor has the axes
/// of the object that it sits on: mounting errors of both, bends and delays are unknown here, and so become errors of the pose.
/// Use only changes of the heading: a real sensor does not measure north.
#pragma once

#include <vector>

#include "murosimf/model/shape.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/soccer/ground_projection.h"
#include "murosimf/world/setup.h"

namespace murosimf::soccer {

class CameraPoseEstimator {
 public:
  /// Throws SetupError if the robot has no sensors `encoders` and `imu`, or no soles.
  CameraPoseEstimator(Setup& setup, const sensors::CameraInfo& camera);

  /// Reads the last samples of the sensors. False until all have one.
  bool sense() noexcept;

  [[nodiscard]] const CameraPose& camera() const noexcept { return camera_pose_; }
  [[nodiscard]] double heading() const noexcept {
    return heading_;
  }  ///< [rad] of the base, from an arbitrary direction

 private:
  /// An object fixed to a link, and the links from the base to there.
  struct Part {
    FixedObject place;
    std::vector<int> path;
  };
  struct Foot {
    Part part;
    Sole sole;
  };
  [[nodiscard]] Part part(const FixedObject& place) const;
  [[nodiscard]] double height() const noexcept;

  const Model& model_;
  const sensors::Reading &encoders_, &imu_;
  std::span<const double> orientation_;
  std::vector<int> joints_;  // objects, in the order of the encoders
  Part camera_, inertial_;
  std::vector<Foot> feet_;
  std::vector<double> q_;  // [rad] by object
  Mat3d level_;            // base axes to those of the robot on the ground
  CameraPose camera_pose_;
  double heading_ = 0;
};

}  // namespace murosimf::soccer
