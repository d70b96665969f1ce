#include "murosimf/collision/contact_laws/effective_mass.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"
#include "tests/collision/movers.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

/// 2 kg with the inertia diag(0.02, 0.05, 0.04) about (0.1, 0, 0).
ModelPtr brick() {
  return std::make_shared<const Model>("brick", Chain{}
                                                    .base("brick")
                                                    .with(properties::mass, 2)
                                                    .with(properties::center_of_mass, {0.1, 0, 0})
                                                    .with(properties::inertia, SymMat3d{0.02, 0.05, 0.04, 0, 0, 0}));
}

// By hand: turned by 90 degrees about z, its center at (3, 0.1, 0); pushed along x at 0.3 m above and 0.2 m beside it.
TEST(EffectiveMass, ABodyYieldsByItsMassAndInertia) {
  Movers movers;
  MovingEntity& mover = movers.add("brick", brick());
  Movers::place(mover, {3, 0, 0}, rotation_z(pi / 2));
  EffectiveMass parts;
  const EffectiveMass::Number part = parts.touch(mover, 0, 0);
  const Vec3d point{3, 0.3, 0.3};
  // moment of 1 N along x: (0, 0.3, -0.2); world y is the brick's -x
  EXPECT_NEAR(parts.along(part, point, {1, 0, 0}), 1 / 2.0 + 0.09 / 0.02 + 0.04 / 0.04, 1e-12);
  EXPECT_NEAR(parts.about(part, {0, 1, 0}), 1 / 0.02, 1e-12);
  EXPECT_NEAR(parts.about(part, {1, 0, 0}), 1 / 0.05, 1e-12);
}

TEST(EffectiveMass, ContactsOfOnePartCount) {
  Movers movers;
  MovingEntity& a = movers.add("a", ball(0.1, 2));
  MovingEntity& b = movers.add("b", ball(0.1, 4));
  MovingEntity& fast = movers.add("fast", ball(0.1, 1));
  Movers::stand_fast(fast);
  EffectiveMass parts;
  const auto first = parts.touch(a, 0, 0), other = parts.touch(b, 1, 0);
  EXPECT_EQ(parts.touch(a, 0, 0), first);
  EXPECT_NE(other, first);
  EXPECT_NEAR(parts.along(first, {}, {0, 0, 1}), 2 / 2.0, 1e-12);
  EXPECT_NEAR(parts.along(other, {}, {0, 0, 1}), 1 / 4.0, 1e-12);
  EXPECT_EQ(parts.touch(fast, 2, 0), EffectiveMass::none);
  EXPECT_EQ(parts.along(EffectiveMass::none, {}, {0, 0, 1}), 0);
  EXPECT_EQ(parts.about(EffectiveMass::none, {0, 0, 1}), 0);
  parts.start();
  EXPECT_NEAR(parts.along(parts.touch(a, 0, 0), {}, {0, 0, 1}), 1 / 2.0, 1e-12);
}

/// What kid21's level says of all its bodies (impulse_response.h) as a share of what the parts say, the least and the greatest.
std::pair<double, double> shares_at(const std::string& level) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = {0, 0, 1}});
  rig.attach_together({{&robot, {.level = level}}});
  rig.simulation.initialize();
  rig.simulation.step();
  AccessSet access;
  const MovingEntity mover(Setup(rig.simulation.world(), robot, access));
  EXPECT_TRUE(mover.interface.response->free_pass(1e-3));
  Dice dice("yielding");
  std::pair<double, double> shares{1e9, 0};
  for (const int object : robot.model().having(properties::shapes)) {
    const Vec3d point = mover.r[object] + dice.vector(0.05), u = dice.unit();
    EffectiveMass parts;
    const double most = parts.along(parts.touch(mover, 0, object), point, u);
    ResponseRows y;
    mover.interface.response->respond(object, point, {u, {}, {}}, y);
    double yields = 0;
    for (const Vec3d& numbers : y.value) yields += numbers.x * numbers.x;
    shares.first = std::min(shares.first, yields / most);
    shares.second = std::max(shares.second, yields / most);
  }
  return shares;
}

// Where joints are given, the robot is one body: exactly. Where torques move them, a free link yields more than a held one.
TEST(EffectiveMass, NoBodyOfARobotYieldsMore) {
  for (const std::string level : {"simplified_dynamics", "full_dynamics"}) {
    const auto [least, greatest] = shares_at(level);
    EXPECT_NEAR(least, 1, 1e-9) << level;
    EXPECT_NEAR(greatest, 1, 1e-9) << level;
  }
  const auto [least, greatest] = shares_at("articulated_dynamics");
  EXPECT_GT(least, 0.001);
  expect_law("articulated_dynamics",
             "kid21's bodies: velocity by an impulse as a share of that of a free link, the most",
             "joints only hold a link back (Gauss): not above 1", greatest, 1 + 1e-9, "");
}

}  // namespace
}  // namespace murosimf::collision
