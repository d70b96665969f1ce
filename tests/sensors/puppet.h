/// puppet.h - a body that moves as a function of time says: the truth for tests of sensors.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "murosimf/model/properties.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::test {

/// Of a body, world frame.
struct BodyMotion {
  Vec3d position;          // [m]
  Mat3d orientation;       // body axes to world axes
  Vec3d velocity;          // [m/s] of the origin
  Vec3d angular_velocity;  // [rad/s]
};

using MotionOfTime = std::function<BodyMotion(double)>;

/// Moves a model that is all of one link; rows of others stay at the world's origin.
class Puppet final : public Algorithm {
 public:
  Puppet(Setup& setup, MotionOfTime motion)
      : motion_(std::move(motion)),
        r_(setup.write(properties::position)),
        v_(setup.write(properties::linear_velocity)),
        w_(setup.write(properties::angular_velocity)),
        R_(setup.write(properties::orientation)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void initialize() override {
    std::ranges::fill(r_, Vec3d{});
    std::ranges::fill(v_, Vec3d{});
    std::ranges::fill(w_, Vec3d{});
    std::ranges::fill(R_, Mat3d{});
    show(0);
  }
  void step(const Instant& instant) noexcept override { show(seconds(instant.now + instant.period)); }

 private:
  void show(double t) {
    const BodyMotion m = motion_(t);
    r_[0] = m.position;
    R_[0] = m.orientation;
    v_[0] = m.velocity;
    w_[0] = m.angular_velocity;
  }
  MotionOfTime motion_;
  std::span<Vec3d> r_, v_, w_;
  std::span<Mat3d> R_;
};

/// A body with one sensor, in a world of its own.
template <class S>
struct SensorRig {
  SensorRig(MotionOfTime motion, const sensors::SensorSpec& spec, double step_rate = 1000, std::uint64_t seed = 1)
      : body(simulation.world().add("body", model())),
        sensor(simulation.attach<S>("sensor", body, step_rate, spec, sensors::SensorSurroundings{.seed = seed})) {
    simulation.attach<Puppet>("puppet", body, step_rate, std::move(motion));
  }
  static ModelPtr model() {
    static const auto box = std::make_shared<const Model>(
        "box", Chain{}.base("box").with(properties::mass, 1.0).translation({0.1, 0.2, 0.3}, "corner"));
    return box;
  }
  /// Until the sample of this instant [s] has been taken.
  void run_until(double time) {
    simulation.run(from_seconds(time) - simulation.now());
    simulation.step();
  }
  [[nodiscard]] const sensors::Reading& reading() const { return sensor.reading(); }

  Simulation simulation;
  Entity& body;
  S& sensor;
};

/// Nothing moves.
inline BodyMotion at_rest(double) { return {}; }

}  // namespace murosimf::test
