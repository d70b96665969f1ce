// What is put into the ground, or into another body, comes out slowly.
#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class SoftStartLevels : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, SoftStartLevels,
                         at_every_level({"implicit_stick", "island_gauss_seidel", "kelvin_voigt", "paper",
                                         "paper_multipoint"}),
                         test_name);

/// Largest speed [m/s] of the bases upwards in a second.
law::Worst rise(Rig& rig, const std::vector<Entity*>& entities) {
  law::Worst speed;
  for (int i = 0; i < 1000; ++i) {
    rig.simulation.step();
    for (Entity* entity : entities) speed.see(Rig::velocity(*entity).z, entity->name());
  }
  return speed;
}

// Tolerance: servos let the base move against the limbs, and ten sweeps do not settle some forty deep points of a
// moving tree at once.
TEST_P(SoftStartLevels, OutOfTheGround) {
  const LevelAndLaw unsettled{"articulated_dynamics", "island_gauss_seidel"};
  for (const double depth : {0.05, 0.2}) {
    Rig rig;
    Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, -depth}});
    rig.attach_dynamics(robot, dynamics(GetParam()));
    law::expect_below({.law = fmt::format("robot starts {} m deep in the ground: largest speed of its rise", depth),
                       .level = words_of(GetParam()),
                       .source = "contact lets it out with 0.5 m/s"},
                      rise(rig, {&robot}), GetParam() == unsettled ? 3 : 1, "m/s");
    EXPECT_GT(Rig::place(robot).z, 0.05) << "it lies, at least";
  }
}

class SoftStartOfTwo : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, SoftStartOfTwo, at_every_level({"island_gauss_seidel", "carry", "kelvin_voigt"}),
                         test_name);

// Two that share their place. Tolerance: what a law gives back a step later.
TEST_P(SoftStartOfTwo, OutOfEachOther) {
  const auto& [level, law] = GetParam();
  Rig rig;
  Entity& below = rig.add("below", box_model());
  Entity& above = rig.add("above", box_model(), {.position = {0, 0, 0.04}});
  rig.attach_together({{&below, {.level = level}}, {&above, {.level = level}}}, law);
  law::expect_below({.law = "box starts 6 cm deep in another one: largest speed of its rise",
                     .level = words_of(GetParam()),
                     .source = "contact lets it out with 0.5 m/s"},
                    rise(rig, {&below, &above}), 0.75, "m/s");
  EXPECT_NEAR(Rig::place(above).z - Rig::place(below).z, 0.1, 5e-3);
}

}  // namespace
}  // namespace murosimf::test
