#include "murosimf/soccer/camera_pose.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/model/feet.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::soccer {
namespace {

const sensors::Reading& sense_of_body(Setup& setup, const char* sensor) {
  return with_context("a robot that knows where its camera is needs sensors 'encoders' and 'imu'",
                      [&]() -> const sensors::Reading& { return sensors::read_reading(setup, sensor); });
}

FixedObject place_of(const Model& model, const sensors::CameraInfo& camera) {
  FixedObject place = model.placement(camera.link);
  place.offset += place.turn * camera.position;
  place.turn = place.turn * camera.nominal;
  place.turned = true;
  return place;
}

}  // namespace

CameraPoseEstimator::CameraPoseEstimator(Setup& setup, const sensors::CameraInfo& camera)
    : model_(setup.model()),
      encoders_(sense_of_body(setup, "encoders")),
      imu_(sense_of_body(setup, "imu")),
      orientation_(imu_.output("orientation")),
      camera_(part(place_of(model_, camera))),
      inertial_(part(model_.placement(imu_.info->frame.empty() ? 0 : model_.object_index(imu_.info->frame)))),
      q_(static_cast<std::size_t>(model_.size())) {
  // The last line of this list sizes q_ for all objects: chains of several parts share it.
  for (const std::string& joint : encoders_.info->outputs.front().labels) joints_.push_back(model_.object_index(joint));
  MUROSIMF_ASSERT(orientation_.size() == 4 && joints_.size() <= encoders_.values.size());
  for (const murosimf::Foot& foot : feet_of(model_)) feet_.push_back({part(foot.place), foot.sole});
  if (feet_.empty()) throw SetupError("a robot that knows how high its camera is needs soles");
}

CameraPoseEstimator::Part CameraPoseEstimator::part(const FixedObject& place) const {
  Part part{place, {}};
  for (int link = place.link; link > 0; link = model_.tree().links[link].parent) {
    MUROSIMF_ASSERT(model_.tree().links[link].parent < link);
    part.path.push_back(link);
  }
  std::reverse(part.path.begin(), part.path.end());
  return part;
}

bool CameraPoseEstimator::sense() noexcept {
  // an inertial unit shows its orientation before its first sample (sensors/inertial.h)
  const bool no_orientation = std::ranges::all_of(orientation_, [](double number) { return number == 0; });
  if (encoders_.samples == 0 || no_orientation) return false;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(joints_[i]) < q_.size());
    q_[joints_[i]] = encoders_.values[i];
  }
  const auto in_base = [&](const Part& part) {
    return multibody::pose_in_base<double>(model_.tree(), part.path, part.place, q_);
  };
  const Mat3d inertial = to_matrix(Quaterniond{orientation_[0], orientation_[1], orientation_[2], orientation_[3]});
  // The inertial sensor may sit on any link: its orientation, turned back by the joints, is that of the base.
  const Mat3d base = inertial * transpose(in_base(inertial_).orientation);
  heading_ = murosimf::heading(base);
  level_ = rotation_z(-heading_) * base;  // without the heading: it drifts, and the frame is the robot's own
  const auto camera = in_base(camera_);
  camera_pose_ = {level_ * camera.position + Vec3d{0, 0, height()}, level_ * camera.orientation};
  return true;
}

/// [m] of the base above the lowest corner of a sole.
double CameraPoseEstimator::height() const noexcept {
  MUROSIMF_ASSERT(!feet_.empty());
  double lowest = 0;
  for (const Foot& foot : feet_) {
    const auto pose = multibody::pose_in_base<double>(model_.tree(), foot.part.path, foot.part.place, q_);
    for (const double x : {-foot.sole.half_length, foot.sole.half_length}) {
      for (const double y : {-foot.sole.half_width, foot.sole.half_width}) {
        lowest = std::min(lowest, (level_ * (pose.position + pose.orientation * Vec3d{x, y, 0})).z);
      }
    }
  }
  return -lowest;
}

}  // namespace murosimf::soccer
