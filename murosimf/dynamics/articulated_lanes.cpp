#include "murosimf/dynamics/articulated_lanes.h"

#include <algorithm>
#include <bit>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

constexpr double minus_zero = -0.0;  // x + -0 has the bits of x, also for x = 0 and -0

/// Initializes a body that counts as loaded because some lanes have a load: with numbers that change no bit in the other lanes.
void fill_unloaded(multibody::ArticulatedLink<Pack8>& body, bool leaf) {
  const Pack8 none = minus_zero;
  const Vec3<Pack8> no_vector{none, none, none};
  body.force = {no_vector, no_vector};
  body.inertia = {{none, none, none, none, none, none},
                  {no_vector, no_vector, no_vector},
                  {none, none, none, none, none, none}};
  body.loaded = true;
  if (!leaf) return;
  // where a rigid body's inertia is 0, a link without children has exactly that
  body.inertia.H.x.x = body.inertia.H.y.y = body.inertia.H.z.z = 0.0;
  body.inertia.M.xy = body.inertia.M.xz = body.inertia.M.yz = 0.0;
}

}  // namespace

/// Wheels, backlash, heat and couplings have branches that differ from robot to robot: such robots step alone.
bool ArticulatedDynamics::goes_with(const Algorithm& other) const {
  const auto* same = dynamic_cast<const ArticulatedDynamics*>(&other);
  return same && tree_.goes_with(same->tree_) && servo_law_ == same->servo_law_ && couplings_.empty() &&
         drives_.are_alike() && motor_torque_.empty() == same->motor_torque_.empty();
}

std::unique_ptr<LaneGroup> ArticulatedDynamics::join(std::span<Algorithm* const> members) const {
  MUROSIMF_ASSERT(!members.empty() && members.size() <= Pack8::lanes);
  return std::make_unique<ArticulatedLanes>(members_of<ArticulatedDynamics>(members));
}

ArticulatedLanes::ArticulatedLanes(std::vector<ArticulatedDynamics*> members)
    : members_(std::move(members)),
      trees_(parts_of(members_, [](ArticulatedDynamics& member) { return &member.tree_; })),
      motors_(parts_of(members_, [](const ArticulatedDynamics& member) { return &member.drives_; })),
      leaf_(trees_.links.size(), true),
      viscous_(trees_.links.size()),
      friction_(trees_.links.size()),
      bodies_(trees_.links.size()),
      joint_torque_(trees_.links.size()),
      motor_torque_(trees_.links.size()),
      outcome_(trees_.links.size()),
      loaded_(trees_.links.size()) {
  MUROSIMF_ASSERT(!members_.empty() && members_.size() <= Pack8::lanes);
  for (const Link& link : trees_.poses.structure.links) {
    if (link.parent >= 0) leaf_[static_cast<std::size_t>(link.parent)] = false;
  }
}

void ArticulatedLanes::step(LaneMask due, const Instant& instant) noexcept {
  if (std::popcount(due) < fewest_in_lanes)
    return for_lanes(due, [&](int lane) { member(lane).step(of_lane(lane, instant)); });
  dt_ = seconds(instant.period);
  const LaneMask lanes = trees_.ready(due);
  LaneMask moved = 0;
  if (lanes != 0) {
    begin(lanes);
    settle(lanes);
    moved = end(lanes);
  }
  const LaneMask alone = advance_alone(due & ~lanes);
  MUROSIMF_ASSERT((moved & ~lanes) == 0);
  trees_.finish_step(moved | alone, alone);
}

/// Advances robots that step alone; returns the lanes that have moved.
LaneMask ArticulatedLanes::advance_alone(LaneMask lanes) noexcept {
  LaneMask moved = 0;
  for_lanes(lanes, [&](int lane) {
    if (!member(lane).advance(dt_)) return;
    trees_.take_advanced(lane);
    moved |= lane_bit(lane);
  });
  return moved;
}

void ArticulatedLanes::begin(LaneMask lanes) noexcept {
  for_lanes(lanes, [&](int lane) {
    ArticulatedDynamics& robot = member(lane);
    robot.dt_ = dt_;
    robot.targets_sane_ = robot.drives_.take_targets(dt_);
  });
  trees_.take(lanes);
  trees_.look_for_loads(lanes);
  recall_loads(lanes);
  motors_.take_inputs(trees_.poses, lanes);
  drive_joints();
}

void ArticulatedLanes::recall_loads(LaneMask lanes) noexcept {
  PoseLanes& poses = trees_.poses;
  poses.take(
      poses.links(), lanes, [&](std::size_t l) -> Twist<Pack8>& { return bodies_[l].acceleration; },
      [&](int lane) { return member(lane).felt_acceleration_.data(); });
  poses.take(
      poses.links(), lanes, [&](std::size_t l) -> Pack8& { return friction_[l].load; },
      [&](int lane) { return member(lane).joint_load_.data(); });
}

