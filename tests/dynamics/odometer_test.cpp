// Ways and falls as the odometer counts them, of a body that moves as the test says.
#include "murosimf/dynamics/odometer.h"

#include <gtest/gtest.h>

#include <functional>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/runtime/simulation.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using test::degree;

struct Transformd {
  Vec3d r;
  Mat3d R;
};

/// Puts the base where the function of time [s] says.
class Carrier final : public Algorithm {
 public:
  Carrier(Setup& setup, std::function<Transformd(double)> path)
      : path_(std::move(path)), r_(setup.write(properties::position)), R_(setup.write(properties::orientation)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void initialize() override { show(0); }
  void step(const Instant& instant) noexcept override { show(seconds(instant.now + instant.period)); }

 private:
  void show(double t) {
    r_[0] = path_(t).r;
    R_[0] = path_(t).R;
  }
  std::function<Transformd(double)> path_;
  std::span<Vec3d> r_;
  std::span<Mat3d> R_;
};

struct Carried {
  explicit Carried(const std::function<Transformd(double)>& path, bool joints = true) {
    Chain chain = Chain{}.base("base").with(properties::mass, 1.0);
    if (joints) chain.revolute("joint", {0, 1, 0});
    robot = &simulation.world().add("robot", std::make_shared<const Model>("robot", chain));
    simulation.attach<Carrier>("carrier", *robot, 100, path);
    simulation.attach<Odometer>("odometer", *robot, Odometer::rate_hz);
  }
  void run_until(double t) { simulation.run(from_seconds(t) - simulation.now()); }
  [[nodiscard]] double way() { return robot->base().get(properties::distance_walked); }
  [[nodiscard]] double falls() { return robot->base().get(properties::falls); }
  [[nodiscard]] bool lies() { return robot->base().get(properties::lying) != 0; }

  Simulation simulation;
  Entity* robot = nullptr;
};

// Until an odometer's first step its columns hold no numbers; then what is counted reaches to where the base is, between samples too.
TEST(Odometer, CountsFromNothingToWhereTheBaseIs) {
  Carried robot([](double t) { return Transformd{{0.3 * t, 0, 1}, Mat3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; });
  EXPECT_EQ(way_and_falls(*robot.robot).walked, 0);
  EXPECT_EQ(way_and_falls(*robot.robot).falls, 0);
  robot.run_until(1.25);
  EXPECT_NEAR(way_and_falls(*robot.robot).walked, 0.3 * 1.25, 1e-12);
  EXPECT_LT(robot.way(), 0.3 * 1.25 - 0.01) << "the samples alone";
}

// A walk along (0.3, -0.4) m/s that also climbs and sways at 4 Hz: neither is way; samples are half a second apart.
TEST(Odometer, WayIsHorizontalAndSwayingDoesNotCount) {
  Carried robot([](double t) {
    const double sway = 0.05 * std::sin(8 * pi * t);
    return Transformd{{5 + 0.3 * t + 0.8 * sway, 2 - 0.4 * t + 0.6 * sway, 1 + 2 * t}, {}};
  });
  robot.run_until(4.2);
  EXPECT_NEAR(robot.way(), 0.5 * 4, 0.02);
  robot.run_until(6.2);
  EXPECT_NEAR(robot.way(), 0.5 * 6, 0.02);
}

TEST(Odometer, WayOfACurveIsThatOfItsChords) {
  Carried robot([](double t) { return Transformd{{2 * std::cos(t), 2 * std::sin(t), 0}, {}}; });
  robot.run_until(10.2);
  // a chord of half a second of a circle of 2 m; the instant of a sample may be one step of 100 Hz off
  EXPECT_NEAR(robot.way(), 20 * 2 * 2 * std::sin(0.25), 0.05);
}

/// [degree] lean about a slanted axis, ten seconds for each.
Carried leaning(const std::vector<double>& degrees, const Mat3d& start = {}, bool joints = true) {
  return Carried(
      [=](double t) {
        const auto i = std::min(static_cast<std::size_t>(t), degrees.size() - 1);
        const Vec3d axis{0.6, 0.8, 0};
        return Transformd{{}, to_matrix(exponential(degrees[i] * degree * axis)) * start};
      },
      joints);
}

// Rule: down at 60 degrees, up again at 30; in between nothing changes.
TEST(Odometer, FallsAreCountedAtSixtyDegreesAndAgainAfterThirty) {
  Carried robot = leaning({0, 58, 62, 32, 62, 150, 28, 58, 62, 0});
  const std::vector<std::pair<int, bool>> expected{{0, false}, {0, false}, {1, true},  {1, true}, {1, true},
                                                   {1, true},  {1, false}, {1, false}, {2, true}, {2, false}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    robot.run_until(static_cast<double>(i) + 0.9);
    EXPECT_EQ(robot.falls(), expected[i].first) << i;
    EXPECT_EQ(robot.lies(), expected[i].second) << i;
  }
}

TEST(Odometer, UprightIsTheAttitudeAtTheStart) {
  const Mat3d odd = rotation_x(80 * degree) * rotation_z(0.7);
  Carried robot = leaning({0, 50, 70}, odd);
  robot.run_until(1.9);
  const Vec3d up = robot.robot->base().get(properties::up_at_start);
  EXPECT_LT(norm(odd * up - Vec3d{0, 0, 1}), 1e-12) << "remembered in a column";
  EXPECT_EQ(robot.falls(), 0);
  robot.run_until(2.9);
  EXPECT_EQ(robot.falls(), 1);
}

TEST(Odometer, ThingsWithoutJointsRollAndDoNotFall) {
  Carried ball = leaning({0, 90, 180}, {}, false);
  ball.run_until(2.9);
  EXPECT_EQ(ball.falls(), 0);
  EXPECT_FALSE(ball.lies());
}

}  // namespace
}  // namespace murosimf::dynamics
