// What the recorder writes down of a body that moves as the test says.
#include "murosimf/dynamics/motion_recorder.h"

#include <gtest/gtest.h>

#include <functional>
#include <tuple>

#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;

/// Everything that a recorder looks at, at one instant.
struct Moment {
  Vec3d r, w;
  Mat3d R;
  double torque = 0, q = 0;
  std::vector<collision::ContactPoint> points;
};

/// Two soles: the first one fixed 0.5 m below the base, the second one on a joint.
Chain two_feet() {
  const Servo servo{.law = "dc_motor",
                    .stall_torque = 6,
                    .no_load_speed = 8,
                    .position_gain = 30,
                    .duty_limit = 0.9,
                    .torque_limit = 4};
  Chain left = Chain{}.translation({0, 0.1, -0.5}, "left").with(properties::sole, {0.06, 0.03});
  Chain right = Chain{}
                    .translation({0, -0.1, -0.4})
                    .revolute("ankle", {0, 1, 0})
                    .with(properties::servo, servo)
                    .with(properties::mass, 1.0)
                    .translation({0, 0, -0.2}, "right")
                    .with(properties::sole, {0.08, 0.04});
  return Chain{}.base("base").with(properties::mass, 3.0).fork(left, right);
}

class Stage final : public Algorithm {
 public:
  Stage(Setup& setup, std::function<Moment(double)> play)
      : play_(std::move(play)),
        model_(setup.model()),
        r_(setup.write(properties::position)),
        v_(setup.write(properties::linear_velocity)),
        w_(setup.write(properties::angular_velocity)),
        R_(setup.write(properties::orientation)),
        torque_(setup.write(properties::joint_torque)),
        q_(setup.write(properties::joint_position)),
        contacts_(setup.write(collision::contacts)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { show(0); }
  void step(const Instant& instant) noexcept override { show(seconds(instant.now + instant.period)); }

 private:
  void show(double t) {
    const Moment moment = play_(t);
    for (int i = 0; i < model_.size(); ++i) {
      r_[i] = moment.r;
      R_[i] = moment.R;
      w_[i] = moment.w;
      torque_[i] = moment.torque;
      q_[i] = moment.q;
    }
    const int left = model_.object_index("left"), right = model_.object_index("right");
    r_[left] = moment.r + moment.R * Vec3d{0, 0.1, -0.5};
    r_[right] = moment.r + moment.R * Vec3d{0, -0.1, -0.6};
    contacts_.points = moment.points;
  }
  std::function<Moment(double)> play_;
  const Model& model_;
  std::span<Vec3d> r_, v_, w_;
  std::span<Mat3d> R_;
  std::span<double> torque_, q_;
  collision::ContactSet& contacts_;
};

/// 0.2 s at 500 Hz.
MotionRecord record(const std::function<Moment(double)>& play, const MotionRecorderOptions& options = {}) {
  Simulation simulation;
  Entity& robot = simulation.world().add("robot", std::make_shared<const Model>("robot", two_feet()));
  simulation.attach<Stage>("stage", robot, 500, play);
  auto& recorder = simulation.attach<MotionRecorder>("recorder", robot, 500, options);
  simulation.run(from_seconds(0.2));
  return recorder.record();
}

TEST(MotionRecorder, SamplesAHundredTimesASecondFromTheStart) {
  const MotionRecord found = record([](double t) { return Moment{.r = {t, 2 * t, 1}}; });
  ASSERT_EQ(found.samples.size(), 21U);
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(found.samples[i].time, t, 1e-12);
    EXPECT_LT(difference(found.samples[i].base, {t, 2 * t, 1}), 1e-12);
    EXPECT_LT(difference(found.samples[i].center, {t, 2 * t, 1}), 1e-12);
  }
  EXPECT_EQ(found.soles, 2U);
  EXPECT_EQ(found.joints, (std::vector<std::string>{"ankle"}));
}

