#include "murosimf/locomotion/balanced_gait.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

double without_dead_zone(double x, double zone) noexcept { return x > zone ? x - zone : x < -zone ? x + zone : 0.0; }
/// `x` beyond the dead zone, at most `most` in size.

double cut(double x, double zone, double most) noexcept {
  MUROSIMF_ASSERT(zone >= 0 && most >= 0);
  return std::clamp(without_dead_zone(x, zone), -most, most);
}

double outward(std::size_t side) noexcept {
  MUROSIMF_ASSERT(side < 2);
  return side == 0 ? 1 : -1;
}

StepSignals difference(const StepSignals& a, const StepSignals& b) noexcept {
  return {a.forward - b.forward, a.outward - b.outward,     a.pitch - b.pitch,
          a.roll - b.roll,       a.roll_rate - b.roll_rate, a.pitch_rate - b.pitch_rate};
}

StepSignals scaled(double factor, const StepSignals& s) noexcept {
  return {factor * s.forward, factor * s.outward,   factor * s.pitch,
          factor * s.roll,    factor * s.roll_rate, factor * s.pitch_rate};
}

StepSignals blended(const StepSignals& a, const StepSignals& b, double share) noexcept {
  const StepSignals step = scaled(share, difference(b, a));
  return {a.forward + step.forward, a.outward + step.outward,     a.pitch + step.pitch,
          a.roll + step.roll,       a.roll_rate + step.roll_rate, a.pitch_rate + step.pitch_rate};
}

}  // namespace

BalancedGait::BalancedGait(const std::array<Leg, 2>& legs, const WalkParameters& walk, const GaitFeedback& feedback,
                           double stance, StepTablePtr table)
    : legs_(legs), walk_(walk), feedback_(feedback), stands_wider_(stance - walk.half_width), table_(std::move(table)) {
  for (std::size_t side = 0; side < 2; ++side) {
    constexpr double like =
        0.7;  // [1] cosine of the angle to the forward axis from which on a hinge counts as a roll joint
    const std::vector<double> zero(legs_[side].joints.size());
    const ChainPose pose = pose_of(legs_[side].chain, zero);
    // From the sole to the hip, so that the hinge nearest to the base is the one that remains.
    for (std::size_t i = zero.size(); i-- > 0;) {
      if (std::abs(pose.axis[i].x) < like) continue;
      roll_hinge_[side] = i;
      roll_sign_[side] = pose.axis[i].x > 0 ? 1 : -1;
    }
  }
  MUROSIMF_ASSERT(roll_hinge_[0] < legs_[0].joints.size() && roll_hinge_[1] < legs_[1].joints.size());
}

GaitPose BalancedGait::stance() const noexcept {
  WalkParameters walk = walk_;
  walk.half_width += stands_wider_;
  return gait_pose(legs_, walk, 0, 0, {});
}

bool BalancedGait::has_width(const GaitState& state, double width) const noexcept {
  constexpr double near_enough = 1e-3;  // [m]
  return std::ranges::all_of(state.width, [&](double own) { return std::abs(own - width) < near_enough; });
}

/// Moves each foot while it is lifted: a foot that stands would be dragged, and remain somewhere on the way.
void BalancedGait::move_apart(double dt, const GaitClock& clock, double width, GaitState& state) const noexcept {
  MUROSIMF_ASSERT(dt > 0);
  constexpr double lifted = 0.5, leaves = 0.1, lands = 0.9;  // [1] of the amplitude, of a step
  constexpr double speed = 0.4;                              // [m/s]
  if (clock.amplitude() < lifted || clock.share() < leaves || clock.share() > lands) return;
  double& own = state.width[1 - clock.standing()];
  own += std::clamp(width - own, -speed * dt, speed * dt);
}

