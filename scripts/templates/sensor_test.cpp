// The sensor new_name against closed forms.
#include "murosimf/sensors/new_name.h"

#include <gtest/gtest.h>

#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using test::RangeRig;

/// What one shows that is mounted at `position` [m] of a box, 2 m above the plane and tilted by `tilt` [rad] about y.
double shown(const Vec3d& position, double tilt) {
  RangeRig rig;
  Entity& box = rig.add_box("box");
  SensorSpec spec = test::sensor("new_name");
  spec.position = position;
  const Reading& reading = rig.attach(box, spec);
  rig.begin();
  RangeRig::put(box, {1, 1, 2}, rotation_y(tilt));
  rig.simulation.step();
  return reading.output("height")[0];
}

// Tolerances: rounding.
TEST(NewName, ShowsHowHighItIs) {
  EXPECT_NEAR(shown({}, 0.4), 2, 1e-12);
  EXPECT_NEAR(shown({0.1, 0, 0}, 0.4), 2 - 0.1 * std::sin(0.4), 1e-12);
  EXPECT_NEAR(shown({0, 0, 0.1}, 0.4), 2 + 0.1 * std::cos(0.4), 1e-12);
}

TEST(NewName, SaysWhatItsNumbersAre) {
  RangeRig rig;
  const Reading& reading = rig.attach(rig.add_box("box"), test::sensor("new_name"));
  EXPECT_EQ(reading.info->type, "new_name");
  ASSERT_EQ(reading.info->numbers(), 1u);
  EXPECT_EQ(reading.info->outputs[0].unit, "m");
}

}  // namespace
}  // namespace murosimf::sensors
