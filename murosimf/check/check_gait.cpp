#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "murosimf/check/robot_checks.h"
#include "murosimf/locomotion/gait.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::check {
namespace {

constexpr int samples = 1000;           // of a cycle
constexpr double worth_a_word = 0.005;  // [1] of the time

/// How a joint of a leg is asked to move in a walk, against what its servo can do without any load.
struct Demand {
  std::string joint;
  double fastest = 0;  ///< [rad/s] that it is asked for
  double servo = 0;    ///< [rad/s] the servo's no-load rate at its largest duty
  double beyond = 0;   ///< [1] share of the time in which it is asked for more
};

std::vector<Demand> joints_with_motors(const Model& model, const std::array<locomotion::Leg, 2>& legs,
                                       std::vector<std::pair<std::size_t, std::size_t>>& places) {
  std::vector<Demand> demands;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < legs[side].joints.size(); ++k) {
      const int object = legs[side].joints[k];
      const Servo* servo = model.find(properties::servo, object);
      if (!servo || !(servo->no_load_speed > 0)) continue;
      demands.push_back({.joint = model.objects()[object].name, .servo = servo->duty_limit * servo->no_load_speed});
      places.emplace_back(side, k);
    }
  }
  return demands;
}

std::vector<Demand> demands_of_walk(const Model& model, const locomotion::WalkParameters& gait, const Vec3d& velocity) {
  const std::array<locomotion::Leg, 2>& legs = locomotion::legs_of(model);
  std::vector<std::pair<std::size_t, std::size_t>> places;
  std::vector<Demand> demands = joints_with_motors(model, legs, places);
  const auto pose_at = [&](int i, const locomotion::GaitPose& start) {
    return locomotion::gait_pose(legs, gait, 2 * pi * (i % samples) / samples, 1, velocity, start);
  };
  locomotion::GaitPose before = pose_at(0, pose_at(0, locomotion::home_pose(legs)));
  for (int i = 1; i <= samples; ++i) {
    const locomotion::GaitPose pose = pose_at(i, before);
    for (std::size_t j = 0; j < demands.size(); ++j) {
      const auto [side, k] = places[j];
      const double rate = std::abs(pose.q[side][k] - before.q[side][k]) * samples / gait.period;
      demands[j].fastest = std::max(demands[j].fastest, rate);
      if (rate > demands[j].servo) demands[j].beyond += 1.0 / samples;
    }
    before = pose;
  }
  return demands;
}

}  // namespace

std::vector<Finding> examine_gait(const description::RobotDescription& description, const Model& model) {
  std::vector<Demand> demands;
  double speed = 0;  // [m/s]
  try {
    const locomotion::WalkParameters gait = locomotion::seeded_parameters(model);
    speed = gait.fastest.x;
    demands = demands_of_walk(model, gait, {speed, 0, 0});
  } catch (const SetupError&) {
    return {};  // examine_legs says why it does not walk
  }
  std::erase_if(demands, [](const Demand& demand) { return demand.beyond < worth_a_word; });
  if (demands.empty()) return {};
  std::ranges::stable_sort(demands, std::greater{}, &Demand::beyond);
  const Demand& worst = demands[0];
  std::string also;
  for (std::size_t j = 1; j < demands.size(); ++j) also += (j == 1 ? ", also " : ", ") + demands[j].joint;
  return {{Severity::warning, description.bodies[0].where,
           fmt::format("the walk at {:.2g} m/s asks '{}' for up to {:.1f} rad/s; its servo comes to {:.1f} without "
                       "load, less than that "
                       "in {:.0f} % of the time{}",
                       speed, worst.joint, worst.fastest, worst.servo, 100 * worst.beyond, also),
           "walk slower, or give it faster servos"}};
}

}  // namespace murosimf::check
