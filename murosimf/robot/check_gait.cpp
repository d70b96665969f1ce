#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_checks.h"

namespace murosimf::robot {
namespace {

constexpr int samples = 1000;          // of a cycle
constexpr double least_share = 0.005;  // [1] of the time: less is not reported

/// The rates that a walk needs of a hinge of a leg, compared with those of its servo without load.
struct Demand {
  std::string joint;
  std::size_t side = 0, hinge = 0;  ///< in a GaitPose
  double servo = 0;                 ///< [rad/s] no-load rate at the largest duty
  double fastest = 0;               ///< [rad/s] needed
  double beyond = 0;                ///< [1] share of the time in which more than the servo's rate is needed
};

/// Of the hinges with servos of a known no-load rate.
std::vector<Demand> no_demands(const Model& model, const std::array<locomotion::Leg, 2>& legs) {
  std::vector<Demand> demands;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t hinge = 0; hinge < legs[side].joints.size(); ++hinge) {
      const int object = legs[side].joints[hinge];
      MUROSIMF_ASSERT(object >= 0 && object < model.size());
      const Servo* servo = model.find(properties::servo, object);
      if (!servo || !(servo->no_load_speed > 0)) continue;
      demands.push_back({model.objects()[object].name, side, hinge, servo->duty_limit * servo->no_load_speed});
    }
  }
  return demands;
}

/// Rates are differences of the poses of a cycle of the walk; `velocity` as in gait_pose().
std::vector<Demand> demands_of_walk(const Model& model, const locomotion::WalkParameters& gait, const Vec3d& velocity) {
  MUROSIMF_ASSERT(gait.period > 0);
  const std::array<locomotion::Leg, 2>& legs = locomotion::legs_of(model);
  std::vector<Demand> demands = no_demands(model, legs);
  const auto pose_at = [&](int i, const locomotion::GaitPose& start) {
    return locomotion::gait_pose(legs, gait, 2 * pi * (i % samples) / samples, 1, velocity, start);
    // All poses are of one cycle: differences over its end are rates as well.
  };
  locomotion::GaitPose before = pose_at(0, pose_at(0, locomotion::home_pose(legs)));
  for (int i = 1; i <= samples; ++i) {
    const locomotion::GaitPose pose = pose_at(i, before);
    for (Demand& demand : demands) {
      const double turn = pose.q[demand.side][demand.hinge] - before.q[demand.side][demand.hinge];
      MUROSIMF_ASSERT(demand.side < pose.q.size() && demand.hinge < pose.q[demand.side].size());
      const double rate = std::abs(turn) * samples / gait.period;
      demand.fastest = std::max(demand.fastest, rate);
      if (rate > demand.servo) demand.beyond += 1.0 / samples;
    }
    before = pose;
  }
  return demands;
}

}  // namespace

std::vector<Finding> examine_gait(const robot_formats::RobotDescription& description, const Model& model) {
  if (description.fixed_base) return {};
  std::vector<Demand> demands;
  double speed = 0;  // [m/s]
  try {
    const locomotion::WalkParameters gait = locomotion::seeded_parameters(model);
    speed = gait.fastest.x;
    demands = demands_of_walk(model, gait, {speed, 0, 0});
  } catch (const SetupError&) {
    return {};  // examine_legs reports why it does not walk
  }
  std::erase_if(demands, [](const Demand& demand) { return demand.beyond < least_share; });
  if (demands.empty()) return {};
  std::ranges::stable_sort(demands, std::greater{}, &Demand::beyond);
  const Demand& worst = demands[0];
  std::string also;
  for (std::size_t j = 1; j < demands.size(); ++j) also += (j == 1 ? ", also " : ", ") + demands[j].joint;
  return {{Severity::warning, description.bodies[0].where,
           fmt::format("the walk at {:.2g} m/s asks '{}' for up to {:.1f} rad/s; its servo comes to {:.1f} without "
                       "load, less than that in {:.0f} % of the time{}",
                       speed, worst.joint, worst.fastest, worst.servo, 100 * worst.beyond, also),
           "walk slower, or give it faster servos"}};
}

}  // namespace murosimf::robot
