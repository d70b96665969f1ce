// What every law owes to points that touch different surfaces: each is treated by the constants of its own.
#include "murosimf/collision/contact_laws/contact_law.h"

#include <gtest/gtest.h>

#include <memory>

#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"
#include "murosimf/collision/contact_laws/paper_law.h"
#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

ContactParameters surface(int number) {
  const double n = number + 1;
  ContactParameters p = parameters();
  p.stiffness *= n;
  p.damping *= 1.5 * n;
  p.tangent_stiffness /= n;
  p.tangent_damping *= 0.5 * n;
  p.friction /= n;
  p.rolling = 0.01 * n;
  return p;
}

/// Points of three bodies with memories of their own, on the surfaces 2, 0 and 1.
LawCase three_points() {
  LawCase set;
  set.terms = {{surface(0), surface(1), surface(2)}, dt};
  Dice dice("three surfaces");
  for (const int number : {2, 0, 1}) {
    ContactPoint& c = set.points.emplace_back();
    c.object = number;
    c.surface = static_cast<std::uint32_t>(number);
    c.feature = set.points.size();
    c.normal = {0, 0, 1};
    c.depth = dice.uniform(1e-3, 2e-3);
    c.radius = 0.05;
    c.velocity = 0.1 * dice.unit();
    c.angular_velocity = dice.vector(3);
    c.stretch = dice.vector(1e-4);
    set.next_velocity.push_back(0.05 * dice.unit());
  }
  return set;
}

void settle(LawCase& set, const ContactLaw& law) {
  set.prepare(law);
  for (int i = 0; i < max_passes && !set.accepted_by(law); ++i) continue;
  set.commit(law);
}

class EveryLaw : public testing::TestWithParam<std::shared_ptr<const ContactLaw>> {};

TEST_P(EveryLaw, PointsHaveTheConstantsOfTheirSurface) {
  LawCase all = three_points();
  settle(all, *GetParam());
  for (std::size_t i = 0; i < 3; ++i) {
    LawCase alone = three_points();
    alone.points = {alone.points[i]};
    alone.next_velocity = {alone.next_velocity[i]};
    alone.terms.parameters = {alone.terms.parameters[alone.points[0].surface]};
    alone.points[0].surface = 0;
    settle(alone, *GetParam());
    const ContactPoint &one = all.points[i], &other = alone.points[0];
    EXPECT_EQ(difference(one.force, other.force), 0) << i;
    EXPECT_EQ(difference(one.moment, other.moment), 0) << i;
    EXPECT_EQ(difference(one.stretch, other.stretch), 0) << i;
    EXPECT_EQ(one.normal_damping, other.normal_damping) << i;
    EXPECT_EQ(one.tangent_damping, other.tangent_damping) << i;
    EXPECT_EQ(one.angular_damping, other.angular_damping) << i;
    EXPECT_EQ(one.state, other.state) << i;
    EXPECT_GT(norm(one.force), 1) << "it presses";
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(std::make_shared<ImplicitStick>(), std::make_shared<KelvinVoigt>(),
                                         std::make_shared<PaperLaw>()));

// A point without a stretched spring that is not pushed has no friction, and sticks.
TEST(KelvinVoigtAtRest, Sticks) {
  LawCase set = one_point(1e-3);
  set.points[0].state = ContactState::slip;
  set.prepare(KelvinVoigt());
  EXPECT_EQ(set.points[0].state, ContactState::stick);
  EXPECT_LT(difference(set.points[0].force, {0, 0, 10}), 1e-14);
  // nor does one on ice that is not pushed: its cone is a line, and nothing is outside
  ContactParameters ice = parameters();
  ice.friction = 0;
  set = one_point(1e-3, {}, ice);
  set.prepare(KelvinVoigt());
  EXPECT_EQ(set.points[0].state, ContactState::stick);
}

}  // namespace
}  // namespace murosimf::collision
