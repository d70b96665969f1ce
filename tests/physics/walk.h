/// walk.h - kid21 walks: what must be watched on the way, the same for every level.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/random.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {

/// Algorithm: pushes the base, at its origin, horizontally and at random.
class Pusher final : public Algorithm {
 public:
  /// `rms` [N] along x and along y.
  Pusher(Setup& setup, double rms) : size_(std::sqrt(3) * rms), push_(setup.write(properties::applied_force)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { std::fill(push_.begin(), push_.end(), Wrenchd{}); }
  void step(const Instant&) noexcept override {
    push_[0].f = {stream_.uniform(2 * count_, -size_, size_), stream_.uniform(2 * count_ + 1, -size_, size_), 0};
    ++count_;
  }

 private:
  double size_;  // [N] of a uniform distribution with that rms
  RandomStream stream_{1, "pushes"};
  std::uint64_t count_ = 0;
  std::span<Wrenchd> push_;
};

/// What walks, where and how.
struct WalkTask {
  Dynamics dynamics;
  Vec3d command;  // [m/s, m/s, rad/s]
  double seconds = 18;
  double friction = 0.8;  // of the ground under the feet
  double slope = 0;       // [rad] uphill in x
  double push = 0;        // [N] rms every 10 ms
  ModelPtr model = kid21();
};

struct Walk {
  Vec3d moved;              // [m] of the base
  double turned = 0;        // [rad] of the base, summed
  double lean = 0;          // [deg] largest lean of the pelvis
  double center_range = 0;  // [m] highest minus lowest base after 2 s
  double slip = 0;          // [m] largest way of a standing sole on the plane between two swaps (kinematic walking)
};

namespace detail {

/// The standing sole of kinematic walking.
class StandingSole {
 public:
  explicit StandingSole(Entity& robot) : robot_(robot), soles_(robot.model().having(properties::sole)) {}

  /// [m] how far it has moved on the plane since the feet swapped roles.
  double slip() {
    const double foot = robot_.base().get(properties::stance_foot);
    const Vec3d sole = robot_.find(properties::position)->values[soles_[static_cast<std::size_t>(foot)]];
    if (foot != foot_) landed_ = sole;
    foot_ = foot;
    return std::hypot(sole.x - landed_.x, sole.y - landed_.y);
  }

 private:
  Entity& robot_;
  std::vector<int> soles_;
  double foot_ = -1;
  Vec3d landed_;
};

}  // namespace detail

inline Walk walk(const WalkTask& task) {
  Rig rig(task.friction, -task.slope);
  rig.materials.set("rubber", "", {.friction = task.friction});
  Entity& robot = rig.add("robot", task.model);
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz, task.command);
  if (task.push > 0) rig.simulation.attach<Pusher>("pusher", robot, 100, task.push);
  rig.attach_motion(robot, task.dynamics);
  rig.simulation.initialize();

  const bool kinematic = task.dynamics.level == "kinematic_walking";
  detail::StandingSole sole(robot);
  Walk result;
  const Vec3d start = Rig::place(robot);
  double direction = heading(robot.base().get(properties::orientation)), low = 1, high = 0;
  for (int i = 0; i < std::lround(1000 * task.seconds); ++i) {
    rig.simulation.step();
    const Mat3d R = robot.base().get(properties::orientation);
    result.turned += std::remainder(heading(R) - direction, 2 * pi);
    direction = heading(R);
    result.lean = std::max(result.lean, std::acos(std::min(1.0, R.z.z)) / degree);
    if (kinematic) result.slip = std::max(result.slip, sole.slip());
    if (i <= 2000) continue;
    low = std::min(low, Rig::place(robot).z);
    high = std::max(high, Rig::place(robot).z);
  }
  result.moved = Rig::place(robot) - start;
  result.center_range = high - low;
  return result;
}

}  // namespace murosimf::test
