// One rigid body that turns without forces: Euler's equations.
#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// A level with or without momentum correction (levels with links only), and by how much angular momentum and energy of
/// a free body may change in 10 s.
struct Spinner {
  std::string level;
  bool correction;
  double momentum, energy;
  double interval;  // [1] by how much the time between flips may be off
};
std::string words_of(const Spinner& s) {
  const bool links = s.level != "simplified_dynamics";
  return s.level + (links && !s.correction ? ", without momentum correction" : "");
}
std::string name_of(const testing::TestParamInfo<Spinner>& info) {
  return info.param.level + (info.param.correction ? "_corrected" : "");
}
void PrintTo(const Spinner& spinner, std::ostream* stream) { *stream << words_of(spinner); }

class Spin : public testing::TestWithParam<Spinner> {};

// First-order integration may lose 3 % of |L| and 5 % of the energy in 10 s at 10 rad/s, and with them as much of the time
// between flips; with the correction only rounding and, of the energy, the error of the midpoint rule.
INSTANTIATE_TEST_SUITE_P(Levels, Spin,
                         testing::Values(Spinner{"simplified_dynamics", false, 0.03, 0.05, 0.05},
                                         Spinner{"full_dynamics", false, 0.03, 0.05, 0.05},
                                         Spinner{"articulated_dynamics", false, 0.03, 0.05, 0.05},
                                         Spinner{"full_dynamics", true, 1e-12, 1e-5, 1e-4},
                                         Spinner{"articulated_dynamics", true, 1e-12, 1e-5, 1e-4}),
                         name_of);

/// A weightless body with these moments of inertia [kg m^2] that turns with w [rad/s].
struct Turning {
  Turning(const Spinner& spinner, const SymMat3d& inertia, const Vec3d& w) {
    rig.simulation.world().gravity = {};
    auto model = std::make_shared<const Model>(
        "body", Chain{}.base("body").with(properties::mass, 1.0).with(properties::inertia, inertia));
    body = &rig.add("body", model, {.position = {0, 0, 1}});
    rig.attach_dynamics(*body, {.level = spinner.level,
                                .on_ground = false,
                                .tree = {.momentum_correction = spinner.correction}});
    rig.simulation.initialize();
    Rig::launch(*body, {}, w);
  }
  [[nodiscard]] Vec3d angular_momentum() const { return momentum(*body).n; }
  Rig rig;
  Entity* body;
};

constexpr double I1 = 0.1, I2 = 0.2, I3 = 0.3;  // [kg m^2]

/// [s] between two flips of a body with these moments of inertia about x, y, z that turns with w [rad/s]: half a period of
/// Euler's equations, 2 K(k) / p with the complete elliptic integral as an arithmetic-geometric mean. Holds for
/// L^2 > 2 E I2. Landau, Lifshitz, Mechanics, sec. 37.
double time_between_flips(const Vec3d& w) {
  const double twice_energy = I1 * w.x * w.x + I2 * w.y * w.y + I3 * w.z * w.z;
  const double square = I1 * I1 * w.x * w.x + I2 * I2 * w.y * w.y + I3 * I3 * w.z * w.z;
  EXPECT_GT(square, twice_energy * I2);
  const double p = std::sqrt((I3 - I2) * (square - twice_energy * I1) / (I1 * I2 * I3));
  const double k_square = (I2 - I1) * (twice_energy * I3 - square) / ((I3 - I2) * (square - twice_energy * I1));
  double a = 1, b = std::sqrt(1 - k_square);
  for (int i = 0; i < 20; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2 * (pi / (2 * a)) / p;
}

// Euler's equations make a body that turns about its middle axis flip, every so often: where its rate about that axis
// changes its sign.
TEST_P(Spin, MiddleAxisRotationFlipsAsOftenAsEulerSays) {
  const Vec3d start{0.7, 10, 0.5};
  Turning turning(GetParam(), {I1, I2, I3, 0, 0, 0}, start);
  std::vector<double> flips;  // [s]
  double before = start.y;
  for (int i = 1; i <= 10000; ++i) {
    turning.rig.simulation.step();
    const auto base = turning.body->base();
    const double rate = dot(base.get(properties::orientation).y, base.get(properties::angular_velocity));
    if (rate * before < 0) flips.push_back(1e-3 * (i - rate / (rate - before)));
    before = rate;
  }
  ASSERT_GE(flips.size(), 2U);
  const double expected = time_between_flips(start);
  law::expect_near({.law = "Dzhanibekov: time between flips at 10 rad/s about the middle axis, mean of 10 s",
                    .level = words_of(GetParam()),
                    .source = "Euler's equations: elliptic integral"},
                   (flips.back() - flips.front()) / static_cast<double>(flips.size() - 1), expected,
                   GetParam().interval * expected, "s");
}

TEST_P(Spin, MiddleAxisRotationKeepsAngularMomentumAndEnergy) {
  Turning turning(GetParam(), {I1, I2, I3, 0, 0, 0}, {0.01, 10, 0.01});
  const Vec3d L = turning.angular_momentum();
  const double energy = kinetic_energy(*turning.body);
  turning.rig.run(10);
  law::expect_below({.law = "Dzhanibekov: relative change of the angular momentum in 10 s",
                     .level = words_of(GetParam()),
                     .source = "free body: it stays"},
                    norm(turning.angular_momentum() - L) / norm(L), GetParam().momentum, "");
  law::expect_below({.law = "Dzhanibekov: relative change of the energy in 10 s",
                     .level = words_of(GetParam()),
                     .source = "free body: it stays"},
                    std::abs(kinetic_energy(*turning.body) / energy - 1), GetParam().energy, "");
}

// The axis of a symmetric top runs round the angular momentum at |L| / I1, whatever its spin. Tolerance: steps of 1 ms
// are 0.8 % of a radian at 7.6 rad/s.
TEST_P(Spin, SymmetricTopPrecesses) {
  Turning turning(GetParam(), {0.2, 0.2, 0.3, 0, 0, 0}, {1, 0, 5});
  const Vec3d L = turning.angular_momentum();
  const Vec3d up = (1 / norm(L)) * L;
  const Vec3d east{0, 1, 0};  // across it
  const auto azimuth = [&] {
    const Vec3d axis = turning.body->base().get(properties::orientation).z;
    return std::atan2(dot(axis, cross(up, east)), dot(axis, east));
  };
  double turned = 0, before = azimuth();
  for (int i = 0; i < 2000; ++i) {
    turning.rig.simulation.step();
    turned += std::remainder(azimuth() - before, 2 * pi);
    before = azimuth();
  }
  const double expected = norm(L) / 0.2;
  law::expect_near({.law = "symmetric top: rate of its precession, mean of 2 s",
                    .level = words_of(GetParam()),
                    .source = "angular momentum over moment of inertia"},
                   turned / 2, expected, 0.01 * expected, "rad/s");
}

}  // namespace
}  // namespace murosimf::test
