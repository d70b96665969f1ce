// A robot walks under every contact law and at every dynamic level.
#include <gtest/gtest.h>

#include "tests/physics/walk.h"

namespace murosimf::test {
namespace {

class Walker : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, Walker,
                         at_every_level({"implicit_stick", "island_gauss_seidel", "kelvin_voigt", "paper",
                                         "paper_multipoint"}),
                         test_name);

// 18 s at 0.2 m/s: no fall, and within 15 % of the commanded way (ramp at the start, attenuation by the joints, and the
// slip that viscous friction has).
TEST_P(Walker, GetsWhereItIsTold) {
  const Walk result = walk({dynamics(GetParam()), {0.2, 0, 0}});
  law::expect_below({.law = "walk forward with 0.2 m/s: largest lean of the pelvis in 18 s",
                     .level = words_of(GetParam()),
                     .source = "it does not fall"},
                    result.lean, 10, "deg");
  law::expect_near({.law = "walk forward with 0.2 m/s: way in 18 s",
                    .level = words_of(GetParam()),
                    .source = "the commanded speed times time"},
                   result.moved.x, 0.2 * 18, 0.15 * 0.2 * 18, "m");
}

// Uphill nearly as far as MuJoCo, which falls from 5 degrees. On springs that sink 0.4 mm under the weight it
// fell from 3.5 degrees.
TEST(WalkerUphill, ClimbsFourDegrees) {
  const Walk result =
      walk({.dynamics = {.level = "articulated_dynamics"}, .command = {0.1, 0, 0}, .slope = 4 * degree});
  law::expect_below({.law = "walk up a slope of 4 degrees with 0.1 m/s: largest lean of the pelvis in 18 s",
                     .level = "articulated_dynamics, implicit_stick",
                     .source = "it does not fall"},
                    result.lean, 15, "deg");
}

}  // namespace
}  // namespace murosimf::test
