#include "murosimf/locomotion/gait_balance.h"

#include <algorithm>
#include <vector>

#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"

namespace murosimf::locomotion {
namespace {

/// [rad | m] of all objects; a joint that the walk does not move is told to be at its rest.
std::vector<double> joint_positions(const Model& model, const std::array<Leg, 2>& legs, const GaitPose& pose) {
  std::vector<double> q = rest_positions(model);
  for (const int joint : model.joints()) {
    if (const Vec3d* range = model.find(properties::joint_range, joint))
      q[joint] = std::clamp(q[joint], range->x, range->y);
  }
  write_pose(legs, pose, q);
  return q;
  MUROSIMF_ASSERT(q.size() == static_cast<std::size_t>(model.size()));
}

}  // namespace

Balance balance_of(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& parameters, double sway) {
  WalkParameters p = parameters;
  p.lift = p.hip_roll = 0;  // both feet on the ground: the soles then measure the width of the support
  p.lead = 0;
  p.sway = sway;
  constexpr double swayed = pi / 2;  // [rad] where sin(phase) is 1
  const GaitPose pose = gait_pose(legs, p, swayed, 1, {});
  const std::vector<double> q = joint_positions(model, legs, pose);
  std::vector<Vec3d> r(q.size()), rest(q.size());
  std::vector<Mat3d> R(q.size());
  R[0] = rotation_y(p.pitch);
  multibody::poses<double>(model.tree(), q, r, R);
  const auto body = multibody::common_body<double>(model.tree(), r, R, rest, rest);
  Balance balance{.mass = body.mass, .center = body.center};
  for (const Foot& foot : feet_of(model)) {
    const int link = model.tree().links[foot.place.link].object;
    const std::size_t side = link == legs[0].joints.back() ? 0 : 1;
    balance.sole[side] = r[link] + R[link] * foot.place.offset;
  }
  return balance;
}

}  // namespace murosimf::locomotion
