#include "murosimf/locomotion/gait_limits.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dynamics/rate_limit.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

/// Whether both feet reach every point of a period at this walking velocity.
bool reaches(const std::array<Leg, 2>& legs, const WalkParameters& p, const Vec3d& velocity) {
  constexpr int phases = 100;
  GaitPose pose = home_pose(legs);
  for (int i = 0; i < phases; ++i) {
    pose = gait_pose(legs, p, 2 * pi * i / phases, 1, velocity, pose);
    if (!pose.reachable) return false;
    // Each pose is the start of the next: legs without a closed form converge in few steps along the path.
  }
  return true;
}

/// Whether the legs reach full speed forward while turning at half the fastest rate, back, sideways and turning on the spot.
bool reaches_at_full_speed(const std::array<Leg, 2>& legs, const WalkParameters& p) {
  const auto& [x, y, z] = p.fastest;
  return reaches(legs, p, {x, 0, 0.5 * z}) && reaches(legs, p, {-x, 0, 0}) && reaches(legs, p, {0, y, 0}) &&
         reaches(legs, p, {0, 0, z});
}

/// Reduces the velocities that alone are out of reach, or all of them if each alone is within reach.
void slow_down(const std::array<Leg, 2>& legs, WalkParameters& p) {
  constexpr double slower = 0.8;
  auto& [x, y, z] = p.fastest;
  const bool forward = reaches(legs, p, {x, 0, 0}) && reaches(legs, p, {-x, 0, 0});
  const bool sideways = reaches(legs, p, {0, y, 0}), turning = reaches(legs, p, {0, 0, z});
  const bool alone = forward && sideways && turning;
  if (!forward || alone) x *= slower;
  if (!sideways || alone) y *= slower;
  if (!turning || alone) z *= slower;
}

using Rates = std::array<std::vector<double>, 2>;  // [rad/s] by leg and hinge

Rates largest_rates(const Model& model, const std::array<Leg, 2>& legs) {
  Rates rates;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const int joint : legs[side].joints) {
      rates[side].push_back(dynamics::joint_rate_limit(model, joint));
      MUROSIMF_ASSERT(rates[side].back() > 0);
    }
  }
  return rates;
}

/// The largest rate of a hinge over what it may have, in a period at this walking velocity. [1]
double used_rate(const std::array<Leg, 2>& legs, const Rates& largest, const WalkParameters& p, const Vec3d& velocity) {
  constexpr int phases = 200;
  MUROSIMF_ASSERT(p.period > 0);
  MUROSIMF_ASSERT(largest[0].size() == legs[0].joints.size() && largest[1].size() == legs[1].joints.size());
  double used = 0;
  GaitPose before = gait_pose(legs, p, 0, 1, velocity);
  for (int i = 1; i <= phases; ++i) {
    const GaitPose pose = gait_pose(legs, p, 2 * pi * i / phases, 1, velocity, before);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < largest[side].size(); ++k)
        used = std::max(used, std::abs(pose.q[side][k] - before.q[side][k]) * phases / (p.period * largest[side][k]));
    }
    before = pose;
  }
  return used;
}

double used_rate_at_full_speed(const std::array<Leg, 2>& legs, const Rates& largest, const WalkParameters& p) {
  const auto& [x, y, z] = p.fastest;
  double used = 0;
  for (const Vec3d& velocity : {Vec3d{x, 0, 0.5 * z}, Vec3d{-x, 0, 0}, Vec3d{0, y, 0}, Vec3d{0, 0, z}})
    used = std::max(used, used_rate(legs, largest, p, velocity));
  return used;
}

}  // namespace

void fit_splay(const std::array<Leg, 2>& legs, WalkParameters& p) {
  WalkParameters tried = p;
  tried.splay = 0;
  constexpr int steps = 4;
  for (int i = 0; i <= 2 * steps; ++i) {
    // 0, 1/4, -1/4, 1/2 ... -1
    tried.splay = (i % 2 == 1 ? 1.0 : -1.0) * ((i + 1) / 2) / steps;
    if (!reaches(legs, tried, {0, 0, p.fastest.z})) continue;
    p.splay = tried.splay;
    return;
  }
}

void fit_to_reach(const std::array<Leg, 2>& legs, WalkParameters& p) {
  // Bounded loops: a robot with legs that never reach keeps its parameters, and the simulation starts.
  constexpr double lower = 0.99;
  constexpr int heights = 12, lengths = 12;
  WalkParameters tried = p;
  for (int i = 0; i < lengths; ++i) {
    tried.hip_height = p.hip_height;
    for (int k = 0; k < heights; ++k) {
      if (reaches_at_full_speed(legs, tried)) {
        p = tried;
        return;
      }
      tried.hip_height = legs[0].ankle_height + lower * (tried.hip_height - legs[0].ankle_height);
    }
    tried.hip_height = p.hip_height;
    slow_down(legs, tried);
  }
}

void fit_to_rates(const Model& model, const std::array<Leg, 2>& legs,
                  const std::function<double(const WalkParameters&)>& sway, WalkParameters& p) {
  const Rates largest = largest_rates(model, legs);
  MUROSIMF_ASSERT(p.period > 0 && p.lift >= 0);
  constexpr double share = 0.9, lower = 0.95, longer = 1.02, slower = 0.95;
  constexpr double walking = 0.6;  // [1] of the fastest: the speed that must remain
  const double least_lift = p.lift / 3, most_period = 1.5 * p.period;
  const auto is_too_fast = [&] { return used_rate(legs, largest, p, {walking * p.fastest.x, 0, 0}) > share; };
  while (is_too_fast() && p.lift > least_lift) p.lift *= lower;
  while (is_too_fast() && p.period < most_period) {
    p.period *= longer;
    // The pendulum of a longer period sways farther.
    p.sway = sway(p);
  }
  constexpr int most = 40;
  for (int i = 0; i < most && used_rate_at_full_speed(legs, largest, p) > share; ++i) p.fastest = slower * p.fastest;
}

}  // namespace murosimf::locomotion
