#include "murosimf/locomotion/motion_engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/rate_limit.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/motion_report.h"
#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/locomotion/wide_step.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::locomotion {
namespace {

const double cos_falling = std::cos(35 * pi / 180);
const double cos_upright = std::cos(30 * pi / 180);

bool starts_with_any(std::string_view name, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return name.starts_with(word); });
}

/// The side of the robot that is down, or goes down: up is a unit vector in axes of the base.
std::string_view side_down(const Vec3d& up) noexcept {
  if (std::abs(up.x) >= std::abs(up.y)) return up.x < 0 ? "front" : "back";
  return up.y > 0 ? "right" : "left";
}

double smooth(double s) noexcept { return 0.5 * (1 - std::cos(pi * std::clamp(s, 0.0, 1.0))); }
/// From 0 to 1 along a cosine, at rest at both ends.

}  // namespace

MotionEngineOptions motion_engine_options(const Model& model, const OptionValues& given) {
  MotionEngineOptions options{.walk = balanced_walk(model, given), .feedback = gait_feedback(model, given)};
  options.stance = seeded_parameters(model).half_width;
  if (const StepTablePtr* steps = model.find(properties::given_steps, 0)) options.steps = *steps;
  if (const NamedMotions* motions = model.find(properties::given_motions, 0)) options.motions = *motions;
  return options;
}

MotionEngine::MotionEngine(Setup& setup, const Vec3d& command, const MotionEngineOptions& options)
    : legs_(legs_of(setup.model())),
      gait_(legs_, options.walk, options.feedback, options.stance, options.steps),
      arms_(setup.model(), legs_, options.walk),
      senses_(setup, legs_),
      clock_(setup, command),
      rates_(static_cast<std::size_t>(setup.model().size())),
      rest_(rest_positions(setup.model())),
      next_(rates_.size()),
      own_(setup.entity().find(properties::motion_joints) ? setup.input(properties::motion_joints, 1.0)
                                                          : std::span<const double>{}),
      dynamic_(setup.input(properties::dynamic, 1.0)[0]),
      requests_(setup.input(properties::motion_request, {})[0]),
      kick_request_(setup.input(properties::kick_request, {})[0]),
      gait_state_(setup.write(properties::gait_state)[0]),
      state_(setup.write(properties::motion_state)[0]),
      odometry_(setup.write(properties::odometry)[0]),
      start_(setup.write(properties::motion_start)),
      target_(setup.write(properties::joint_target)) {
  for (const int joint : setup.model().joints()) {
    joints_.push_back(joint);
    MUROSIMF_ASSERT(static_cast<std::size_t>(joint) < rates_.size());
    rates_[joint] = dynamics::fastest_rate(setup.model(), joint);
    MUROSIMF_ASSERT(rates_[joint] > 0);
  }
  if (options.motions.size() > most_motions)
    throw SetupError(fmt::format("a robot has at most {} motions, not {}", most_motions, options.motions.size()));
  for (const NamedMotion& motion : options.motions)
    with_context(motion.name, [&] { add_motion(setup.model(), motion); });
  named_ = motions_.size();
  MUROSIMF_ASSERT(named_ <= most_motions);
  // Wide steps come after the named motions, which have the numbers of the requests.
  for (const std::size_t side : {0, 1}) {
    add_motion(setup.model(), {"wide_step", wide_step(legs_, seeded_parameters(setup.model()), side)});
    for (std::size_t i = 0; i < named_; ++i) {
      if (motions_[i].name == (side == 0 ? "dive_left" : "dive_right"))
        motions_[i].standing = static_cast<int>(motions_.size()) - 1;
    }
  }
}

void MotionEngine::add_motion(const Model& model, const NamedMotion& named) {
  const auto& [name, motion] = named;
  const int number = static_cast<int>(motions_.size());
  const bool lies = starts_with_any(name, {"dive", "protect", "get_up", "lie_down"});
  motions_.push_back({name, motion, duration(motion), KeyframeTargets(model, motion), motion.start,
                      name.starts_with("dive"), lies, name.starts_with("lie_down"), lies ? -1 : number});
  if (motion.kick) kicks_.push_back({number, *motion.kick});
}

