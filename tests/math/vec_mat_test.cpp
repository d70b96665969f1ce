#include <gtest/gtest.h>

#include "murosimf/math/spatial.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::Dice;
using fixtures::difference;

/// m[row][column], by the meaning of "columns": independent of the operators under test.
double entry(const Mat3d& m, int row, int column) {
  const Vec3d& c = column == 0 ? m.x : column == 1 ? m.y : m.z;
  return row == 0 ? c.x : row == 1 ? c.y : c.z;
}
double entry(const Vec3d& v, int row) { return row == 0 ? v.x : row == 1 ? v.y : v.z; }

Mat3d random_matrix(Dice& dice) { return {dice.vector(1), dice.vector(1), dice.vector(1)}; }
SymMat3d random_symmetric(Dice& dice) {
  const Vec3d a = dice.vector(1), b = dice.vector(1);
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}

// Law: cross product by its definition on the axes (right-handed), and its identities. Tolerance: three products of
// numbers up to 1, so a few 1e-16.
TEST(VecMat, CrossProduct) {
  EXPECT_EQ(difference(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), {0, 0, 1}), 0);
  EXPECT_EQ(difference(cross(Vec3d{0, 1, 0}, Vec3d{0, 0, 1}), {1, 0, 0}), 0);
  EXPECT_EQ(difference(cross(Vec3d{0, 0, 1}, Vec3d{1, 0, 0}), {0, 1, 0}), 0);
  Dice dice("cross product");
  for (int i = 0; i < 200; ++i) {
    const Vec3d a = dice.vector(1), b = dice.vector(1), c = dice.vector(1);
    EXPECT_NEAR(dot(cross(a, b), a), 0, 1e-15);
    EXPECT_NEAR(dot(cross(a, b), c), dot(a, cross(b, c)), 2e-15);
    EXPECT_NEAR(dot(cross(a, b), cross(a, b)), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 4e-15);
    EXPECT_LT(difference(cross_matrix(a) * b, cross(a, b)), 1e-15);
  }
}

// Law: sums, scaling, length, and the tangential part (orthogonal to n, and the rest is parallel). Tolerance: rounding.
TEST(VecMat, Vectors) {
  const Vec3d a{1, 2, 3}, b{10, 20, 30};
  EXPECT_EQ(difference(a + b, {11, 22, 33}), 0);
  EXPECT_EQ(difference(b - a, {9, 18, 27}), 0);
  EXPECT_EQ(difference(-a, {-1, -2, -3}), 0);
  EXPECT_EQ(difference(2.0 * a, {2, 4, 6}), 0);
  EXPECT_EQ(norm(Vec3d{2, 3, 6}), 7);
  Vec3d sum = a;
  sum += b;
  sum -= a;
  EXPECT_EQ(difference(sum, b), 0);
  Dice dice("tangential");
  for (int i = 0; i < 100; ++i) {
    const Vec3d v = dice.vector(1), n = dice.unit(), t = tangential(v, n);
    EXPECT_NEAR(dot(t, n), 0, 1e-15);
    EXPECT_LT(norm(cross(v - t, n)), 1e-15);
  }
}

// Law: products of matrices and vectors by row and column. Tolerance: rounding of three products up to 1.
TEST(VecMat, MatrixProducts) {
  Dice dice("matrix products");
  for (int i = 0; i < 100; ++i) {
    const Mat3d m = random_matrix(dice), n = random_matrix(dice);
    const Vec3d v = dice.vector(1);
    const Mat3d mn = m * n, mt = transpose(m);
    const Vec3d mv = m * v, mtv = transposed_times(m, v);
    for (int r = 0; r < 3; ++r) {
      double by_vector = 0, by_transposed = 0;
      for (int k = 0; k < 3; ++k) {
        by_vector += entry(m, r, k) * entry(v, k);
        by_transposed += entry(m, k, r) * entry(v, k);
      }
      EXPECT_NEAR(entry(mv, r), by_vector, 1e-15);
      EXPECT_NEAR(entry(mtv, r), by_transposed, 1e-15);
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += entry(m, r, k) * entry(n, k, c);
        EXPECT_NEAR(entry(mn, r, c), sum, 1e-15);
        EXPECT_EQ(entry(mt, r, c), entry(m, c, r));
      }
    }
  }
}

