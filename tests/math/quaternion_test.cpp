#include "murosimf/math/quaternion.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::Dice;
using fixtures::difference;

double length(const Quaterniond& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

/// 0 if both are the same rotation, whatever their signs.
double distance(const Quaterniond& a, const Quaterniond& b) {
  const double same = std::fabs(a.w - b.w) + std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + std::fabs(a.z - b.z);
  const double other = std::fabs(a.w + b.w) + std::fabs(a.x + b.x) + std::fabs(a.y + b.y) + std::fabs(a.z + b.z);
  return std::fmin(same, other);
}

// Law: exponential(phi) is the rotation by |phi| about phi, as Rodrigues' formula says. Tolerance: both are unit to
// a few 1e-16; |phi| up to 7 carries its rounding (4e-16) into the angle.
TEST(Quaternion, ExponentialIsTheRotation) {
  Dice dice("exponential");
  for (int i = 0; i < 500; ++i) {
    const Vec3d axis = dice.unit();
    const double angle = dice.uniform(-7, 7);
    const Quaterniond q = exponential(angle * axis);
    EXPECT_NEAR(length(q), 1, 1e-15);
    EXPECT_LT(difference(to_matrix(q), rotation(axis, angle)), 4e-15);
  }
}

// Law: for tiny angles the quaternion is (1, phi/2) and its logarithm is phi again, also where the series takes over
// (|phi| = 2e-4) and where squares underflow. Tolerance: relative rounding; the cubic term phi^2/24 up to that seam.
TEST(Quaternion, TinyAngles) {
  const Vec3d axis{0.6, 0, 0.8};
  for (const double angle : {0.0, 1e-300, 1e-160, 1e-20, 1e-13, 1e-9, 1e-6, 1.9e-4, 2e-4, 2.1e-4, 1e-3}) {
    const Quaterniond q = exponential(angle * axis);
    EXPECT_NEAR(length(q), 1, 4e-16) << angle;
    EXPECT_NEAR(q.x, 0.3 * angle, 0.3 * angle * (angle * angle / 24 + 4e-16)) << angle;
    const Vec3d phi = rotation_vector(q);
    EXPECT_NEAR(phi.x, 0.6 * angle, 1e-15 * angle) << angle;
    EXPECT_NEAR(phi.z, 0.8 * angle, 1e-15 * angle) << angle;
    EXPECT_EQ(phi.y, 0) << angle;
  }
}

// Law: sin(h)/h has no step where its series takes over. Tolerance: the true change over 2e-12 rad is below 1e-16,
// so what is left is rounding.
TEST(Quaternion, SeamOfTheSeriesHasNoStep) {
  const Quaterniond below = exponential(Vec3d{2e-4 * (1 - 1e-8), 0, 0});
  const Quaterniond above = exponential(Vec3d{2e-4 * (1 + 1e-8), 0, 0});
  EXPECT_NEAR(below.x / (1 - 1e-8), above.x / (1 + 1e-8), 1e-4 * 1e-15);
}

// Law: rotation_vector inverts exponential for |phi| < pi. Tolerance: near pi the angle comes from atan2(1, small),
// which is well conditioned: a few 1e-15 everywhere.
TEST(Quaternion, LogarithmInvertsExponential) {
  Dice dice("logarithm");
  for (int i = 0; i < 1000; ++i) {
    const double angle = i < 500 ? dice.uniform(0, pi) : pi - std::pow(10.0, dice.uniform(-14, -1));
    const Vec3d phi = angle * dice.unit();
    EXPECT_LT(difference(rotation_vector(exponential(phi)), phi), 4e-15);
  }
}

// Rule: |rotation_vector| <= pi: the long way round (w < 0) becomes the short way back. Tolerance: rounding of 2 pi.
TEST(Quaternion, LogarithmTakesTheShortWay) {
  const Vec3d phi = rotation_vector(exponential(Vec3d{0, 0, 2 * pi - 0.5}));
  EXPECT_LT(difference(phi, {0, 0, -0.5}), 2e-15);
  EXPECT_LT(difference(rotation_vector({-1, 0, 0, 0}), {}), 1e-300);
}

// Law: from_matrix inverts to_matrix, up to the sign, with w >= 0, in all four branches of Shepperd's choice and near
// 180 degrees. Tolerance: the largest component is at least 1/2, so dividing by it costs no accuracy.
TEST(Quaternion, MatrixRoundTrip) {
  Dice dice("matrix round trip");
  int largest[4] = {};
  for (int i = 0; i < 2000; ++i) {
    const double angle = i < 1000 ? dice.uniform(0, pi) : pi - std::pow(10.0, dice.uniform(-17, -1));
    const Quaterniond q = exponential(angle * dice.unit());
    const double size[] = {std::fabs(q.w), std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)};
    ++largest[std::max_element(size, size + 4) - size];
    const Quaterniond back = from_matrix(to_matrix(q));
    EXPECT_LT(distance(back, q), 4e-15);
    EXPECT_NEAR(length(back), 1, 4e-16);
    EXPECT_GE(back.w, 0);
  }
  for (const int count : largest) EXPECT_GT(count, 100) << "a branch was not tested";
}

// Law: half turns about the axes, where w is exactly zero.
TEST(Quaternion, HalfTurns) {
  EXPECT_EQ(distance(from_matrix({{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), {0, 1, 0, 0}), 0);
  EXPECT_EQ(distance(from_matrix({{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), {0, 0, 1, 0}), 0);
  EXPECT_EQ(distance(from_matrix({{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}), {0, 0, 0, 1}), 0);
  EXPECT_EQ(distance(from_matrix(Mat3d{}), {1, 0, 0, 0}), 0);
}

// Law: the product of quaternions is the product of rotations, in the same order. Tolerance: rounding of ten products.
TEST(Quaternion, ProductComposes) {
  Dice dice("product");
  for (int i = 0; i < 300; ++i) {
    const Quaterniond a = dice.quaternion(), b = dice.quaternion();
    EXPECT_LT(difference(to_matrix(a * b), to_matrix(a) * to_matrix(b)), 4e-15);
  }
}

// Law: normalized has length one and keeps the direction. Tolerance: rounding.
TEST(Quaternion, Normalized) {
  const Quaterniond q = normalized(Quaterniond{2, -4, 6, 10});
  EXPECT_NEAR(length(q), 1, 4e-16);
  EXPECT_NEAR(q.x / q.w, -2, 1e-15);
  EXPECT_NEAR(q.y / q.w, 3, 1e-15);
  EXPECT_NEAR(q.z / q.w, 5, 2e-15);
}

}  // namespace
}  // namespace murosimf
