// What feet report without contact forces, and from which force on they report anything: a body whose loads are given.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/sensors/contact_sensors.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"
#include "tests/sensors/puppet.h"

namespace murosimf::sensors {
namespace {

using fixtures::difference;

/// Says which foot stands, and nothing else.
struct Stance final : Algorithm {
  explicit Stance(Setup& setup) : foot(setup.write(properties::stance_foot)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void initialize() override { foot[0] = std::numeric_limits<double>::quiet_NaN(); }
  void step(const Instant&) noexcept override {}
  std::span<double> foot;  // [1]
};

/// A block of 3 kg with two soles that lies askew and carries one sensor.
template <class S>
struct Block {
  explicit Block(const SensorSpec& spec, const Mat3d& turn = {})
      : entity(simulation.world().add("block", model())),
        sensor(simulation.attach<S>("sensor", entity, 1000, spec, SensorSurroundings{})),
        stance(simulation.attach<Stance>("stance", entity, 1000)) {
    simulation.attach<test::Puppet>("puppet", entity, 1000, [turn](double) {
      return test::BodyMotion{.position = {5, -6, 7}, .orientation = turn};
    });
    simulation.initialize();
    entity.base().set(properties::dynamic, 1);
  }
  static ModelPtr model() {
    Chain chain = Chain{}.base("block").with(properties::mass, 3.0).with(properties::inertia, diagonal(0.01));
    chain.fork(Chain{}.translation({0.1, 0.2, -0.3}, "left").with(properties::sole, Sole{0.1, 0.05}).endpoint(),
               Chain{}.translation({0.1, -0.25, -0.3}, "right").with(properties::sole, Sole{0.1, 0.05}).endpoint());
    return std::make_shared<const Model>("block", chain);
  }
  /// What it shows under a force [N] on the block.
  const std::vector<double>& under(const Vec3d& force) {
    entity.base().set(properties::external_force, {{}, force});
    simulation.step();
    return sensor.reading().values;
  }
  /// What it shows without contact forces while that foot stands.
  const std::vector<double>& on_foot(double number) {
    entity.base().set(properties::dynamic, 0);
    stance.foot[0] = number;
    simulation.step();
    return sensor.reading().values;
  }

  Simulation simulation;
  Entity& entity;
  S& sensor;
  Stance& stance;
};

// The ground's force on the foot that stands is the weight, upwards through the middle of its sole; the sensor sees it from its
// place, in its axes.
TEST(CarriedWeight, IsSeenInTheSensorsAxes) {
  const Mat3d turn = rotation_x(0.4) * rotation_z(1.1), mounted = rotation_y(0.3);
  Block<ForceTorque> block({.name = "f", .position = {0.02, 0.03, -0.05}, .orientation = mounted}, turn);
  const Vec3d weight{0, 0, 3 * 9.81};                                                    // [N]
  const std::array<Vec3d, 2> arms{Vec3d{0.08, 0.17, -0.25}, Vec3d{0.08, -0.28, -0.25}};  // [m] from sensor to sole
  for (const std::size_t foot : {0U, 1U}) {
    const auto& shown = block.on_foot(static_cast<double>(foot));
    const Mat3d to_sensor = transpose(turn * mounted);
    EXPECT_LT(difference({shown[0], shown[1], shown[2]}, to_sensor * weight), 1e-12) << foot;
    EXPECT_LT(difference({shown[3], shown[4], shown[5]}, to_sensor * cross(turn * arms[foot], weight)), 1e-12) << foot;
  }
}

TEST(CarriedWeight, IsNothingWhereNoFootStands) {
  Block<ContactForce> block({.name = "f"});
  EXPECT_EQ(block.on_foot(std::nan(""))[0], 0) << "as from the start: a state that becomes NaN ends debug builds";
  EXPECT_NEAR(block.on_foot(1)[0], 3 * 9.81, 1e-12);
  EXPECT_EQ(block.on_foot(2)[0], 0) << "it has two, 0 and 1";
}

// Rule: a user's push is felt by no body of the link: here one on its second body, which the ground pushes with 5 N besides.
TEST(ContactLoad, LeavesOutThePushOnEveryBody) {
  Simulation simulation;
  Chain chain = Chain{}.base("heel").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.01));
  chain.translation({0.4, 0, 0}, "toe").with(properties::mass, 2.0).with(properties::inertia, diagonal(0.01));
  Entity& shoe = simulation.world().add("shoe", std::make_shared<const Model>("shoe", chain));
  auto& sensor = simulation.attach<ForceTorque>("sensor", shoe, 1000, SensorSpec{.name = "f"}, SensorSurroundings{});
  simulation.attach<test::Puppet>("puppet", shoe, 1000, test::at_rest);
  simulation.initialize();
  shoe.base().set(properties::dynamic, 1);
  shoe.object("toe").set(properties::applied_force, {{0, 3, 0}, {7, -2, 1}});
  shoe.object("toe").set(properties::external_force, {{0, 3, 0}, {7, -2, 6}});
  simulation.step();
  const auto force = sensor.reading().output("force");
  EXPECT_LT(difference(Vec3d{force[0], force[1], force[2]}, {0, 0, 5}), 1e-12);
}

// Rule: the threshold is 0.1 N by default, exclusive.
TEST(ContactThreshold, IsATenthOfANewton) {
  Block<ContactSwitch> block({.name = "s"});
  EXPECT_EQ(block.under({0, 0, 0.1})[0], 0);
  EXPECT_EQ(block.under({0, 0, 0.1001})[0], 1);
  EXPECT_EQ(block.under({0, -0.1001, 0})[0], 1) << "from any side";
}

TEST(ContactThreshold, MustBeExceeded) {
  const SensorSpec spec{.name = "s", .frame = "right", .numbers = {{"threshold", 2}}};
  Block<ContactSwitch> contact(spec);
  EXPECT_EQ(contact.under({0, 2, 0})[0], 0);
  EXPECT_EQ(contact.under({0, 2.001, 0})[0], 1);
  Block<PressureCenter> center(spec);
  EXPECT_TRUE(std::isnan(center.under({0, 0, 2})[0]));
  EXPECT_EQ(center.under({0, 0, 2})[2], 2) << "the force is shown all the same";
  EXPECT_NEAR(center.under({0, 0, 2.001})[0], -0.1, 1e-12) << "it is the block's origin that is pushed";
  EXPECT_NEAR(center.under({0, 0, 2.001})[1], 0.25, 1e-12);
  Block<PressureCells> cells(spec);
  EXPECT_EQ(cells.under({0, 0, 2}), (std::vector<double>{0, 0, 0, 0}));
  // beyond the hind left corner: all of it is there
  const auto& pressed = cells.under({0, 0, 2.001});
  EXPECT_NEAR(pressed[2], 2.001, 1e-12);
  EXPECT_NEAR(pressed[0] + pressed[1] + pressed[3], 0, 1e-12);
}

}  // namespace
}  // namespace murosimf::sensors