void ArticulatedLanes::drive_joints() noexcept {
  const auto& links = trees_.poses.structure.links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const auto i = static_cast<std::size_t>(links[l].object);
    viscous_[l] = motors_.drive(l, links[l].object, trees_.poses.q[i], trees_.poses.qd[i], dt_, friction_[l]);
  }
}

/// ContactTrials::settle, in all lanes at once. Settled lanes keep their outcome while the others repeat their passes.
void ArticulatedLanes::settle(LaneMask lanes) noexcept {
  LaneMask open = lanes;
  auto loads = multibody::Loads::of_last_pass;
  for (int passes_left = collision::max_passes - 1;; --passes_left) {
    MUROSIMF_ASSERT(passes_left >= 0 && (open & ~lanes) == 0);
    gather_loads(open);
    const bool some_are_settled = open != lanes;
    if (some_are_settled) keep_outcomes();
    const Pack8 wrong = pass(loads);
    if (some_are_settled) recall_outcomes(open);
    for_lanes(open, [&](int lane) {
      predict_contacts(lane);
      if (passes_left > 0 && member(lane).tree_.contacts.accept() && wrong.lane(lane) == 0) open &= ~lane_bit(lane);
    });
    if (passes_left == 0 || open == 0) return;
    loads = multibody::Loads::of_repeated_pass;
  }
}

void ArticulatedLanes::gather_loads(LaneMask lanes) noexcept {
  multibody::clear_loads<Pack8>(bodies_);
  std::fill(loaded_.begin(), loaded_.end(), LaneMask{0});
  trees_.for_loads(lanes, dt_, [&](std::size_t link, LaneMask some, const auto& force, const auto& damping) {
    add_load(link, some, force, damping);
  });
}

/// multibody::add_load with the same bits as for one robot: a lane's first load starts from zero, not from fill_unloaded's -0.
void ArticulatedLanes::add_load(std::size_t link, LaneMask lanes, const Wrench<Pack8>& force,
                                const Sym6<Pack8>& damping) noexcept {
  MUROSIMF_ASSERT(link < bodies_.size() && lanes != 0);
  auto& body = bodies_[link];
  if (!body.loaded) fill_unloaded(body, leaf_[link]);
  Sym6<Pack8> inertia = body.inertia;
  Wrench<Pack8> left = body.force;
  const Pack8::Mask first = where(lanes & ~loaded_[link]);
  assign_where(first, Sym6<Pack8>{}, inertia);
  assign_where(first, Wrench<Pack8>{}, left);
  inertia += damping;
  left -= force;
  assign_where(where(lanes), inertia, body.inertia);
  assign_where(where(lanes), left, body.force);
  loaded_[link] |= lanes;
}

/// Executes a trial step. Returns the number of wrong decisions about the joints of each robot.
Pack8 ArticulatedLanes::pass(multibody::Loads loads) noexcept {
  const Tree& tree = trees_.poses.structure;
  multibody::sweep_with_friction<Pack8>(tree, trees_.links, bodies_, friction_, loads, dt_);
  const Twist<Pack8> base = solve(bodies_[0].inertia, -1.0 * bodies_[0].force);
  return multibody::accelerate_with_friction<Pack8>(tree, trees_.links, bodies_, friction_, base);
}

void ArticulatedLanes::predict_contacts(int lane) noexcept {
  trees_.predict_contacts(lane, dt_, [&](int link) {
    return lane_of(bodies_[static_cast<std::size_t>(link)].acceleration, lane);
  });
}

void ArticulatedLanes::keep_outcomes() noexcept {
  for (std::size_t l = 0; l < bodies_.size(); ++l) {
    const auto& joint = friction_[l];
    outcome_[l] = {bodies_[l].acceleration,
                   bodies_[l].joint_acceleration,
                   joint.load,
                   joint.drive,
                   joint.budget,
                   joint.direction,
                   joint.line};
  }
}

/// Restores the outcome of the lanes that are settled.
void ArticulatedLanes::recall_outcomes(LaneMask open) noexcept {
  const Pack8::Mask settled = where(~open);
  const auto choose = [&](Pack8& now, const Pack8& kept) { now = select(settled, kept, now); };
  for (std::size_t l = 0; l < bodies_.size(); ++l) {
    const Outcome<Pack8>& kept = outcome_[l];
    assign_where(settled, kept.acceleration, bodies_[l].acceleration);
    choose(bodies_[l].joint_acceleration, kept.joint_acceleration);
    choose(friction_[l].load, kept.load);
    choose(friction_[l].drive, kept.drive);
    choose(friction_[l].budget, kept.budget);
    choose(friction_[l].direction, kept.direction);
    choose(friction_[l].line.torque, kept.line.torque);
    choose(friction_[l].line.inertia, kept.line.inertia);
  }
}

