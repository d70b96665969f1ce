#include "murosimf/math/spatial.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::Dice;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Eigen::Vector3d dense(const Vec3d& v) { return {v.x, v.y, v.z}; }
Eigen::Matrix3d dense(const SymMat3d& m) {
  Eigen::Matrix3d d;
  d << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return d;
}
Matrix6 dense(const Sym6d& a) {
  Eigen::Matrix3d H;
  H.col(0) = dense(a.H.x);
  H.col(1) = dense(a.H.y);
  H.col(2) = dense(a.H.z);
  Matrix6 d;
  d << dense(a.J), H, H.transpose(), dense(a.M);
  return d;
}
Vector6 dense(const Twistd& m) {
  Vector6 d;
  d << dense(m.w), dense(m.v);
  return d;
}
Vector6 dense(const Wrenchd& f) {
  Vector6 d;
  d << dense(f.n), dense(f.f);
  return d;
}
Eigen::Matrix3d skew(const Vec3d& x) {
  Eigen::Matrix3d d;
  d << 0, -x.z, x.y, x.z, 0, -x.x, -x.y, x.x, 0;
  return d;
}

Sym6d from_dense(const Matrix6& d) {
  const auto column = [&](int c) { return Vec3d{d(0, c), d(1, c), d(2, c)}; };
  return {{d(0, 0), d(1, 1), d(2, 2), d(0, 1), d(0, 2), d(1, 2)},
          {column(3), column(4), column(5)},
          {d(3, 3), d(4, 4), d(5, 5), d(3, 4), d(3, 5), d(4, 5)}};
}

/// G G^T + `bottom` * 1: positive definite.
Matrix6 random_definite(Dice& dice, double bottom) {
  Matrix6 G;
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) G(r, c) = dice.uniform(-1, 1);
  }
  return G * G.transpose() + bottom * Matrix6::Identity();
}
SymMat3d random_symmetric(Dice& dice) {
  const Vec3d a = dice.vector(1), b = dice.vector(1);
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
Twistd random_motion(Dice& dice) { return {dice.vector(1), dice.vector(1)}; }
Wrenchd random_force(Dice& dice) { return {dice.vector(1), dice.vector(1)}; }

// Law: [n; f] = [J H; H^T M] [w; v], sums and multiples likewise. Tolerance: six products of numbers up to 6.
TEST(Spatial, ProductWithMotion) {
  Dice dice("product with motion");
  for (int i = 0; i < 100; ++i) {
    const Sym6d a = from_dense(random_definite(dice, 0)), b = from_dense(random_definite(dice, 0));
    const Twistd m = random_motion(dice);
    EXPECT_LT((dense(a * m) - dense(a) * dense(m)).norm(), 1e-14);
    Sym6d sum = a;
    sum += b;
    EXPECT_LT((dense(sum) - dense(a) - dense(b)).norm(), 1e-14);
    EXPECT_LT((dense(3.0 * a) - 3.0 * dense(a)).norm(), 1e-14);
  }
}

// Law: a damper D at the point x gives J^T D J with J = [-x^ 1]: velocity of the point in, force at the reference
// point out. Tolerance: two products of small matrices.
TEST(Spatial, DamperAtAPoint) {
  Dice dice("damper at a point");
  for (int i = 0; i < 200; ++i) {
    const SymMat3d D = random_symmetric(dice);
    const Vec3d x = dice.vector(1);
    Eigen::Matrix<double, 3, 6> J;
    J << -skew(x), Eigen::Matrix3d::Identity();
    EXPECT_LT((dense(at_point(D, x)) - J.transpose() * dense(D) * J).norm(), 1e-14);
    // and by its meaning
    const Twistd m = random_motion(dice);
    const Vec3d f = D * (m.v + cross(m.w, x));
    const Wrenchd force = at_point(D, x) * m;
    EXPECT_LT(fixtures::difference(force.f, f), 3e-15);
    EXPECT_LT(fixtures::difference(force.n, cross(x, f)), 6e-15);
  }
}

// Law: moving the reference point changes the moment by the lever. Tolerance: rounding of one cross product.
TEST(Spatial, MovedForce) {
  Dice dice("moved force");
  for (int i = 0; i < 100; ++i) {
    const Vec3d f = dice.vector(1), at = dice.vector(1), p = dice.vector(1), p_new = dice.vector(1);
    const Wrenchd about_p{cross(at - p, f), f};
    const Wrenchd about_new = moved(about_p, p_new - p);
    EXPECT_LT(fixtures::difference(about_new.n, cross(at - p_new, f)), 2e-15);
    EXPECT_EQ(fixtures::difference(about_new.f, f), 0);
  }
}

// Law: a 6x6 map moved by `o` is X^T A X, where X takes the motion at the new point to that at the old one,
// v_old = v_new + o x w, and the force back. Moving there and back again changes nothing. Tolerance: rounding of
// three products with entries up to 10.
TEST(Spatial, MovedMap) {
  Dice dice("moved map");
  for (int i = 0; i < 200; ++i) {
    const Sym6d a = from_dense(random_definite(dice, 0));
    const Vec3d o = dice.vector(1);
    Matrix6 X = Matrix6::Identity();
    X.bottomLeftCorner<3, 3>() = skew(o);
    EXPECT_LT((dense(moved(a, o)) - X.transpose() * dense(a) * X).norm(), 1e-13);
    EXPECT_LT((dense(moved(moved(a, o), -o)) - dense(a)).norm(), 1e-13);
    // the same motion gives the same force, wherever it is written down
    const Twistd at_new = random_motion(dice);
    const Twistd at_old{at_new.w, at_new.v - cross(at_new.w, o)};
    EXPECT_LT((dense(moved(a, o) * at_new) - dense(moved(a * at_old, o))).norm(), 1e-13);
  }
}

// Law: solve inverts the product, for well and badly conditioned matrices. Tolerance: backward error of a Cholesky
// solution, a few times 6 * 1.1e-16 of |A| |m|; forward against Eigen that times the condition number.
TEST(Spatial, SolveAgainstEigen) {
  Dice dice("solve");
  for (int i = 0; i < 300; ++i) {
    const Matrix6 A = random_definite(dice, std::pow(10.0, -(i % 7)));
    const Wrenchd force = random_force(dice);
    const Twistd m = solve(from_dense(A), force);
    const Vector6 reference = A.ldlt().solve(dense(force));
    const Vector6 eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix6>(A).eigenvalues();
    const double condition = eigenvalues(5) / eigenvalues(0);
    EXPECT_LT((A * dense(m) - dense(force)).norm(), 1e-14 * A.norm() * dense(m).norm());
    EXPECT_LT((dense(m) - reference).norm(), 2e-15 * condition * reference.norm());
  }
}

// Law: the inertia of a body, [I 0; 0 m 1] at its center, inverts to force / mass and I^-1 moment. Tolerance: rounding.
TEST(Spatial, SolveFreeBody) {
  const Sym6d body{{2, 4, 5, 0, 0, 0}, {Vec3d{}, Vec3d{}, Vec3d{}}, diagonal(8.0)};
  const Twistd m = solve(body, Wrenchd{{2, 2, 2}, {4, 8, -8}});
  EXPECT_LT(fixtures::difference(m.w, {1, 0.5, 0.4}), 3e-16);
  EXPECT_LT(fixtures::difference(m.v, {0.5, 1, -1}), 3e-16);
}

}  // namespace
}  // namespace murosimf
