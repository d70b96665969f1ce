/// camera_pose.h - what a robot knows of its own body: where its camera is above the ground, which way it turned.
///
/// From sensors only: joint angles of the sensor `encoders`, put into the robot's model, and the orientation of the sensor
/// `imu`. Up is where the inertial sensor says; the ground is as far below the base as the lowest corner of a sole. The
/// camera is taken to be mounted as its robot's file says (CameraInfo::nominal) and the inertial sensor to have the axes
/// of the object that it sits on: mounting errors of both, bends and delays are not known, and so are errors here too.
/// Of the heading only changes are to be used: a real sensor does not know north.
#pragma once

#include <vector>

#include "murosimf/model/setup.h"
#include "murosimf/model/shape.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/soccer/ground_projection.h"

namespace murosimf::soccer {

class CameraPoseEstimator {
 public:
  /// Throws SetupError if the robot has no sensors `encoders` and `imu`, or no soles.
  CameraPoseEstimator(Setup& setup, const sensors::CameraInfo& camera);

  /// Looks at the sensors' last samples. False until all have shown one.
  bool sense() noexcept;

  [[nodiscard]] const CameraPose& camera() const noexcept { return camera_pose_; }
  [[nodiscard]] double heading() const noexcept { return heading_; }  ///< [rad] of the base, from anywhere

 private:
  /// Something fixed to a link, and the links from the base to there.
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