void MotionEngine::initialize() {
  std::ranges::copy(rest_, target_.begin());
  std::ranges::fill(start_, 0.0);
  clock_.initialize();
  senses_.initialize(clock_.standing(), gait_state_);
  gait_.stand(gait_state_);
  state_ = {};
  write_walk(gait_.stance());
  std::ranges::copy(next_, target_.begin());
}

void MotionEngine::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  // Order: sensors first, then requests and modes by what they report, then targets of the chosen mode.
  gait_.feel(dt, clock_, target_, senses_, gait_state_);
  if (!has_legs()) return stand_aside();
  read_requests();
  choose(dt);
  state_.time += dt;
  if (mode() == MotionMode::walk) {
    walk(dt);
  } else {
    play();
  }
  limit_rates(dt);
}

bool MotionEngine::has_legs() const noexcept {
  const auto whole = [&](const Leg& leg) {
    return std::ranges::all_of(leg.joints, [&](int joint) { return has(joint); });
  };
  return std::ranges::all_of(legs_, whole);
}

/// Every cycle without legs could be the last one: the walk begins again from the present targets, and requests are over.
void MotionEngine::stand_aside() noexcept {
  for (std::size_t i = 0; i < named_; ++i) state_.seen.number[i] = requests_.number[i];
  state_.kick_seen = kick_request_.number;
  begin(MotionMode::walk, -1);
}

void MotionEngine::read_requests() noexcept {
  MUROSIMF_ASSERT(named_ <= requests_.number.size());
  for (std::size_t i = 0; i < named_; ++i) {
    const double number = requests_.number[i];
    // A request is a change of its number: a number that stays does not start the motion again.
    if (std::exchange(state_.seen.number[i], number) == number || number == 0) continue;
    request_motion(static_cast<int>(i));
  }
  if (std::exchange(state_.kick_seen, kick_request_.number) != kick_request_.number) request_kick();
}

/// A request waits in `motion` until the robot has stopped. Where it falls or plays already, it is over.
void MotionEngine::request_motion(int motion) noexcept {
  if (rests() && motions_[motion].name.starts_with("get_up")) return begin(MotionMode::lie, -1);
  if (mode() != MotionMode::walk || (!can_fall() && motions_[motion].standing < 0)) return;
  if (motions_[motion].lies && !motions_[motion].rests) return begin(MotionMode::play, motion);
  state_.motion = motion;
  state_.kick = -1;
}

/// Starts the walk to a kick: another request, also for a new place of the ball, replaces the present one.
void MotionEngine::request_kick() noexcept {
  state_.kick = -1;
  if (mode() != MotionMode::walk || kick_request_.number == 0 || state_.motion >= 0) return;
  const std::optional<KickPlan> plan = plan_kick(kicks_, kick_request_, gait_.fastest());
  if (!plan) return;
  const Vec3d ball{kick_request_.ball_x, kick_request_.ball_y, 0};
  MUROSIMF_ASSERT(motions_[plan->motion].motion.kick.has_value());
  state_.kick = plan->motion;
  state_.approach = 0;
  state_.place = odometry_;
  state_.goal = from_there(odometry_, plan->place);
  state_.ball = from_there(odometry_, ball);
  constexpr double share = 0.95;  // [1] of where the motion has the ball
  state_.clearance = is_zero(ball) ? 0 : share * norm(motions_[plan->motion].motion.kick->ball);
}