void BalancedGait::feel(double dt, const GaitClock& clock, std::span<const double> targets, WalkSenses& senses,
                        GaitState& state) const noexcept {
  const std::size_t standing = clock.standing();
  MUROSIMF_ASSERT(dt > 0 && targets.size() == senses.joints().size());
  senses.follow(dt, standing, {feedback_.smoothing, feedback_.omega, feedback_.still_rate}, state);
  double sum = 0, count = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const int joint : legs_[side].joints) {
      sum += std::abs(targets[joint] - senses.joints()[joint]);
      ++count;
    }
    // The lag of a loaded hip is its droop; an unloaded one has none, so the estimate decays.
    const int roll = legs_[side].joints[roll_hinge_[side]];
    const bool loaded = side == standing && clock.amplitude() > 0.5;
    constexpr double follows = 0.4, fades = 0.6;  // [1] in a cycle
    double& lag = state.roll_lag[side];
    lag = loaded ? lag + follows * (state.roll_target[side] - senses.joints()[roll] - lag) : fades * lag;
  }
  MUROSIMF_ASSERT(count > 0 && feedback_.compliant_lag > 0);
  constexpr double memory = 1;  // [s]
  state.lag += dt / memory * (sum / count - state.lag);
  state.compliance = std::clamp(state.lag / feedback_.compliant_lag, 0.0, 1.0);
}

/// The slope is the pitch of the sole that stands: in the middle of its step it lies flat on the ground. The numbers were chosen by walks
/// of kid21 on 3 degrees (docs/motions.md, "Slopes").
void BalancedGait::feel_slope(double dt, const GaitClock& clock, const WalkSenses& senses,
                              GaitState& state) const noexcept {
  MUROSIMF_ASSERT(dt > 0);
  constexpr double flat_from = 0.3, flat_to = 0.8;  // [1] of a step
  constexpr double memory = 0.5;                    // [s]
  constexpr double jump = 0.1, steepest = 0.2;      // [rad]
  const bool lies_flat =
      clock.amplitude() == 0 ? state.still > 0 : clock.share() > flat_from && clock.share() < flat_to;
  if (!table_ || !lies_flat) return;
  const double found = senses.sole_pitch(clock.standing(), state);
  state.slope += dt / memory * std::clamp(found - state.slope, -jump, jump);
  state.slope = std::clamp(state.slope, -steepest, steepest);
}

void BalancedGait::find_deviation(const GaitClock& clock, GaitState& state) const noexcept {
  state.deviation = {};
  double zone = feedback_.dead_zone;
  if (clock.amplitude() > 0) {
    if (!table_) return;
    const double mirror = outward(clock.standing());
    const Vec3d& v = clock.velocity();
    if (norm(v) > 0) zone += (1 - state.compliance) * feedback_.rigid_dead_zone;
    const StepSignals steady =
        steady_signals(*table_, state.compliance, clock.share(), {v.x, mirror * v.y, mirror * v.z});
    StepSignals off = difference(state.signals, steady);
    off.outward += state.width[clock.standing()];  // from an ankle that is farther outside all is farther inside
    state.deviation = scaled(std::min(1.0, clock.amplitude()), off);
  } else if (state.settled > 0) {
    state.deviation = difference(state.signals, state.upright);
  }
  state.deviation.forward = cut(state.deviation.forward, zone, feedback_.most_deviation);
  state.deviation.outward = cut(state.deviation.outward, zone, feedback_.most_deviation);
}

/// Odometry sways with the steps, so ways are taken between the same instants of two periods: where the same foot begins to stand.
void BalancedGait::follow_command(double dt, std::size_t stood, const GaitClock& clock, const GaitLimits& limits,
                                  const WalkSenses& senses, GaitState& state) const noexcept {
  MUROSIMF_ASSERT(dt > 0 && stood < 2);
  if (feedback_.trim == 0) return;
  if (clock.amplitude() < 1 || clock.is_idle(limits)) {
    state.passed = {};
    return;
  }
  for (double& time : state.passed) time += time > 0 ? dt : 0;
  const std::size_t stands = clock.standing();
  if (stands == stood) return;
  const Vec3d& here = senses.odometry();
  if (const double time = state.passed[stands]; time > 0) {
    const Vec3d& from = state.mark[stands];
    const Vec3d way = rotation_z(-0.5 * (from.z + here.z)) * Vec3d{here.x - from.x, here.y - from.y, 0};
    const Vec3d came{way.x, way.y, here.z - from.z};
    // Both feet take part: each period counts twice.
    state.trim += 0.5 * feedback_.trim * (time * clock.wanted(limits) - came);
    constexpr double most = 0.7;  // [1] of the largest velocity: a robot that is held does not add up for ever
    const Vec3d limit = most * walk_.fastest;
    state.trim = {std::clamp(state.trim.x, -limit.x, limit.x), std::clamp(state.trim.y, -limit.y, limit.y),
                  std::clamp(state.trim.z, -limit.z, limit.z)};
  }
  state.mark[stands] = here;
  state.passed[stands] = dt;
}

