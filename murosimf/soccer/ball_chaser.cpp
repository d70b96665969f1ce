#include "murosimf/soccer/ball_chaser.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/soccer/planar.h"

namespace murosimf::soccer {

using sensors::Sighting;

/// The situation of a player on the ground plane.
struct Situation {
  const Sighting* self = nullptr;
  const Sighting* ball = nullptr;
  int rank = 0;                                          ///< number of robots of the team that are nearer to the ball
  Vec3d to_goal;                                         ///< unit, from the ball to the goal
  Vec3d avoidance;                                       ///< direction away from robots that are too near
  Vec3d toward;                                          ///< unit, to the nearest of these
  double gap = std::numeric_limits<double>::infinity();  ///< to it
};

namespace {

// All lengths in meters, on the ground plane.
constexpr double in_front = 0.30;     // the ball is at the feet
constexpr double beside_feet = 0.09;  // ... and not beside them
constexpr double arrived = 0.10;
constexpr double closest = 0.40;  // to another robot, for those that support

Vec3d flat(const Vec3d& v) { return {v.x, v.y, 0}; }
Vec3d left_of(const Vec3d& v) { return {-v.y, v.x, 0}; }
Vec3d unit(const Vec3d& v) {
  const double length = norm(v);
  return length > 1e-9 ? (1.0 / length) * v : Vec3d{1, 0, 0};
}

Situation assess(const std::vector<Sighting>& sightings, const BallChaserOptions& options) {
  MUROSIMF_ASSERT(options.keep_clear > 0);
  Situation s;
  for (const Sighting& sighting : sightings) {
    if (!sighting.present) continue;
    if (sighting.self) s.self = &sighting;
    if (sighting.name == options.ball) s.ball = &sighting;
  }
  if (!s.self || !s.ball) return s;
  s.to_goal = unit(flat(options.goal - s.ball->position));
  const double own = norm(flat(s.ball->position - s.self->position));
  for (const Sighting& other : sightings) {
    if (!other.present || &other == s.self || &other == s.ball || other.team.empty()) continue;
    const double theirs = norm(flat(s.ball->position - other.position));
    // Equal distances are decided by the names, so that exactly one robot of a team has rank 0.
    if (other.team == s.self->team && (theirs < own || (theirs == own && other.name < s.self->name))) ++s.rank;
    const Vec3d away = flat(s.self->position - other.position);
    const double gap = norm(away);
    if (gap < options.keep_clear) s.avoidance += (1 - gap / options.keep_clear) * unit(away);
    if (gap < s.gap) {
      s.gap = gap;
      s.toward = -unit(away);
    }
  }
  return s;
  MUROSIMF_ASSERT(s.rank >= 0);
}

Vec3d to_robot_frame(const Vec3d& v, double heading) {
  return {std::cos(heading) * v.x + std::sin(heading) * v.y, -std::sin(heading) * v.x + std::cos(heading) * v.y, 0};
}

/// Walks to `place`; far away along the line of sight, nearby sideways too, turning to `facing`.
Vec3d walk_to(const Situation& s, const Vec3d& place, const Vec3d& facing, double speed) {
  MUROSIMF_ASSERT(s.self != nullptr && speed >= 0);
  const Vec3d way = to_robot_frame(flat(place - s.self->position), s.self->heading);
  const double distance = norm(way);
  const double bearing = std::atan2(way.y, way.x);
  const double facing_error = wrapped(std::atan2(facing.y, facing.x) - s.self->heading);
  if (distance > 0.35) {
    const double ahead = std::max(0.0, std::cos(bearing));
    return {speed * ahead * ahead, 0, std::clamp(1.5 * bearing, -0.7, 0.7)};
  }
  return {std::clamp(1.2 * way.x, -0.1, speed), std::clamp(1.2 * way.y, -0.06, 0.06),
          std::clamp(1.5 * facing_error, -0.6, 0.6)};
}

Vec3d attack(const Situation& s, const BallChaserOptions& options) {
  MUROSIMF_ASSERT(s.self != nullptr && s.ball != nullptr);
  const Vec3d ball = flat(s.ball->position);
  const Vec3d seen = to_robot_frame(ball - flat(s.self->position), s.self->heading);
  const double aim_error = wrapped(std::atan2(s.to_goal.y, s.to_goal.x) - s.self->heading);
  if (seen.x > 0 && seen.x < in_front && std::abs(seen.y) < beside_feet && std::abs(aim_error) < 0.5) {
    return {options.speed, std::clamp(1.0 * seen.y, -0.04, 0.04), std::clamp(1.2 * aim_error, -0.4, 0.4)};
  }
  const Vec3d from_ball = flat(s.self->position) - ball;
  if (dot(from_ball, s.to_goal) > -0.05) {
    // in front of the ball: around it, on the side where the robot is
    const Vec3d side = dot(from_ball, left_of(s.to_goal)) >= 0 ? left_of(s.to_goal) : -left_of(s.to_goal);
    return walk_to(s, ball + options.detour * side - options.behind_ball * s.to_goal, s.to_goal, options.speed);
  }
  return walk_to(s, ball - options.behind_ball * s.to_goal, s.to_goal, options.speed);
}

Vec3d support(const Situation& s, const BallChaserOptions& options) {
  MUROSIMF_ASSERT(s.self != nullptr && s.ball != nullptr && s.rank > 0);
  const double side = s.rank % 2 == 1 ? 1 : -1;
  // Odd and even ranks wait on different sides of the ball.
  const Vec3d ball = flat(s.ball->position);
  Vec3d place = ball - options.support_behind * s.to_goal + (side * options.support_aside) * left_of(s.to_goal);
  const Vec3d& half_field = options.half_field;
  place.x = std::clamp(place.x, -half_field.x, half_field.x);
  place.y = std::clamp(place.y, -half_field.y, half_field.y);
  const Vec3d to_ball = unit(ball - flat(s.self->position));
  const double facing_error = wrapped(std::atan2(to_ball.y, to_ball.x) - s.self->heading);
  if (norm(flat(place - s.self->position)) < arrived && std::abs(facing_error) < 0.2) return {};
  return walk_to(s, place, to_ball, options.speed);
}

/// Removes the part of a supporter's velocity that pushes others: the robots would step on each other's feet.
Vec3d without_pushing(const Vec3d& command, const Situation& s) {
  if (s.rank == 0 || s.gap > closest) return command;
  const Vec3d toward = to_robot_frame(s.toward, s.self->heading);
  const double approach = command.x * toward.x + command.y * toward.y;
  return approach > 0 ? command - approach * toward : command;
}

}  // namespace

BallChaser::BallChaser(Setup& setup, const BallChaserOptions& options)
    : options_(options), seen_(setup), command_(setup.write(properties::walk_command)[0]) {
  if (!options.kicks) return;
  const locomotion::NamedMotions* motions = setup.model().find(properties::given_motions, 0);
  if (!motions || !locomotion::has_kick(*motions))
    throw SetupError("'kicks': no motion of the robot's file says where it kicks a ball (key 'kick', docs/motions.md)");
  kick_ = &setup.write(properties::kick_request)[0];
}

void BallChaser::initialize() {
  command_ = {};
  if (kick_) *kick_ = {};
}

/// Walks to the ball and requests a kick there, which the motion engine executes. Requests are repeated with the ball's present place.
Vec3d BallChaser::attack_with_kicks(const Situation& s, const Instant& instant) noexcept {
  MUROSIMF_ASSERT(kick_ != nullptr && s.self != nullptr && s.ball != nullptr);
  constexpr double near = 0.45, slow = 0.05;  // [m], [m/s]
  constexpr Duration again = std::chrono::milliseconds(500);
  const Vec3d ball = flat(s.ball->position);
  const Vec3d seen = to_robot_frame(ball - flat(s.self->position), s.self->heading);
  if (norm(seen) > near || norm(flat(s.ball->velocity)) > slow) {
    kick_->number = 0;  // a moving ball would have left the place that the kick is planned for
    return norm(seen) > near ? walk_to(s, ball, unit(ball - flat(s.self->position)), options_.speed) : Vec3d{};
  }
  if (kick_->number != 0 && instant.now % again >= instant.period) return {};
  const Vec3d goal = to_robot_frame(s.to_goal, s.self->heading);
  *kick_ = {.number = kick_->number + 1, .direction = std::atan2(goal.y, goal.x), .ball_x = seen.x, .ball_y = seen.y};
  return {};
}

void BallChaser::step(const Instant& instant) noexcept {
  const Situation s = assess(seen_.look(), options_);
  if (kick_ && (!s.self || !s.ball || s.rank != 0)) kick_->number = 0;
  if (!s.self || !s.ball) {
    command_ = {};
    return;
  }
  command_ = s.rank != 0 ? support(s, options_) : kick_ ? attack_with_kicks(s, instant) : attack(s, options_);
  const Vec3d avoid = to_robot_frame(s.avoidance, s.self->heading);
  command_ = without_pushing(command_, s) + Vec3d{0.15 * avoid.x, 0.10 * avoid.y, 0};
}

}  // namespace murosimf::soccer