/// Walks to where it kicks; from there it plays the motion like one that was requested.
void MotionEngine::approach(double dt) noexcept {
  constexpr double longest = 15, smooths = 0.25;    // [s]
  constexpr double near = 1.0 / 16, turned = 0.05;  // [1] of the leg, [rad]
  const Vec3d way = seen_from(state_.place, odometry_);
  // The odometry sways with the steps: its mean decides on the arrival.
  state_.place += (dt / (smooths + dt)) * Vec3d{odometry_.x - state_.place.x, odometry_.y - state_.place.y, way.z};
  state_.approach += dt;
  if (state_.approach > longest) state_.kick = -1;
  const Vec3d goal = seen_from(state_.place, state_.goal);
  if (std::hypot(goal.x, goal.y) > near * (legs_[0].thigh + legs_[0].shin) || std::abs(goal.z) > turned) return;
  MUROSIMF_ASSERT(static_cast<std::size_t>(state_.kick + 1) <= motions_.size());
  state_.motion = std::exchange(state_.kick, -1);
}

void MotionEngine::choose(double dt) noexcept {
  const double up = gait_state_.attitude.up.z;
  const bool plays = mode() != MotionMode::walk && state_.motion >= 0;
  const bool means_to_lie = plays && played().lies;
  const bool over = plays && state_.time > state_.blend + state_.duration;
  // kinematic_walking was switched on while the robot fell or lay: the level has put it upright.
  if (!can_fall() && mode() != MotionMode::walk && mode() != MotionMode::play) return begin(MotionMode::walk, -1);
  switch (mode()) {
    case MotionMode::walk:
    case MotionMode::play:
      if (means_to_lie && !over) return;
      if (rests()) {
        if (!clock_.is_idle({.fastest = gait_.fastest()})) begin(MotionMode::lie, -1);
        return;
      }
      if (can_fall() && up < cos_fallen) return lie_down();
      if (can_fall() && up < cos_falling && !means_to_lie) return begin(MotionMode::protect, find_motion("protect_"));
      if (over) return begin(MotionMode::walk, -1);
      if (mode() == MotionMode::walk && state_.motion >= 0 && clock_.amplitude() == 0 && state_.time > state_.blend)
        return begin(MotionMode::play, static_cast<int>(state_.motion));
      return;
    case MotionMode::protect:
      if (up < cos_fallen && (over || state_.motion < 0)) return lie_down();
      if (up > cos_upright && (over || state_.motion < 0)) return begin(MotionMode::walk, -1);
      return;
    case MotionMode::lie: {
      constexpr double waits = 0.4, patience = 3;  // [s]
      state_.quiet = gait_state_.still > 0 ? state_.quiet + dt : 0;
      if (up > cos_upright) return begin(MotionMode::walk, -1);
      if (state_.quiet < waits && state_.time < patience) return;
      if (const int motion = find_motion("get_up_"); motion >= 0) begin(MotionMode::get_up, motion);
      return;
    }
    case MotionMode::get_up:
      if (over) return up > cos_upright ? begin(MotionMode::walk, -1) : lie_down();
  }
}

/// It has lain down because it was asked to.
bool MotionEngine::rests() const noexcept {
  if (mode() != MotionMode::play || state_.motion < 0 || !motions_[static_cast<int>(state_.motion)].rests) return false;
  return state_.time > state_.blend + state_.duration && gait_state_.attitude.up.z < cos_fallen;
}

void MotionEngine::lie_down() noexcept {
  const bool dives = mode() == MotionMode::play && state_.motion >= 0 && played().dives;
  if (mode() != MotionMode::get_up && !dives) state_.falls += 1;
  // A dive and a fall while getting up are no new falls.
  begin(MotionMode::lie, -1);
}

/// Enters a mode, from the present joint targets.
void MotionEngine::begin(MotionMode mode, int motion) noexcept {
  MUROSIMF_ASSERT(motion >= -1 && motion < static_cast<int>(motions_.size()));
  state_.mode = static_cast<double>(mode);
  state_.motion = motion;
  state_.kick = -1;
  state_.time = state_.quiet = state_.duration = 0;
  std::ranges::copy(target_, start_.begin());
  clock_.initialize();
  gait_state_.offset = {};
  gait_state_.settled = gait_state_.alarm = 0;
  if (mode != MotionMode::walk && mode != MotionMode::play) gait_state_.slope = 0;
  if (mode == MotionMode::walk) {
    gait_.stand(gait_state_);
    write_walk(gait_.stance());
  } else if (motion >= 0) {
    state_.duration = played().duration;
    write_motion(played(), 0);
  } else {
    std::ranges::copy(target_, next_.begin());
  }
  state_.blend = blend_time();
}