/// Ends the accelerations of a step; returns the lanes that have moved. The rest of their step is TreeLanes::finish_step.
LaneMask ArticulatedLanes::end(LaneMask lanes) noexcept {
  const LaneMask of_sane_rates = lanes_of_sane_rates();
  LaneMask together = 0;
  // halting is done lane by lane and first: lanes that halt take no part in what follows
  for_lanes(lanes, [&](int lane) {
    ArticulatedDynamics& robot = member(lane);
    const bool base_is_sane = is_sane(lane_of(bodies_[0].acceleration, lane), dt_);
    if (!robot.targets_sane_) return robot.tree_.halt(joints_insane);
    if (!has_lane(of_sane_rates, lane) || !base_is_sane) return robot.tree_.halt(too_fast);
    together |= lane_bit(lane);
  });
  report_torques(together);
  keep_loads(together);
  watch_saturation(together);
  for_lanes(together, [&](int lane) { member(lane).tree_.contacts.commit(); });
  const LaneMask moved = trees_.advance_bases(bodies_[0].acceleration, dt_, together);
  for_lanes(together & ~moved, [&](int lane) { member(lane).tree_.halt(too_fast); });
  advance_joints(moved);
  return moved;
}

/// As ArticulatedDynamics::accelerations_are_sane, without the base.
LaneMask ArticulatedLanes::lanes_of_sane_rates() const noexcept {
  Pack8 rates = 0.0, positions = 0.0;
  for (std::size_t l = 1; l < bodies_.size(); ++l) {
    const auto i = static_cast<std::size_t>(trees_.poses.structure.links[l].object);
    rates = rates + abs(trees_.poses.qd[i] + dt_ * bodies_[l].joint_acceleration);
    positions = positions + abs(trees_.poses.q[i]);
  }
  LaneMask sane = 0;
  for (int lane = 0; lane < Pack8::lanes; ++lane) {
    if (rates.lane(lane) < fastest_joint && positions.lane(lane) < farthest_joint) sane |= lane_bit(lane);
  }
  return sane;
}

/// ArticulatedDynamics::report_torques.
void ArticulatedLanes::report_torques(LaneMask lanes) noexcept {
  for (std::size_t l = 1; l < bodies_.size(); ++l) {
    const auto& joint = friction_[l];
    const Pack8& acceleration = bodies_[l].joint_acceleration;
    motor_torque_[l] = joint.line.torque - joint.line.inertia * acceleration;
    Pack8 torque = motor_torque_[l] + (viscous_[l].torque - viscous_[l].inertia * acceleration);
    if (joint.gear) {
      const Pack8 more = torque + (1.0 - joint.coulomb / joint.budget) * multibody::friction_torque(joint);
      torque = select(joint.budget > Pack8(0.0), more, torque);
    }
    joint_torque_[l] = torque;
  }
  PoseLanes& poses = trees_.poses;
  const auto put_back = [&](const std::vector<Pack8>& by_link, const auto& column) {
    poses.put_back(
        poses.joints(), lanes, [&](std::size_t k) -> const Pack8& { return by_link[k + 1]; }, column);
  };
  put_back(joint_torque_, [&](int lane) { return member(lane).joint_torque_.data(); });
  if (members_.front()->motor_torque_.empty()) return;
  put_back(motor_torque_, [&](int lane) { return member(lane).motor_torque_.data(); });
}

/// SaturationWatch::look, in all lanes at once.
void ArticulatedLanes::watch_saturation(LaneMask lanes) noexcept {
  for_lanes(lanes, [&](int lane) { member(lane).saturation_.begin(dt_); });
  const auto& links = trees_.poses.structure.links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const auto free = multibody::is_free(friction_[l]);
    if (all(free)) continue;
    const Pack8 at_bound = select(free, Pack8(0.0), Pack8(1.0));
    for_lanes(lanes, [&](int lane) {
      if (at_bound.lane(lane) != 0) member(lane).saturation_.add(links[l].object, dt_);
    });
  }
}

void ArticulatedLanes::keep_loads(LaneMask lanes) noexcept {
  PoseLanes& poses = trees_.poses;
  poses.put_back(
      poses.links(), lanes, [&](std::size_t l) -> const Twist<Pack8>& { return bodies_[l].acceleration; },
      [&](int lane) { return member(lane).felt_acceleration_.data(); });
  poses.put_back(
      poses.links(), lanes, [&](std::size_t l) -> const Pack8& { return friction_[l].load; },
      [&](int lane) { return member(lane).joint_load_.data(); });
}

void ArticulatedLanes::advance_joints(LaneMask lanes) noexcept {
  PoseLanes& poses = trees_.poses;
  const auto& links = poses.structure.links;
  for (std::size_t l = 1; l < links.size(); ++l) {
    const auto i = static_cast<std::size_t>(links[l].object);
    const Pack8 rate = poses.qd[i] + dt_ * bodies_[l].joint_acceleration;
    poses.qd[i] = select(friction_[l].direction == Pack8(0.0), Pack8(0.0), rate);
    poses.q[i] = poses.q[i] + dt_ * poses.qd[i];
  }
  poses.put_back_joints(lanes);
}

}  // namespace murosimf::dynamics
