// Drawings of control software: kept by name for observers, no part of the state, and limited.
#include "murosimf/drawing/sketch_pad.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/control_software/controller_task.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::drawing {
namespace {

using namespace std::chrono_literals;

/// Control software that draws.
class Painter final : public control_software::ControlSoftware {
 public:
  explicit Painter(std::function<void(Duration)> paint) : paint_(std::move(paint)) {}
  control_software::CallOutcome start() override { return {}; }
  control_software::CallOutcome step(Duration now) noexcept override {
    paint_(now);
    return {};
  }

 private:
  std::function<void(Duration)> paint_;
};

DrawnShape circle(double radius = 0.1) { return {.points = {{1, 2, 0}}, .size = radius}; }

/// The drawings after `paint` was called with the port every 10 ms, for 50 ms.
Drawings drawn(const std::function<void(control_software::RobotPort&, Duration)>& paint,
               std::uint64_t* hash = nullptr) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  rig.simulation.attach<control_software::ControllerTask>(
      "control_software", robot, 100,
      [&](Setup&, control_software::RobotPort& port, const control_software::SayLine&) {
        return std::make_unique<Painter>([&](Duration now) { paint(port, now); });
      },
      control_software::ControllerTaskOptions{.software = "painter"});
  rig.attach_dynamics(robot, {.level = "simplified_dynamics"});
  rig.simulation.run(50ms);
  if (hash) *hash = rig.simulation.state_hash();
  return robot.find(properties::drawings)->values[0];
}

TEST(SketchPad, KeepsTheLastGroupOfEachName) {
  const Drawings all = drawn([](control_software::RobotPort& port, Duration now) {
    EXPECT_TRUE(port.draw({.name = "way", .shapes = {circle(seconds(now))}}));
    EXPECT_TRUE(now != 10ms || port.draw({.name = "ball", .of_robot = true, .shapes = {circle(), circle()}}));
    EXPECT_TRUE(now != 20ms || port.draw({.name = "gone", .shapes = {circle()}}));
    EXPECT_TRUE(now != 30ms || port.draw({.name = "gone"}));
  });
  ASSERT_EQ(all.groups.size(), 2U);
  EXPECT_EQ(all.groups[0].name, "ball");
  EXPECT_TRUE(all.groups[0].of_robot);
  EXPECT_EQ(all.groups[0].time, 10ms);
  EXPECT_EQ(all.groups[0].shapes.size(), 2U);
  EXPECT_EQ(all.groups[1].name, "way");
  EXPECT_EQ(all.groups[1].time, 40ms);
  EXPECT_EQ(all.groups[1].shapes[0].size, 0.04);
  EXPECT_EQ(all.changes, 8U);
}

TEST(SketchPad, IsNoPartOfTheState) {
  std::uint64_t with = 0, without = 0;
  (void)drawn([](control_software::RobotPort& port, Duration) { (void)port.draw({.name = "a", .shapes = {circle()}}); },
              &with);
  (void)drawn([](control_software::RobotPort&, Duration) {}, &without);
  EXPECT_EQ(with, without);
}

TEST(SketchPad, RefusesWhatIsTooMuchOrHasNoSense) {
  const Drawings all = drawn([](control_software::RobotPort& port, Duration now) {
    if (now != Duration{}) return;
    const auto refused = [&](DrawnShape shape) { return !port.draw({.name = "a", .shapes = {std::move(shape)}}); };
    EXPECT_TRUE(refused({.points = {}}));
    EXPECT_TRUE(refused({.points = {{std::nan(""), 0, 0}}}));
    EXPECT_TRUE(refused({.points = {{0, 0, 0}}, .size = -1}));
    EXPECT_TRUE(refused({.points = {{0, 0, 0}}, .color = {0, 2, 0}}));
    EXPECT_TRUE(refused({.points = {{0, 0, 0}}, .opacity = std::nan("")}));
    EXPECT_TRUE(refused({.kind = static_cast<DrawnShape::Kind>(6), .points = {{0, 0, 0}}}));
    EXPECT_TRUE(refused({.kind = DrawnShape::text, .points = {{0, 0, 0}}, .words = std::string(1001, 'a')}));
    EXPECT_TRUE(refused({.kind = DrawnShape::dots, .points = std::vector<Vec3d>(SketchPad::most_points + 1)}));
    EXPECT_FALSE(port.draw({.name = "a", .shapes = std::vector<DrawnShape>(SketchPad::most_shapes + 1, circle())}));
    for (std::size_t i = 0; i < SketchPad::most_groups; ++i) {
      EXPECT_TRUE(port.draw({.name = std::to_string(i), .shapes = {circle()}}));
    }
    EXPECT_FALSE(port.draw({.name = "one more", .shapes = {circle()}}));
    EXPECT_TRUE(port.draw({.name = "7", .shapes = {circle(0.5)}}));
  });
  EXPECT_EQ(all.groups.size(), SketchPad::most_groups);
}

}  // namespace
}  // namespace murosimf::drawing
