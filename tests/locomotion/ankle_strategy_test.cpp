// Balance from sensors alone: pushes that are withstood, the accuracy of the known vertical, and standing without a push.
#include "murosimf/locomotion/ankle_strategy.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/reading.h"
#include "tests/law.h"

namespace murosimf::locomotion {
namespace {

using namespace std::chrono_literals;

constexpr const char* uncalibrated = "robot.sensors.imu.gyroscope.bias=0.116";  // [rad/s] as the MPU-6050 comes

scene::SceneOptions options(const std::string& controller, std::uint64_t seed, std::vector<std::string> more = {}) {
  more.insert(more.end(), {"events=[]", "robot.controller=" + controller});
  return {.seed = seed, .overrides = std::move(more)};
}

Vec3d up_of(Entity& robot) { return transpose(robot.object("torso").get(properties::orientation)) * Vec3d{0, 0, 1}; }

/// The scene `nudge` with another push, or none.
struct Nudge {
  explicit Nudge(const std::string& controller, std::uint64_t seed = 1, const std::vector<std::string>& more = {})
      : scene("nudge", options(controller, seed, more)) {}

  /// Whether the robot stands 3 s after a push [N s] on its trunk from 1.0 to 1.1 s.
  bool withstands(const Vec3d& impulse) {
    run(1s);
    robot.object("torso").set(properties::applied_force, {{}, 10.0 * impulse});
    run(100ms);
    robot.object("torso").set(properties::applied_force, {});
    run(3s);
    return up_of(robot).z > 0.9;
  }
  void run(Duration time) { scene.simulation().run(time); }

  scene::Scene scene;
  Entity& robot = scene.simulation().world().entity("robot");
};

TEST(AnkleStrategy, WithstandsPushesThatAStiffRobotDoesNot) {
  for (const double impulse : {2.17, -2.34}) {
    EXPECT_FALSE(Nudge("walk").withstands({impulse, 0, 0})) << impulse;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      EXPECT_TRUE(Nudge("balance", seed, {uncalibrated}).withstands({impulse, 0, 0})) << impulse << ", seed " << seed;
    }
  }
}

TEST(AnkleStrategy, ComesToRestAfterAPush) {
  for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
    for (const double impulse : {0.0, 1.0, -1.0, 1.9, -1.9}) {
      Nudge nudge("balance", 1, {uncalibrated, std::string("robot.level=") + level});
      EXPECT_TRUE(nudge.withstands({impulse, 0, 0})) << level << ", " << impulse;
      for (int i = 0; i < 100; ++i) {
        nudge.run(5ms);
        EXPECT_LT(norm(nudge.robot.object("torso").get(properties::angular_velocity)), 0.02)
            << level << ", " << impulse;
      }
    }
  }
}

TEST(AnkleStrategy, WithstandsWhateverAStiffRobotDoes) {
  for (const Vec3d& direction : {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0.7, -0.7, 0}}) {
    for (const double impulse : {0.5, 1.0, 1.5, 1.9}) {
      EXPECT_TRUE(Nudge("walk").withstands(impulse * direction)) << impulse;
      EXPECT_TRUE(Nudge("balance").withstands(impulse * direction))
          << impulse << " at " << direction.x << ", " << direction.y;
    }
  }
}

TEST(AnkleStrategy, KnowsUpInSpiteOfBiasAndNoise) {
  law::Worst worst;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Nudge nudge("balance", seed, {uncalibrated});
    nudge.run(500ms);
    const Vec3d upright = up_of(nudge.robot);
    nudge.robot.object("torso").set(properties::applied_force, {{}, {6, 2, 0}});
    for (int i = 0; i < 400; ++i) {
      if (i == 50) nudge.robot.object("torso").set(properties::applied_force, {});
      nudge.run(5ms);
      const Vec3d u = nudge.robot.base().get(properties::balance_up);
      const Vec3d u0 = nudge.robot.base().get(properties::balance_upright);
      const Vec3d truth = up_of(nudge.robot);
      const auto lean = [](const Vec3d& up, const Vec3d& from) {
        return std::atan2(-up.x, up.z) - std::atan2(-from.x, from.z);
      };
      worst.see(std::abs(lean(u, u0) - lean(truth, upright)), "seed", seed, "step", i);
    }
  }
  law::expect_below({.law = "balance: error of the lean from a noisy sensor, 2 s with a push",
                     .level = "articulated_dynamics, mpu6050 not calibrated",
                     .source = "orientation of the trunk"},
                    worst, 0.03, "rad");
}

TEST(AnkleStrategy, TakesTheMeanWhileItSettlesAsBias) {
  Nudge nudge("balance", 1, {uncalibrated});
  nudge.run(1s);
  const Vec3d bias = nudge.robot.base().get(properties::balance_bias);
  EXPECT_GT(norm(bias), 0.05) << "the part has one";
  const auto shown = sensors::find_reading(nudge.robot, "imu")->output("gyroscope");
  EXPECT_NEAR(shown[1], bias.y, 0.02) << "the robot stands";
}

TEST(AnkleStrategy, NeedsAnInertialSensor) {
  const auto refusal = [](const std::string& sensors) -> std::string {
    try {
      Nudge nudge("balance", 1, {sensors});
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  };
  for (const char* sensors : {"robot.sensors=false", "robot.sensors.imu=false"}) {
    const std::string message = refusal(sensors);
    EXPECT_NE(message.find("needs a sensor 'imu'"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_NE(refusal("robot.sensors.imu.type=gyroscope").find("unknown output 'accelerometer'"), std::string::npos);
}

// Without gravity nothing falls, and no capture point exists: the robot keeps its stance, and all numbers are finite.
TEST(AnkleStrategy, StandsWithLittleGravityOrNone) {
  for (const char* gravity : {"[0, 0, 0]", "[0, 0, -1e-9]", "[0, 0, -0.05]", "[0, 0, -0.2]", "[0, 0, -1.62]"}) {
    for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
      Nudge nudge("balance", 1, {uncalibrated, std::string("gravity=") + gravity, std::string("robot.level=") + level});
      nudge.run(4s);
      EXPECT_FALSE(nudge.robot.frozen()) << gravity << ", " << level;
      EXPECT_GT(up_of(nudge.robot).z, 0.98) << gravity << ", " << level;
    }
  }
}

}  // namespace
}  // namespace murosimf::locomotion
