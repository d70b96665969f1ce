// Rows of numbers for integrators: there and back, their rates, and when they have gone bad.
#include "murosimf/dynamics/free_state.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/dynamics/sanity.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;

struct Nothing {
  explicit Nothing(Setup&) {}
};

Chain two_joints() {
  return Chain{}.base("base").revolute("a", {0, 1, 0}).translation({1, 0, 0}).prismatic("b", {1, 0, 0});
}

multibody::FreeBody<double> body() {
  return {{1, 2, 3}, {4, 5, 6}, normalized(Quaterniond{0.5, -0.1, 0.7, 0.2}), {7, 8, 9}};
}

TEST(FreeState, RowsGoThereAndBack) {
  test::Alone<Nothing> robot(two_joints());
  auto& columns = robot.holder.columns;
  const int a = robot.index("a"), b = robot.index("b");
  columns.q[a] = 0.1, columns.qd[a] = 0.2, columns.q[b] = 0.3, columns.qd[b] = 0.4;
  std::vector<double> y{99, 98};
  write_state(body(), columns, y);
  ASSERT_EQ(y.size(), base_numbers + 4);
  columns.q[a] = columns.qd[a] = columns.q[b] = columns.qd[b] = 0;
  const auto back = read_state(y, columns);
  EXPECT_EQ(difference(back.position, body().position), 0);
  EXPECT_EQ(difference(back.velocity, body().velocity), 0);
  EXPECT_EQ(difference(back.rate, body().rate), 0);
  EXPECT_LT(difference(to_matrix(back.turn), to_matrix(body().turn)), 1e-15);
  EXPECT_EQ(columns.q[a], 0.1);
  EXPECT_EQ(columns.qd[a], 0.2);
  EXPECT_EQ(columns.q[b], 0.3);
  EXPECT_EQ(columns.qd[b], 0.4);
}

// The rate of every number against its difference over a short time of a body that moves evenly.
TEST(FreeState, RateIsTheDerivativeOfTheRow) {
  test::Alone<Nothing> robot(two_joints());
  auto& columns = robot.holder.columns;
  const int a = robot.index("a"), b = robot.index("b");
  columns.qd[a] = 0.2, columns.qd[b] = 0.4;
  const Twistd acceleration{{0.3, -0.5, 0.7}, {-1, 2, 0.6}};
  std::vector<double> rate, before, after;
  write_rate(
      body(), acceleration, columns, [&](int joint) { return joint == a ? 5.0 : -6.0; }, rate);
  constexpr double t = 1e-6;
  const auto at = [&](double time, std::vector<double>& y) {
    auto moved = body();
    moved.position += time * moved.velocity;
    moved.velocity += time * acceleration.v;
    moved.turn = exponential(time * moved.rate) * moved.turn;
    moved.rate += time * acceleration.w;
    columns.q[a] = 0.2 * time, columns.qd[a] = 0.2 + 5 * time;
    columns.q[b] = 0.4 * time, columns.qd[b] = 0.4 - 6 * time;
    write_state(moved, columns, y);
  };
  at(-t, before);
  at(t, after);
  ASSERT_EQ(rate.size(), after.size());
  for (std::size_t i = 0; i < rate.size(); ++i) EXPECT_NEAR(rate[i], (after[i] - before[i]) / (2 * t), 1e-7) << i;
}

TEST(FreeState, RowsFarFromAnythingAreNotSane) {
  test::Alone<Nothing> robot(two_joints());
  std::vector<double> good;
  write_state(body(), robot.holder.columns, good);
  EXPECT_TRUE(is_sane_state(good));
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const double bad : {std::nan(""), 1e6, -1e6}) {
      auto y = good;
      y[i] = bad;
      EXPECT_FALSE(is_sane_state(y)) << i;
    }
    auto y = good;
    y[i] = -9999;
    EXPECT_TRUE(is_sane_state(y)) << i;
    y[i] = 1e5;
    EXPECT_EQ(is_sane_state(y), i < 3) << "only places are as far as that";
  }
}

TEST(Sanity, LimitsAreThoseOfTheMessage) {
  const auto moved = [](const Vec3d& r, const Vec3d& v, const Vec3d& w) {
    return is_sane(multibody::FreeBody<double>{r, v, Quaterniond{}, w});
  };
  EXPECT_TRUE(moved({0, -9.9e5, 0}, {}, {}));
  EXPECT_FALSE(moved({0, -8e5, 8e5}, {}, {}));
  EXPECT_TRUE(moved({}, {990, 0, 0}, {}));
  EXPECT_FALSE(moved({}, {0, 0, -1010}, {}));
  EXPECT_TRUE(moved({}, {}, {0, 9.9e3, 0}));
  EXPECT_FALSE(moved({}, {}, {0, 0, -1.01e4}));
  EXPECT_FALSE(moved({}, {std::nan(""), 0, 0}, {}));
  EXPECT_FALSE(is_sane(multibody::FreeBody<double>{{}, {}, {1.01, 0, 0, 0}, {}}));
  EXPECT_FALSE(is_sane(multibody::FreeBody<double>{{}, {}, {0.5, 0.5, 0.5, 0.7}, {}}));
  EXPECT_TRUE(is_sane(multibody::FreeBody<double>{{}, {}, {0.5, -0.5, 0.5, -0.5}, {}}));
  EXPECT_TRUE(is_sane(Twistd{{0, 9e6, 0}, {9e5, 0, 0}}, 1e-3));
  EXPECT_FALSE(is_sane(Twistd{{0, 0, 1.1e7}, {}}, 1e-3));
  EXPECT_FALSE(is_sane(Twistd{{}, {0, -1.1e6, 0}}, 1e-3));
  EXPECT_FALSE(is_sane(Twistd{{}, {0, std::nan(""), 0}}, 1e-3));
}

TEST(CoulombDamping, IsTheFrictionAgainstTheMotion) {
  for (const double rate : {3.0, -0.7, 0.05}) EXPECT_NEAR(coulomb_damping(0.6, rate) * std::abs(rate), 0.6, 1e-15);
  EXPECT_NEAR(coulomb_damping(0.6, -0.01) * 0.01, 0.6 / 5, 1e-15) << "less below 0.05 rad/s";
  EXPECT_EQ(coulomb_damping(0.6, 0), 0.6 / 0.05);
}

}  // namespace
}  // namespace murosimf::dynamics
