// Timed pushes: their impulse is exact, their arm turns with the body, and what users push stays.
#include "murosimf/dynamics/push.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/sensors/puppet.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;
using std::chrono::microseconds;

constexpr double h = 4e-3;
const Vec3d center{0.1, -0.2, 0.3};

/// A body that stands turned by 90 degrees about z, pushed at 250 Hz.
struct Pushed {
  explicit Pushed(const std::vector<TimedPush>& pushes) {
    const Chain chain = Chain{}
                            .base("body")
                            .with(properties::mass, 2.0)
                            .with(properties::center_of_mass, center)
                            .revolute("joint", {0, 1, 0});
    body = &simulation.world().add("body", std::make_shared<const Model>("body", chain));
    simulation.attach<Push>("push", *body, 250, pushes);
    simulation.attach<test::Puppet>("puppet", *body, 250, [](double) {
      return test::BodyMotion{{1, 2, 3}, rotation_z(pi / 2), {}, {}};
    });
    simulation.initialize();
  }
  Wrenchd step(const char* object = "body") {
    simulation.step();
    return body->object(object).get(properties::applied_force);
  }
  Simulation simulation;
  Entity* body = nullptr;
};

TimedPush push(const Vec3d& force, const Vec3d& moment, int begin_us, int end_us, int object = 0) {
  return {object, force, moment, microseconds(begin_us), microseconds(end_us)};
}

// Steps of 4 ms; a push from 5 to 13 ms lasts 3/4 of the second step, all of the third, 1/4 of the fourth.
TEST(Push, ActsByTheShareOfEachStep) {
  const Vec3d force{3, -2, 5}, moment{0.1, 0.2, 0.4};
  Pushed pushed({push(force, moment, 5000, 13000)});
  const Vec3d arm{0.2, 0.1, 0.3};  // of the center of mass, turned
  for (const double share : {0.0, 0.75, 1.0, 0.25, 0.0, 0.0}) {
    const Wrenchd found = pushed.step();
    EXPECT_LT(difference(found.f, share * force), 1e-14);
    EXPECT_LT(difference(found.n, share * (moment + cross(arm, force))), 1e-14);
  }
}

TEST(Push, ShorterThanAStepHasItsWholeImpulse) {
  Pushed pushed({push({0, 80, 0}, {}, 4500, 5000)});
  EXPECT_EQ(pushed.step().f.y, 0);
  EXPECT_NEAR(pushed.step().f.y * h, 80 * 0.5e-3, 1e-15);
  EXPECT_EQ(pushed.step().f.y, 0);
}

TEST(Push, PushesOfOneBodyAddUpAndOthersAreUntouched) {
  Pushed pushed({push({1, 0, 0}, {}, 0, 8000), push({0, 4, 0}, {}, 0, 4000), push({9, 0, 0}, {}, 0, 8000, 1)});
  EXPECT_LT(difference(pushed.step().f, {1, 4, 0}), 1e-15);
  EXPECT_LT(difference(pushed.body->object("joint").get(properties::applied_force).f, {9, 0, 0}), 1e-15);
  EXPECT_LT(difference(pushed.step().f, {1, 0, 0}), 1e-15);
  EXPECT_LT(difference(pushed.step().f, {0, 0, 0}), 1e-15);
}

// Rule: what users set stays, before, during and after a push.
TEST(Push, WhatUsersSetStays) {
  Pushed pushed({push({1, 0, 0}, {}, 4000, 12000)});
  pushed.step();
  pushed.body->base().set(properties::applied_force, Wrenchd{{}, {0, 0, 7}});
  EXPECT_LT(difference(pushed.step().f, {1, 0, 7}), 1e-15);
  pushed.body->base().set(properties::applied_force, Wrenchd{{}, {0, 3, 0}});
  EXPECT_LT(difference(pushed.step().f, {1, 3, 0}), 1e-15);
  EXPECT_LT(difference(pushed.step().f, {0, 3, 0}), 1e-15);
}

}  // namespace
}  // namespace murosimf::dynamics
