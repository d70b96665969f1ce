#include "murosimf/locomotion/trot.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/locomotion/stride.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"

namespace murosimf::locomotion {
namespace {

/// [rad] Front left and hind right swing in the second half of the period.
constexpr std::array<double, 4> offsets{pi, 0, 0, pi};

/// [m] Place of a foot at rest in the frame of the base, straight below its hip.
Vec3d place_at_rest(const Leg& leg, const TrotParameters& p) {
  return Vec3d{leg.hip.x, leg.ankle.y, leg.hip.z - p.hip_height + leg.ankle_height} + p.shift;
}

Vec3d middle_of_feet(const std::array<Leg, 4>& legs, const TrotParameters& p) {
  Vec3d sum;
  for (const Leg& leg : legs) sum += 0.25 * place_at_rest(leg, p);
  return sum;
}

/// [m] Center of mass in the frame of the base, with legs at these angles.
Vec3d center_of_mass(const Model& model, const std::array<Leg, 4>& legs, const TrotPose& pose) {
  const auto rows = static_cast<std::size_t>(model.size());
  std::vector<double> q(rows);
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < legs[k].joints.size(); ++i) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(legs[k].joints[i]) < rows);
      q[legs[k].joints[i]] = pose.q[k][i];
    }
  }
  std::vector<Vec3d> r(rows), rest(rows);
  std::vector<Mat3d> R(rows);
  multibody::poses<double>(model.tree(), q, r, R);
  return multibody::common_body<double>(model.tree(), r, R, rest, rest).center;
}

}  // namespace

TrotPose home_pose(const std::array<Leg, 4>& legs) noexcept {
  TrotPose pose;
  for (std::size_t k = 0; k < 4; ++k) {
    MUROSIMF_ASSERT(legs[k].home.size() <= most_hinges);
    std::ranges::copy(legs[k].home, pose.q[k].begin());
  }
  return pose;
}

TrotParameters seeded_trot(const Model& model, const std::array<Leg, 4>& legs) {
  constexpr double own_leg = 0.24;  // [m] leg of the robot that the defaults belong to
  TrotParameters p;
  const double scale = (legs[0].thigh + legs[0].shin) / own_leg;
  const double times = std::sqrt(scale);
  MUROSIMF_ASSERT(scale > 0);
  p.period *= times;
  p.lift *= scale;
  p.hip_height = p.hip_height * scale + legs[0].ankle_height;
  p.slew.x *= scale;
  p.slew.y *= scale;
  p.fastest.x *= times;
  p.fastest.y *= times;
  const TrotPose stand = trot_pose(legs, p, 0, 0, {}, home_pose(legs));
  const Vec3d way = center_of_mass(model, legs, stand) - middle_of_feet(legs, p);
  p.shift = {way.x, way.y, 0};
  return p;
}

TrotPose trot_pose(const std::array<Leg, 4>& legs, const TrotParameters& p, double phase, double amplitude,
                   const Vec3d& velocity, const TrotPose& start) noexcept {
  MUROSIMF_ASSERT(p.period > 0 && p.double_support >= 0);
  const double d = p.double_support * pi / 2;
  const double stance_time = p.period * (pi + 2 * d) / (2 * pi);
  const Vec3d middle = middle_of_feet(legs, p);
  TrotPose pose = start;
  pose.reachable = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const Leg& leg = legs[k];
    const Stride s = stride(phase - offsets[k], d);
    const Vec3d rest = place_at_rest(leg, p);
    // Velocity of the ground below this foot: the whole body turns about the middle of the feet.
    const Vec3d n = rest - middle;
    const Vec3d way{velocity.x - velocity.z * n.y, velocity.y + velocity.z * n.x, 0};
    const Vec3d foot = rest + (s.xi * stance_time) * way + Vec3d{0, 0, amplitude * p.lift * s.lift};
    const bool reached = bend(leg, {.ankle = foot - leg.hip}, std::span(pose.q[k]).first(leg.joints.size()));
    pose.reachable = pose.reachable && reached;
  }
  return pose;
}

Trot::Trot(Setup& setup, const Vec3d& command)
    : Trot(setup, command, seeded_trot(setup.model(), find_four_legs(setup.model()))) {}

Trot::Trot(Setup& setup, const Vec3d& command, const TrotParameters& parameters)
    : legs_(find_four_legs(setup.model())),
      parameters_(parameters),
      clock_(setup, command),
      rest_(rest_positions(setup.model())),
      target_(setup.write(properties::joint_target)) {}

void Trot::initialize() {
  std::ranges::copy(rest_, target_.begin());
  clock_.initialize();
  write_targets(home_pose(legs_));
}

void Trot::step(const Instant& instant) noexcept {
  clock_.advance(seconds(instant.period), {parameters_.period, parameters_.slew, parameters_.fastest});
  TrotPose last;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& joints = legs_[k].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(joints[i]) < target_.size());
      last.q[k][i] = target_[joints[i]];
    }
  }
  write_targets(last);
}

void Trot::write_targets(const TrotPose& start) noexcept {
  const TrotPose pose = trot_pose(legs_, parameters_, clock_.phase(), clock_.amplitude(), clock_.velocity(), start);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& joints = legs_[k].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(joints[i]) < target_.size());
      target_[joints[i]] = pose.q[k][i];
    }
  }
}

}  // namespace murosimf::locomotion