// Law: a rotation is orthonormal with determinant +1, keeps its axis, turns any vector across it by its angle, and
// turns about one axis add up. Tolerance: Rodrigues' formula has about five roundings of numbers up to 1, and the
// axis is unit to 2e-16.
TEST(VecMat, RotationsAreRotations) {
  Dice dice("rotations");
  for (int i = 0; i < 500; ++i) {
    const Vec3d axis = dice.unit();
    const double angle = dice.uniform(-7, 7), more = dice.uniform(-7, 7);
    const Mat3d R = rotation(axis, angle);
    EXPECT_LT(difference(transpose(R) * R, Mat3d{}), 2e-15);
    EXPECT_NEAR(dot(cross(R.x, R.y), R.z), 1, 2e-15);
    EXPECT_LT(difference(R * axis, axis), 1e-15);
    const Vec3d across = cross(axis, dice.unit());
    EXPECT_NEAR(dot(across, R * across), std::cos(angle) * dot(across, across), 2e-15);
    EXPECT_NEAR(dot(cross(across, R * across), axis), std::sin(angle) * dot(across, across), 2e-15);
    EXPECT_LT(difference(R * rotation(axis, more), rotation(axis, angle + more)), 3e-15);
  }
}

// Rule: right-handed, columns are the new axes: a quarter turn about z takes x to y, about x y to z, about y z to x.
// Tolerance: cos(pi/2) in doubles is 6e-17.
TEST(VecMat, QuarterTurns) {
  EXPECT_LT(difference(rotation_z(pi / 2).x, {0, 1, 0}), 1e-16);
  EXPECT_LT(difference(rotation_x(pi / 2).y, {0, 0, 1}), 1e-16);
  EXPECT_LT(difference(rotation_y(pi / 2).z, {1, 0, 0}), 1e-16);
}

// Law: heading is the angle of the turn about the vertical, also with a little roll about the own x axis, which does
// not move it. Tolerance: rounding of the products and of atan2.
TEST(VecMat, Heading) {
  for (const double angle : {-3.1, -1.0, 0.0, 0.7, 2.5}) {
    EXPECT_NEAR(heading(rotation_z(angle)), angle, 1e-15);
    EXPECT_NEAR(heading(rotation_z(angle) * rotation_y(0.3) * rotation_x(0.2)), angle, 1e-15);
  }
}

// Law: a triangle acts like the symmetric matrix that it stands for. Tolerance: rounding; same order gives equality.
TEST(VecMat, SymmetricMatrices) {
  Dice dice("symmetric matrices");
  for (int i = 0; i < 100; ++i) {
    const SymMat3d m = random_symmetric(dice), n = random_symmetric(dice);
    const Vec3d v = dice.vector(1);
    EXPECT_LT(difference(m * v, full(m) * v), 1e-15);
    EXPECT_LT(difference((m + n) * v, m * v + n * v), 2e-15);
    EXPECT_LT(difference((m - n) * v, m * v - n * v), 2e-15);
    EXPECT_LT(difference((2.5 * m) * v, 2.5 * (m * v)), 2e-15);
    EXPECT_LT(difference(diagonal(3.0) * v, 3.0 * v), 1e-15);
    SymMat3d sum = m;
    sum += n;
    EXPECT_EQ(difference(sum, m + n), 0);
    const Vec3d a = dice.vector(1);
    EXPECT_LT(difference(outer(a) * v, dot(a, v) * a), 1e-15);
    EXPECT_LT(difference(inertia_of_point(a) * v, cross(a, cross(v, a))), 2e-15);
  }
}

// Law: rotated(R, m) = R m R^T; its trace stays. Tolerance: two products of 3x3 matrices with entries up to 1.
TEST(VecMat, RotatedTensor) {
  Dice dice("rotated tensor");
  for (int i = 0; i < 200; ++i) {
    const SymMat3d m = random_symmetric(dice);
    const Mat3d R = dice.turn();
    const SymMat3d turned = rotated(R, m);
    EXPECT_LT(difference(full(turned), R * full(m) * transpose(R)), 2e-15);
    EXPECT_NEAR(turned.xx + turned.yy + turned.zz, m.xx + m.yy + m.zz, 3e-15);
  }
}

}  // namespace
}  // namespace murosimf
