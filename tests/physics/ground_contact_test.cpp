// A box at rest on the ground, under every law and at every dynamic level.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class Box : public testing::TestWithParam<LevelAndLaw> {};

// To 0.1 % on the average of a second: the paper's law never comes to rest.
TEST_P(Box, GroundCarriesItsWeight) {
  Rig rig;
  Entity& box = rig.add("box", box_model());
  rig.attach_dynamics(box, dynamics(GetParam()));
  rig.run(2.0);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.simulation.step();
    sum += box.base().get(properties::external_force).f.z;
  }
  law::expect_near({.law = "box on the ground: ground force, mean of 1 s",
                    .level = words_of(GetParam()),
                    .source = "its weight"},
                   sum / 1000, 4.3 * g, 1e-3 * 4.3 * g, "N");
}
INSTANTIATE_TEST_SUITE_P(Contact, Box,
                         at_every_level({"implicit_stick", "island_gauss_seidel", "kelvin_voigt", "paper",
                                         "paper_multipoint"}),
                         test_name);

class LongSteps : public testing::TestWithParam<LevelAndLaw> {};

// 1e-6 m in 3 s is standing.
TEST_P(LongSteps, BoxStands) {
  law::Worst creep;
  for (const double rate : {500.0, 200.0, 100.0}) {
    Rig rig(0.8, 3 * degree, rate);
    Entity& box = rig.add("box", box_model());
    rig.attach_dynamics(box, dynamics(GetParam()));
    rig.run(2.0);
    const double before = Rig::place(box).x;
    rig.run(3.0);
    creep.see(std::abs(Rig::place(box).x - before), rate, "Hz");
  }
  law::expect_below({.law = "box on a slope of 3 degrees, steps of 2, 5 and 10 ms: creep in 3 s",
                     .level = words_of(GetParam()),
                     .source = "stable with long steps: none"},
                    creep, 1e-6, "m");
}
INSTANTIATE_TEST_SUITE_P(Contact, LongSteps, at_every_level({"implicit_stick", "island_gauss_seidel"}), test_name);

}  // namespace
}  // namespace murosimf::test