// Turns yaw, roll, pitch give the angles back, also beyond 90 degrees of pitch; the rate is in axes of the base.
TEST(MotionRecorder, AnglesAreThoseOfTheTurns) {
  for (const auto& [yaw, roll, pitch] : {std::tuple{0.7, 0.3, -0.4}, {-2.0, -1.2, 0.6}, {0.1, 0.5, 2.5}}) {
    const Mat3d R = rotation_z(yaw) * rotation_x(roll) * rotation_y(pitch);
    const MotionSample found = record([&](double) { return Moment{.w = {1, -2, 3}, .R = R}; }).samples[1];
    EXPECT_NEAR(found.roll, roll, 1e-12);
    EXPECT_NEAR(found.pitch, pitch, 1e-12);
    EXPECT_LT(difference(R * found.rate, {1, -2, 3}), 1e-12);
  }
}

TEST(MotionRecorder, ClearanceIsThatOfTheLowestCorner) {
  const Mat3d R = rotation_x(0.2) * rotation_y(-0.3);
  const Vec3d r{3, 4, 0.9};
  const MotionSample found = record([&](double) { return Moment{.r = r, .R = R}; }).samples[1];
  const auto lowest = [&](const Vec3d& sole, double x, double y) {
    double low = 1e300;
    for (const double a : {-x, x}) {
      for (const double b : {-y, y}) low = std::min(low, (r + R * (sole + Vec3d{a, b, 0})).z);
    }
    return low;
  };
  EXPECT_NEAR(found.clearance[0], lowest({0, 0.1, -0.5}, 0.06, 0.03), 1e-12);
  EXPECT_NEAR(found.clearance[1], lowest({0, -0.1, -0.6}, 0.08, 0.04), 1e-12);
}

// Five steps for a sample: the torque grows by 1 N m in each.
TEST(MotionRecorder, TorquesAreMeansSinceTheSampleBefore) {
  const MotionRecord found = record([](double t) { return Moment{.torque = 500 * t}; });
  ASSERT_EQ(found.torques.size(), found.samples.size());
  EXPECT_EQ(found.torques[0], 0);
  for (std::size_t i = 1; i < found.torques.size(); ++i) {
    EXPECT_NEAR(found.torques[i], 5 * static_cast<double>(i) - 2, 1e-9) << i;
  }
}

collision::ContactPoint grip(int object, std::uint64_t feature, const Vec3d& point, double load) {
  collision::ContactPoint c;
  c.object = object;
  c.feature = feature;
  c.point = point;
  c.normal = {0, 0, 1};
  c.force = {3, 0, load};
  return c;
}

// Two corners of the left foot, on the base's link: one stays with 30 N, the other slides along (3, 4) with 10 N; what goes
// up does not count, nor do points that were not there or carry nothing. The right foot slides too.
TEST(MotionRecorder, SlipIsTheWayOfTheCornersByTheirLoad) {
  const Model model("robot", two_feet());
  const int left = 0, right = model.object_index("ankle");
  const MotionRecord found = record([=](double t) {
    const double way = 0.1 * t;
    return Moment{.points = {grip(left, 1, {0, 0, 0}, 30), grip(left, 2, {0.6 * way, 0.8 * way, 9 * t}, 10),
                             grip(left, 3, {5 * t, 0, 0}, 0), grip(left, 100 + std::lround(500 * t), {7 * t, 0, 0}, 50),
                             grip(right, 1, {0, -2 * way, 0}, 5)}};
  });
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const double way = 0.001 * static_cast<double>(i);
    EXPECT_NEAR(found.samples[i].slip, way * 10 / 40 + 2 * way, 1e-12) << i;
  }
}

// Full duty: an error of 0.9 * 6 / 30 = 0.18 rad, or a torque at its limit of 4 N m.
TEST(MotionRecorder, FullDutyIsTheShareOfTimeInWhichAServoGivesAll) {
  const auto share = [](double q, double torque) {
    return record([=](double t) { return Moment{.torque = t > 0.0501 ? torque : 0, .q = t > 0.1501 ? q : 0}; },
                  {.servos = true})
        .full_duty;
  };
  EXPECT_NEAR(share(0.179, 3.99), 0, 1e-12);
  EXPECT_NEAR(share(-0.181, 3.99), 0.25, 1e-12);
  EXPECT_NEAR(share(0.1, -4), 0.75, 1e-12);
  EXPECT_NEAR(share(0.2, 4), 0.75, 1e-12);
  EXPECT_EQ(record([](double) { return Moment{.torque = 9, .q = 9}; }).full_duty, 0) << "not watched";
}

}  // namespace
}  // namespace murosimf::dynamics