/// Decides on stepping: learns the upright signals at rest, starts to step where ankles are not enough, ends when the deviation is small.
void BalancedGait::watch(double dt, GaitClock& clock, GaitState& state) const noexcept {
  constexpr double calm = 1.0;  // [s] of steps on the spot, after the last deviation
  const StepSignals& e = state.deviation;
  const bool off = std::max(std::abs(e.forward), std::abs(e.outward)) > feedback_.step_at;
  state.alarm = off ? calm : std::max(0.0, state.alarm - dt);
  if (clock.amplitude() > 0) {
    state.settled = 0;
    return;
  }
  constexpr double still = 0.2, memory = 1;  // [s]
  if (state.still > still) {
    // Mean over the time at rest, at most one second: a running mean without a buffer.
    state.settled = std::min(memory, state.settled + dt);
    state.upright = blended(state.upright, state.signals, dt / state.settled);
  }
  if (!off || state.settled < memory / 2) return;
  // The foot on the side of the fall swings first: at rest, the left foot counts as the standing one.
  constexpr double early = 0.15, begins = 0.6;  // [1] of a step, of the amplitude
  const bool falls_left = e.outward > std::abs(0.5 * e.forward);
  clock.start_at((falls_left ? pi : 0) + early * pi, begins);
  state.deviation = {};
}

double BalancedGait::phase_rate(const GaitState& state) const noexcept {
  MUROSIMF_ASSERT(feedback_.slowest <= feedback_.quickest);
  const StepSignals& e = state.deviation;
  // It falls over the standing foot, which the swinging one cannot cross: only the step after this one helps.
  if (e.outward > feedback_.hurry_at) return feedback_.quickest;
  const double rate = 1 - feedback_.timing_sideways * e.outward + feedback_.timing_forward * std::abs(e.forward);
  return std::clamp(rate, feedback_.slowest, feedback_.quickest);
}

/// Moves the swinging foot to where the capture point will be. `left` [s]: rest of the step in which `stood` stands.
void BalancedGait::place_steps(double dt, const GaitClock& clock, std::size_t stood, double left,
                               GaitState& state) const noexcept {
  MUROSIMF_ASSERT(dt > 0 && stood < 2);
  if (clock.standing() != stood) return;
  constexpr double placed = 0.9;  // [1] of a step: from there on the foot comes down and must not move sideways
  const GaitFeedback& f = feedback_;
  // Along the unstable mode of the pendulum a deviation grows by exp(omega T) until the step ends.
  const double grows = std::exp(f.omega * left), out = outward(stood);
  // Outward of the standing foot is towards the swinging one: the bounds of the two directions differ.
  const Vec3d goal{std::clamp(f.step_forward * state.deviation.forward * grows, -f.most_forward, f.most_forward),
                   out * std::clamp(f.step_sideways * state.deviation.outward * grows, -f.most_sideways, f.most_inward),
                   0};
  Vec3d& swinging = state.offset[1 - stood];
  if (clock.share() < placed) {
    const double most = f.offset_speed * dt;
    swinging.x += std::clamp(goal.x - swinging.x, -most, most);
    swinging.y += std::clamp(goal.y - swinging.y, -most, most);
  }
  Vec3d& standing = state.offset[stood];
  standing = std::max(0.0, 1 - dt / f.step_decay) * standing;
}

GaitFeet BalancedGait::open_loop(const GaitClock& clock, const GaitState& state) const noexcept {
  const Vec3d& velocity = clock.velocity();
  GaitFeet feet = gait_feet(legs_, walk_, clock.phase(), clock.amplitude(), velocity, feedback_.stride_gain,
                            feedback_.setback_per_speed * velocity.x);
  // Joints that follow at once jar the soles, whose pitch says little about the ground there.
  constexpr double level = 0.005, jarred = 0.2;  // [rad] of a slope that is none
  const double zone = level + (1 - state.compliance) * jarred;
  const double slope = feedback_.slope * without_dead_zone(state.slope, zone);
  const Mat3d incline = rotation_y(slope);
  for (std::size_t side = 0; side < 2; ++side) {
    feet.ankle[side] += state.offset[side] + Vec3d{0, outward(side) * state.width[side], 0};
    feet.ankle[side].z -= feet.ankle[side].x * std::tan(slope);
    feet.sole[side] = incline * feet.sole[side];
  }
  return feet;
}

