#include "murosimf/locomotion/kick_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::locomotion {
namespace {

double wrapped(double angle) noexcept { return std::remainder(angle, 2 * pi); }

Vec3d turned(const Vec3d& v, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, 0};
}

double cost_of(const Vec3d& place, const Kick& kick, const Vec3d& fastest) noexcept {
  constexpr double sideways = 2;  // [1]
  const double time = std::hypot(place.x / fastest.x, place.y / fastest.y) + std::abs(place.z) / fastest.z;
  return time * (1 + sideways * std::abs(std::sin(kick.direction)));
}

}  // namespace

std::optional<KickPlan> plan_kick(const std::vector<KickChoice>& kicks, const KickRequest& request,
                                  const Vec3d& fastest) noexcept {
  std::optional<KickPlan> best;
  double least = std::numeric_limits<double>::infinity();
  const bool knows_ball = request.ball_x != 0 || request.ball_y != 0;
  for (const auto& [motion, kick] : kicks) {
    if (request.side * kick.ball.y < 0) continue;
    Vec3d place;
    const double heading = wrapped(request.direction - kick.direction);
    if (knows_ball) place = Vec3d{request.ball_x, request.ball_y, 0} - turned(kick.ball, heading);
    place.z = heading;
    // A strict comparison: of equal costs the first motion in the list wins, on every machine.
    if (const double cost = cost_of(place, kick, fastest); cost < least) {
      least = cost;
      best = KickPlan{motion, place};
    }
  }
  return best;
}

Vec3d seen_from(const Vec3d& place, const Vec3d& goal) noexcept {
  Vec3d seen = turned({goal.x - place.x, goal.y - place.y, 0}, -place.z);
  seen.z = wrapped(goal.z - place.z);
  return seen;
}

Vec3d from_there(const Vec3d& place, const Vec3d& goal) noexcept {
  Vec3d there = turned(goal, place.z);
  return {place.x + there.x, place.y + there.y, place.z + goal.z};
}

Vec3d velocity_to_kick(const Vec3d& goal, const Vec3d& ball, double clearance, const Vec3d& fastest) noexcept {
  MUROSIMF_ASSERT(clearance >= 0);
  constexpr double gain = 1.5, share = 0.5;  // [1/s], [1] of the fastest walk
  Vec3d way{goal.x, goal.y, 0};
  if (clearance > 0) {
    // Polar decomposition about the ball: the component towards it stops at the clearance, and its surplus goes around.
    const double distance = std::max(std::hypot(ball.x, ball.y), 1e-9);
    const Vec3d toward{ball.x / distance, ball.y / distance, 0}, aside{-toward.y, toward.x, 0};
    const double ahead = dot(way, toward), left = dot(way, aside), nearest = std::min(ahead, distance - clearance);
    const double round = ahead > distance ? std::copysign(ahead - nearest, left) : 0;
    way = nearest * toward + (left + round) * aside;
  }
  const double over = gain / share * std::max(std::abs(way.x) / fastest.x, std::abs(way.y) / fastest.y);
  Vec3d velocity = gain / std::max(1.0, over) * way;  // slower, in the same direction
  velocity.z = std::clamp(gain * goal.z, -share * fastest.z, share * fastest.z);
  return velocity;
}

}  // namespace murosimf::locomotion
