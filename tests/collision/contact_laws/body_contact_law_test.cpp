// What every law between bodies keeps.
#include "murosimf/collision/contact_laws/body_contact_law.h"

#include <gtest/gtest.h>

#include "tests/collision/meeting.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

class BodyContactLawByName : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Laws, BodyContactLawByName, testing::ValuesIn(test::body_laws()), test::level_name);

// Nothing from outside: momentum and its moment about the origin are afterwards what they were, and the bodies have parted.
TEST_P(BodyContactLawByName, MeetingKeepsMomentum) {
  Meeting meeting(GetParam());
  const Wrenchd before = [&] {
    Meeting untouched(GetParam());
    Meeting::place(*untouched.small, {9, 9, 9});
    untouched.rig.simulation.step();
    Wrenchd sum = untouched.total();
    // where it is now does not count, its momentum does
    return Wrenchd{{}, sum.f};
  }();
  bool touched = false;
  for (int i = 0; i < 400; ++i) {
    meeting.rig.simulation.step();
    touched |= !meeting.set().points.empty();
  }
  EXPECT_TRUE(touched);
  EXPECT_TRUE(meeting.set().points.empty());
  EXPECT_LT(difference(meeting.total().f, before.f), 1e-3 * norm(before.f));
}

// Rule: it comes off slower than it came, and friction slows what slides.
TEST_P(BodyContactLawByName, MeetingLosesEnergy) {
  Meeting meeting(GetParam());
  double before = 0, after = 0;
  for (Entity* entity : {meeting.small, meeting.big}) {
    const double m = entity->model().tree().mass;
    const Vec3d v = entity == meeting.small ? Vec3d{0.3, -0.5, -0.4} : Vec3d{0, 0.1, 0.2};
    const Vec3d w = entity == meeting.small ? Vec3d{1, 2, -3} : Vec3d{-1, 0.5, 2};
    const double radius = entity == meeting.small ? 0.05 : 0.12;
    before += 0.5 * m * dot(v, v) + 0.5 * 0.4 * m * radius * radius * dot(w, w);
  }
  meeting.rig.run(0.4);
  for (Entity* entity : {meeting.small, meeting.big}) after += test::kinetic_energy(*entity);
  EXPECT_LT(after, before);
  EXPECT_GT(after, 0.2 * before);
}

}  // namespace
}  // namespace murosimf::collision