/// Places the swinging foot relative to the standing one and levels its sole; the ankle of the standing one presses.
void BalancedGait::turn_feet(const GaitClock& clock, const GaitState& state, GaitFeet& feet) const noexcept {
  const GaitFeedback& f = feedback_;
  const StepSignals& e = state.deviation;
  const std::size_t standing = clock.standing(), swinging = 1 - standing;
  MUROSIMF_ASSERT(standing < 2);
  const double out = outward(standing);
  const Mat3d undo = rotation_x(-f.foot_level * out * e.roll) * rotation_y(-f.foot_level * e.pitch);
  const Vec3d between = legs_[swinging].hip + feet.ankle[swinging] - legs_[standing].hip - feet.ankle[standing];
  if (clock.amplitude() > 0) {
    feet.ankle[swinging] = legs_[standing].hip + feet.ankle[standing] + undo * between - legs_[swinging].hip;
    feet.sole[swinging] = undo * feet.sole[swinging];
  }
  constexpr double most_pitch = 0.4, most_roll = 0.3;  // [rad]
  const double pitch =
      std::clamp(f.ankle_pitch * e.pitch + f.ankle_pitch_rate * e.pitch_rate + f.ankle_forward * e.forward, -most_pitch,
                 most_pitch);
  const double roll = std::clamp(f.ankle_roll * e.roll + f.ankle_roll_rate * e.roll_rate - f.ankle_sideways * e.outward,
                                 -most_roll, most_roll);
  const Mat3d press = rotation_y(pitch) * rotation_x(out * roll);
  feet.sole[standing] = press * feet.sole[standing];
  if (clock.amplitude() == 0) feet.sole[swinging] = press * feet.sole[swinging];  // both stand
}

GaitPose BalancedGait::bend_legs(const GaitClock& clock, const GaitFeet& feet, GaitState& state,
                                 const GaitPose& start) const noexcept {
  constexpr double most_lag = 0.15;  // [rad]
  const Mat3d level_to_pelvis = rotation_y(-walk_.pitch - feedback_.lean_per_speed * clock.velocity().x);
  GaitPose pose = start;
  MUROSIMF_ASSERT(legs_[0].joints.size() <= most_hinges && legs_[1].joints.size() <= most_hinges);
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs_[side];
    const bool loaded = side == clock.standing() && clock.amplitude() > 0.5;
    const double sag = loaded ? feedback_.sag * std::clamp(state.roll_lag[side], -most_lag, most_lag) : 0;
    const FootTarget target{.ankle = level_to_pelvis * feet.ankle[side],
                            .sole = level_to_pelvis * feet.sole[side],
                            .roll = feet.roll[side] + roll_sign_[side] * sag};
    const auto q = std::span(pose.q[side]).first(leg.joints.size());
    pose.reachable = bend(leg, target, q) && pose.reachable;
    state.roll_target[side] = q[roll_hinge_[side]] - sag;
  }
  return pose;
}

GaitPose BalancedGait::step(double dt, GaitClock& clock, const WalkSenses& senses, GaitState& state,
                            const GaitPose& start, const Intent& intent) const noexcept {
  feel_slope(dt, clock, senses, state);
  find_deviation(clock, state);
  if (!intent.answers) {
    state.deviation = {};
    state.slope = 0;
  }
  watch(dt, clock, state);
  const double rate = phase_rate(state);
  const std::size_t stood = clock.standing();
  MUROSIMF_ASSERT(dt > 0 && walk_.period > 0);
  // The rest of the step at the present rate, but no more than twice the nominal one.
  const double left = (1 - clock.share()) * walk_.period / 2 / std::max(0.5, rate);
  const GaitLimits limits{walk_.period, walk_.slew, intent.stops ? Vec3d{} : walk_.fastest, intent.velocity,
                          state.trim};
  const double width = state.alarm > 0 || !clock.is_idle(limits) ? 0 : stands_wider_;
  clock.advance(dt, limits, rate, state.alarm > 0 || !has_width(state, width));
  follow_command(dt, stood, clock, limits, senses, state);
  move_apart(dt, clock, width, state);
  place_steps(dt, clock, stood, left, state);
  if (clock.standing() != stood) senses.change_foot(clock.standing(), state);
  GaitFeet feet = open_loop(clock, state);
  turn_feet(clock, state, feet);
  return bend_legs(clock, feet, state, start);
}

}  // namespace murosimf::locomotion