/// [s] for the slowest joint from `start_` to `next_`, along a cosine.
double MotionEngine::blend_time() const noexcept {
  MUROSIMF_ASSERT(start_.size() == next_.size());
  constexpr double peak = pi / 2, at_least = 0.05;  // [1] largest rate of a cosine over its mean; [s]
  double time = at_least;
  for (const int joint : joints_) time = std::max(time, peak * std::abs(next_[joint] - start_[joint]) / rates_[joint]);
  return time;
}

void MotionEngine::walk(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  if (state_.time < state_.blend) {
    write_walk(gait_.stance());
    return blend_from_start();
  }
  std::optional<Vec3d> velocity;
  if (state_.kick >= 0) {
    approach(dt);
    velocity = velocity_to_kick(seen_from(state_.place, state_.goal), seen_from(state_.place, state_.ball),
                                state_.clearance, gait_.fastest());
  }
  const bool waits = state_.motion >= 0;
  write_walk(gait_.step(dt, clock_, senses_, gait_state_, pose_among(legs_, target_),
                        {.stops = waits, .answers = can_fall(), .velocity = velocity}));
  arms_.write(clock_.phase(), clock_.amplitude(), clock_.velocity().x, next_);
}

void MotionEngine::play() noexcept {
  if (state_.motion < 0) {  // lies, or falls without a motion for it: targets stay
    std::ranges::copy(target_, next_.begin());
    return;
  }
  write_motion(played(), state_.time - state_.blend);
  if (state_.time < state_.blend) blend_from_start();
}

/// Blends from the targets at the start of the mode to those in `next_`.
void MotionEngine::blend_from_start() noexcept {
  MUROSIMF_ASSERT(state_.blend > 0);
  const double share = smooth(state_.time / state_.blend);
  for (const int joint : joints_) next_[joint] = start_[joint] + share * (next_[joint] - start_[joint]);
}

void MotionEngine::write_motion(PlayedMotion& played, double time) noexcept {
  MUROSIMF_ASSERT(played.values.size() == played.motion.columns.size());
  sample(played.motion, time, played.values);
  played.targets.write(played.values, next_);
}

void MotionEngine::write_walk(const GaitPose& pose) noexcept {
  std::ranges::copy(rest_, next_.begin());
  write_pose(legs_, pose, next_);
}

void MotionEngine::limit_rates(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && next_.size() == target_.size());
  for (const int joint : joints_) {
    if (!has(joint)) continue;
    const double most = rates_[joint] * dt;
    target_[joint] += std::clamp(next_[joint] - target_[joint], -most, most);
  }
}

/// The motion that is played at the present level: itself, or what replaces it for a robot that cannot fall.
MotionEngine::PlayedMotion& MotionEngine::played() noexcept {
  MUROSIMF_ASSERT(static_cast<std::size_t>(state_.motion) < motions_.size());
  PlayedMotion& motion = motions_[static_cast<int>(state_.motion)];
  return can_fall() || motion.standing < 0 ? motion : motions_[motion.standing];
}

int MotionEngine::find_motion(std::string_view kind) const noexcept {
  const std::string_view side = side_down(gait_state_.attitude.up);
  for (std::size_t i = 0; i < named_; ++i) {
    const std::string_view name = motions_[i].name;
    if (name.size() == kind.size() + side.size() && name.starts_with(kind) && name.ends_with(side))
      return static_cast<int>(i);
  }
  return -1;
}

}  // namespace murosimf::locomotion
