#include "murosimf/multibody/friction_solver.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/articulated_parts.h"
#include "murosimf/multibody/servo/gear_friction.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {
namespace {

constexpr double locked =
    1e30;  // [kg m^2 | kg] inertia of a sticking joint: large against any robot, far from overflow
constexpr double tolerated = 0.25;  // [1] error of friction as a share of F, in one step
constexpr double slow =
    1e-3;  // [rad/s | m/s] lowest rate that a sliding joint's damper is computed for: bounds F / rate

/// Contribution of a joint to the sweep: 1/D and u.
template <class S>
struct Axle {
  S inverse_D, u;
};

/// Returns sign(p) max(0, |p| - most).
template <class S>
MUROSIMF_INLINE S shrink(const S& p, const S& most) {
  const S left = abs(p) - most;
  const S size = select(left > S(0.0), left, S(0.0));
  return select(p > S(0.0), size, -size);
}

/// Inertia D and torque of a joint without dry friction.
template <class S>
struct Driven {
  S D, torque;
};

/// Adds the motor's line to `rest`, which is everything but the motor, and stores p without the load. `moving` is the part
/// of p that accelerates the joint.
template <class S>
MUROSIMF_INLINE Driven<S> drive_by_motor(FrictionalJoint<S>& j, const Driven<S>& rest, double dt, S& moving) {
  Driven<S> sum;
  // the line depends on the acceleration and the acceleration on the line: at most lines_in_turn steps (torque_line.h)
  TorqueLine<S> line = j.motor.free;
  for (int turn = 0; turn < lines_in_turn; ++turn) {
    sum = {rest.D + line.inertia, rest.torque + line.torque};
    const S to_stop = sum.D * j.rate * (1 / dt);
    j.drive = to_stop + sum.torque;
    j.line = line;
    moving = shrink(j.drive + j.load, j.budget) - to_stop;
    if (turn == 0 && !leaves_free_line(j.motor, sum.D, moving)) break;  // the usual case: no limit is reached
    line = followed_line(j.motor, line, sum.D, moving);
    if (all(line == j.line)) break;
  }
  j.D = sum.D;
  return sum;
}

/// The same, including the end of the joint's range: its line acts if the step without it goes beyond the end.
template <class S>
MUROSIMF_INLINE Driven<S> drive_in_range(FrictionalJoint<S>& j, const S& inertia, double dt) {
  S moving;
  const Driven<S> rest{inertia, j.torque};
  const Driven<S> sum = drive_by_motor(j, rest, dt, moving);
  const auto beyond = is_beyond(j.end, sum.D, moving, dt);
  if (!any(beyond)) return sum;
  const Driven<S> stopped{select(beyond, rest.D + j.end.line.inertia, rest.D),
                          select(beyond, rest.torque + j.end.line.torque, rest.torque)};
  // with the stop the acceleration is another one, so the motor's line is chosen again
  return drive_by_motor(j, stopped, dt, moving);
}

/// Decides whether a joint sticks or slides. `rest` is its inertia without the motor; motor, stop and friction are included.
template <class S>
MUROSIMF_INLINE Axle<S> decide(FrictionalJoint<S>& j, const S& rest, Loads loads, double dt) {
  if (loads !=
      Loads::
          of_repeated_pass) {  // F depends on the load: updating it in repeated passes would make decisions oscillate
    j.budget = j.coulomb;
    if (j.gear) j.budget = j.budget + dry_friction_with_share(*j.gear, j.share, j.motor.now, j.load);
  }
  const auto [D, torque] = drive_in_range(j, rest, dt);
  const S push = j.drive + j.load;
  const S size = abs(push);
  const auto sticks = size < j.budget;
  const S sign = select(push > S(0.0), S(1.0), S(-1.0));
  j.direction = select(sticks, S(0.0), sign);
  const S stop = -locked * (j.rate * (1 / dt));
  if (loads == Loads::of_last_pass) {
    return {1.0 / select(sticks, S(locked), D), select(sticks, stop, torque - sign * j.budget + j.own_load)};
  }
  // in all other cases friction is a damper with the right torque at the predicted rate: it can brake but never drive
  const S end_rate = (size - j.budget) * dt / (D + j.coupled);
  const S damping = j.budget / select(end_rate < S(slow), S(slow), end_rate);
  return {1.0 / select(sticks, S(locked), D + dt * damping),
          select(sticks, stop, torque - damping * j.rate + j.own_load)};
}

/// Computes the Stribeck share s of all joints; it depends on their rates only. Robots alone use lanes for their joints,
/// eight robots at once use lanes for the robots.
void find_shares(std::span<FrictionalJoint<double>> joints) {
  StribeckShares shares;
  for (FrictionalJoint<double>& j : joints) {
    if (j.gear) shares.add(*j.gear, j.rate, j.share);
  }
  shares.write();
}
void find_shares(std::span<FrictionalJoint<Pack8>> joints) {
  for (FrictionalJoint<Pack8>& j : joints) {
    if (j.gear) j.share = stribeck_share(*j.gear, j.rate);
  }
}

/// Whether friction differs by more than the tolerated share of F from what the present p demands.
template <class S>
MUROSIMF_INLINE auto is_wrong(const FrictionalJoint<S>& j) {
  const S push = j.drive + j.load;
  const S along = select(j.direction == S(0.0), j.budget - abs(push), j.direction * push - j.budget);
  return (along < -tolerated * j.budget) & (j.budget > S(0.0));
}

}  // namespace

