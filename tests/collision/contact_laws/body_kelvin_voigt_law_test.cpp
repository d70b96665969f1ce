#include "murosimf/collision/contact_laws/body_explicit_laws.h"

#include <gtest/gtest.h>

#include "tests/collision/meeting.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using test::Rig;

// f_n = k depth - d v_n, f_t = -min(mu f_n, ct |v_t|) along v_t, at the velocities of the material points.
TEST(BodyKelvinVoigtLaw, ForceIsThatOfItsFormula) {
  for (const Vec3d& v : {Vec3d{0.3, -0.5, -0.4}, {-0.05, 0.09, 0.2}}) {
    Meeting meeting("kelvin_voigt", v);
    const auto r_small = Rig::place(*meeting.small), r_big = Rig::place(*meeting.big);
    meeting.rig.simulation.step();
    ASSERT_EQ(meeting.set().points.size(), 1U);
    const PairContact& c = meeting.set().points[0];
    const ContactParameters& p = meeting.set().parameters[c.surface];
    EXPECT_LT(difference(c.normal, {0.48, 0.6, 0.64}), 1e-12);
    EXPECT_NEAR(c.depth, 1e-3, 1e-12);
    const Vec3d at_small = v + cross(Vec3d{1, 2, -3}, c.point - r_small);
    const Vec3d at_big = Vec3d{0, 0.1, 0.2} + cross(Vec3d{-1, 0.5, 2}, c.point - r_big);
    EXPECT_LT(difference(c.velocity, at_small - at_big), 1e-12);
    const double v_n = dot(c.velocity, c.normal);
    const Vec3d v_t = c.velocity - v_n * c.normal;
    const double f_n = std::max(0.0, p.stiffness * 1e-3 - p.damping * v_n);
    ASSERT_GT(f_n, 0);
    const Vec3d expected =
        f_n * c.normal - (std::min(p.friction * f_n, p.tangent_damping * norm(v_t)) / norm(v_t)) * v_t;
    EXPECT_LT(difference(c.force, expected), 1e-9);
  }
}

}  // namespace
}  // namespace murosimf::collision
