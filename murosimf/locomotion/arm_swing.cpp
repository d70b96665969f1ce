#include "murosimf/locomotion/arm_swing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::locomotion {
namespace {

/// The robot in its stance, in level axes.
struct Stance {
  Stance(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& p)
      : tree(model.tree()), q(rest_positions(model)), r(q.size()), R(q.size()) {
    write_pose(legs, gait_pose(legs, p, 0, 0, {}), q);
    R[0] = rotation_y(p.pitch);
    multibody::poses<double>(tree, q, r, R);
  }

  [[nodiscard]] Vec3d place(std::size_t link) const { return r[tree.links[link].object]; }
  [[nodiscard]] Vec3d axis(std::size_t link) const { return R[tree.links[link].object] * tree.links[link].axis; }
  [[nodiscard]] bool hangs_at(std::size_t link, std::size_t joint) const {
    for (int l = static_cast<int>(link); l > 0; l = tree.links[l].parent) {
      if (l == static_cast<int>(joint)) return true;
    }
    return false;
  }
  /// [kg m^2] J of what hangs at a joint.
  [[nodiscard]] double moment(std::size_t joint) const {
    double sum = 0;
    for (std::size_t l = 0; l < tree.links.size(); ++l) {
      const Link& link = tree.links[l];
      const Vec3d center = r[link.object] + R[link.object] * link.com;
      if (hangs_at(l, joint)) sum -= link.mass * center.y * (center.z - place(joint).z);
    }
    return sum;
  }

  const Tree& tree;
  std::vector<double> q;
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

bool is_pitch_hinge(const Stance& stance, std::size_t link) {
  constexpr double along = 0.7;  // [1] of the axis to the left
  return stance.tree.links[link].kind == LinkKind::revolute && std::abs(stance.axis(link).y) > along;
}

bool is_of(const Leg& leg, int object) { return std::ranges::find(leg.joints, object) != leg.joints.end(); }

std::optional<std::size_t> hip_of(const Stance& stance, const Leg& leg) {
  for (std::size_t l = 1; l < stance.tree.links.size(); ++l) {
    if (is_of(leg, stance.tree.links[l].object) && is_pitch_hinge(stance, l)) return l;
  }
  return std::nullopt;
}

/// Of an arm that hangs on that side: it need not swing more than `most` times as far as the leg of that hip.
std::optional<std::size_t> shoulder_of(const Stance& stance, const std::array<Leg, 2>& legs, std::size_t side,
                                       std::size_t hip) {
  constexpr double beside = 0.01, most = 10;  // [m] heads and waists are in the middle; [1]
  for (std::size_t l = 1; l < stance.tree.links.size(); ++l) {
    const int object = stance.tree.links[l].object;
    const Vec3d place = stance.place(l);
    const double outward = side == 0 ? place.y : -place.y;
    if (is_of(legs[0], object) || is_of(legs[1], object) || !is_pitch_hinge(stance, l)) continue;
    if (outward < beside || place.z < stance.place(hip).z) continue;
    if (std::abs(stance.moment(hip)) < most * std::abs(stance.moment(l))) return l;
  }
  return std::nullopt;
}

}  // namespace

ArmSwing::ArmSwing(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& p)
    : swings_(p.arm_swing != 0) {
  if (!swings_) return;
  const Stance stance(model, legs, p);
  const double stands = p.period * (pi + pi * p.double_support) / (2 * pi), leg_swing = stands / (2 * p.hip_height);
  for (const std::size_t side : {0, 1}) {
    const auto hip = hip_of(stance, legs[side]);
    const auto shoulder = hip ? shoulder_of(stance, legs, side, *hip) : std::nullopt;
    if (!shoulder)
      throw SetupError(
          fmt::format("arm_swing: model '{}' has no {} arm that hangs and swings about the axis to the left",
                      model.name(), side == 0 ? "left" : "right"));
    const int joint = stance.tree.links[*shoulder].object;
    const double forward = side == 0 ? 1 : -1, sign = stance.axis(*shoulder).y > 0 ? 1 : -1;
    const double ratio = std::abs(stance.moment(*hip) / stance.moment(*shoulder));
    shoulders_[side] = {joint, stance.q[joint], forward * sign * p.arm_swing * ratio * leg_swing};
  }
}

void ArmSwing::write(double phase, double amplitude, double speed, std::span<double> targets) const noexcept {
  if (!swings_) return;
  const double now = amplitude * speed * std::cos(phase);
  for (const Shoulder& shoulder : shoulders_) targets[shoulder.joint] = shoulder.rest + shoulder.gain * now;
}

}  // namespace murosimf::locomotion