template <class S>
void sweep_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                         std::span<FrictionalJoint<S>> joints, Loads loads, double dt) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, bodies, joints));
  MUROSIMF_ASSERT(!links.empty() && dt > 0);
  if (loads != Loads::of_repeated_pass) find_shares(joints);
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    ArticulatedLink<S>& body = bodies[l];
    ArticulatedLink<S>& parent = bodies[tree.links[l].parent];
    FrictionalJoint<S>& joint = joints[l];
    const Twist<S>& s = links[l].axis;
    parts::add_link(links[l], body);
    body.U = body.inertia * s;
    joint.own_load = -dot(s, body.force);
    // a' of the parent is that of the last pass; within an island the load stays that of the last step
    if (loads != Loads::of_last_step) joint.load = joint.own_load - dot(parent.acceleration, body.U);
    MUROSIMF_ASSERT(tree.links[l].parent >= 0 && static_cast<std::size_t>(tree.links[l].parent) < l);
    const Axle<S> axle = decide(joint, dot(s, body.U) + joint.inertia, loads, dt);
    body.inverse_D = axle.inverse_D;
    body.u = axle.u;
    parts::hand_over(body, axle.u * axle.inverse_D, parent);
  }
  parts::add_link(links[0], bodies[0]);
}

template <class S>
S accelerate_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                           std::span<FrictionalJoint<S>> joints, const Twist<S>& base) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, bodies, joints));
  MUROSIMF_ASSERT(!bodies.empty());
  bodies[0].acceleration = base;
  S wrong = 0.0;
  for (std::size_t l = 1; l < links.size(); ++l) {
    ArticulatedLink<S>& body = bodies[l];
    const Twist<S>& a = bodies[tree.links[l].parent].acceleration;
    const S carried = dot(a, body.U);
    body.joint_acceleration = (body.u - carried) * body.inverse_D;
    body.acceleration = a + body.joint_acceleration * links[l].axis;
    joints[l].load = joints[l].own_load - carried;
    wrong = wrong + select(is_wrong(joints[l]), S(1.0), S(0.0));
  }
  return wrong;
}

template <class S>
S wrong_decisions(std::span<const FrictionalJoint<S>> joints) noexcept {
  S wrong = 0.0;
  for (std::size_t l = 1; l < joints.size(); ++l) wrong = wrong + select(is_wrong(joints[l]), S(1.0), S(0.0));
  return wrong;
}

bool follow_their_lines(std::span<const FrictionalJoint<double>> joints, double dt) noexcept {
  MUROSIMF_ASSERT(!joints.empty() && dt > 0);
  for (const FrictionalJoint<double>& j : joints.subspan(1)) {
    const double moving = shrink(j.drive + j.load, j.budget) - j.D * j.rate * (1 / dt);
    if (!(followed_line(j.motor, j.line, j.D, moving) == j.line)) return false;
  }
  return true;
}

#define MUROSIMF_INSTANTIATE(S)                                                                                      \
  template void sweep_with_friction<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>,   \
                                       std::span<FrictionalJoint<S>>, Loads, double) noexcept;                       \
  template S accelerate_with_friction<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>, \
                                         std::span<FrictionalJoint<S>>, const Twist<S>&) noexcept;                   \
  template S wrong_decisions<S>(std::span<const FrictionalJoint<S>>) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
