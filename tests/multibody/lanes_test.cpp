// Rule of all tests here: eight robots stepped in lanes equal the same robots stepped alone, bit for
// bit, in any order of lanes, and a robot whose numbers went bad does not touch its neighbors. No tolerance.
#include <limits>

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/integrate.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::State;

// ---- numbers of a value, in a fixed order: for moving robots into lanes and for comparing them ----

template <class S, class Visit>
void numbers(S& x, const Visit& visit) {
  visit(x);
}
template <class S, class Visit>
void numbers(Vec3<S>& a, const Visit& visit) {
  visit(a.x), visit(a.y), visit(a.z);
}
template <class S, class Visit>
void numbers(Mat3<S>& m, const Visit& visit) {
  numbers(m.x, visit), numbers(m.y, visit), numbers(m.z, visit);
}
template <class S, class Visit>
void numbers(SymMat3<S>& m, const Visit& visit) {
  visit(m.xx), visit(m.yy), visit(m.zz), visit(m.xy), visit(m.xz), visit(m.yz);
}
template <class S, class Visit>
void numbers(Twist<S>& m, const Visit& visit) {
  numbers(m.w, visit), numbers(m.v, visit);
}
template <class S, class Visit>
void numbers(Wrench<S>& f, const Visit& visit) {
  numbers(f.n, visit), numbers(f.f, visit);
}
template <class S, class Visit>
void numbers(Sym6<S>& m, const Visit& visit) {
  numbers(m.J, visit), numbers(m.H, visit), numbers(m.M, visit);
}
/// The mass is the model's, not the robot's.
template <class S, class Visit>
void numbers(RigidInertia<S>& I, const Visit& visit) {
  numbers(I.first, visit), numbers(I.second, visit);
}
template <class S, class Visit>
void numbers(LinkMotion<S>& l, const Visit& visit) {
  numbers(l.axis, visit), numbers(l.velocity, visit), numbers(l.bias, visit);
  numbers(l.inertia, visit), numbers(l.bias_force, visit);
}
template <class S, class Visit>
void numbers(ArticulatedLink<S>& l, const Visit& visit) {
  numbers(l.inertia, visit), numbers(l.force, visit), visit(l.torque), visit(l.added_inertia);
  numbers(l.U, visit), visit(l.inverse_D), visit(l.u), numbers(l.acceleration, visit), visit(l.joint_acceleration);
}
template <class S, class Visit>
void numbers(Transform<S>& p, const Visit& visit) {
  numbers(p.position, visit), numbers(p.orientation, visit);
}
template <class S, class Visit>
void numbers(CommonBody<S>& b, const Visit& visit) {
  numbers(b.center, visit), numbers(b.velocity, visit), numbers(b.inertia, visit);
}
template <class S, class Visit>
void numbers(FreeBody<S>& b, const Visit& visit) {
  numbers(b.position, visit), numbers(b.velocity, visit), numbers(b.rate, visit);
  visit(b.turn.w), visit(b.turn.x), visit(b.turn.y), visit(b.turn.z);
}

/// What the kernels of dynamics take and give besides the robot's state; one row per link.
template <class S>
struct Dynamics {
  explicit Dynamics(std::size_t count)
      : qdd(count),
        external(count),
        damping(count),
        links(count),
        bodies(count),
        force(count),
        torque(count),
        joint_motion(count) {}

  std::vector<S> qdd;
  std::vector<Wrench<S>> external;
  std::vector<Sym6<S>> damping;
  Twist<S> base;
  // results
  std::vector<LinkMotion<S>> links;
  std::vector<ArticulatedLink<S>> bodies;  // torque and added_inertia are given
  std::vector<Wrench<S>> force;
  std::vector<S> torque;
  std::vector<Twist<S>> joint_motion;
  RigidInertia<S> composite;
  Wrench<S> bias, momentum;
  Vec3<S> linear_momentum;
  S kinetic{}, potential{};

  template <class Visit>
  void all(const Visit& visit) {
    const auto rows = [&](auto&... columns) {
      const auto column = [&](auto& x) {
        for (auto& row : x) numbers(row, visit);
      };
      (column(columns), ...);
    };
    rows(qdd, external, damping, links, bodies, force, torque, joint_motion);
    numbers(base, visit), numbers(composite, visit), numbers(bias, visit), numbers(momentum, visit);
    numbers(linear_momentum, visit), visit(kinetic), visit(potential);
  }
};

/// Everything that the kernels take and give.
template <class S>
struct Robot {
  explicit Robot(const Model& model)
      : state(model.size()),
        dynamics(model.tree().links.size()),
        in_base(state.q.size()),
        twist(state.q.size()),
        shifted(state.r) {}

  State<S> state;
  Dynamics<S> dynamics;
  FreeBody<S> body;
  Twist<S> acceleration;
  Vec3<S> shift;
  // results
  std::vector<Transform<S>> in_base;
  std::vector<Twist<S>> twist;
  std::vector<Vec3<S>> shifted;
  CommonBody<S> common;

  template <class Visit>
  void all(const Visit& visit) {
    for (auto& x : state.q) numbers(x, visit);
    for (auto& x : state.qd) numbers(x, visit);
    for (auto& x : state.r) numbers(x, visit);
    for (auto& x : state.R) numbers(x, visit);
    for (auto& x : state.v) numbers(x, visit);
    for (auto& x : state.w) numbers(x, visit);
    for (auto& x : in_base) numbers(x, visit);
    for (auto& x : twist) numbers(x, visit);
    for (auto& x : shifted) numbers(x, visit);
    numbers(body, visit), numbers(acceleration, visit), numbers(shift, visit), numbers(common, visit);
    dynamics.all(visit);
  }
};

std::vector<double> row_of_numbers(Robot<double>& robot) {
  std::vector<double> row;
  robot.all([&](double& x) { row.push_back(x); });
  return row;
}

Dynamics<double> random_dynamics(std::size_t links, Dice& dice) {
  Dynamics<double> d(links);
  d.base = {dice.vector(5), dice.vector(5)};
  for (std::size_t l = 0; l < links; ++l) {
    d.qdd[l] = l == 0 ? 0 : dice.uniform(-20, 20);
    d.external[l] = {dice.vector(1), dice.vector(10)};
    d.damping[l] = at_point(dice.inertia(1), dice.vector(0.3));
    d.bodies[l].torque = dice.uniform(-5, 5);
    d.bodies[l].added_inertia = dice.uniform(0.001, 0.02);
  }
  return d;
}

Robot<double> random_robot(const Model& model, Dice& dice) {
  Robot<double> robot(model);
  robot.state = fixtures::random_state(model, dice);
  robot.body = {dice.vector(1), dice.vector(1), dice.quaternion(), dice.vector(5)};
  robot.acceleration = {dice.vector(20), dice.vector(20)};
  robot.shift = dice.vector(1);
  robot.dynamics = random_dynamics(model.tree().links.size(), dice);
  return robot;
}

std::vector<int> path_to(const Tree& tree, int link) {
  std::vector<int> path;
  for (int l = link; l > 0; l = tree.links[l].parent) path.insert(path.begin(), l);
  return path;
}

template <class S>
void run_inverse_dynamics(const Tree& tree, const State<S>& s, Dynamics<S>& d) {
  const std::span<const LinkMotion<S>> links(d.links);
  d.composite = composite_inertia<S>(links);
  d.momentum = momentum<S>(links);
  d.linear_momentum = linear_momentum<S>(links);
  d.kinetic = kinetic_energy<S>(links, s.v[0]);
  d.potential = potential_energy<S>(links, s.r[0], {0, 0, -9.81});
  inverse_dynamics<S>(tree, links, d.base, d.qdd, d.external, d.force, d.torque);
  d.bias = base_bias<S>(tree, links, d.qdd, d.joint_motion);
}

/// Loads on every other link; the others show what a link without loads does.
template <class S>
void run_forward_dynamics(const Tree& tree, Dynamics<S>& d) {
  clear_loads<S>(d.bodies);
  for (std::size_t l = 0; l < d.bodies.size(); l += 2) add_load(d.bodies[l], d.external[l], d.damping[l]);
  sweep_to_base<S>(tree, d.links, d.bodies);
  accelerate<S>(tree, d.links, d.bodies, solve(d.bodies[0].inertia, -1.0 * d.bodies[0].force));
}

/// Every kernel of the folder once (mass_matrix, which has no lanes, excepted), the free body for a hundred steps.
template <class S>
void run_kernels(const Model& model, Robot<S>& robot) {
  const Tree& tree = model.tree();
  State<S>& s = robot.state;
  const std::span<const S> q(s.q), qd(s.qd);
  const std::span<const Vec3<S>> r(s.r), v(s.v), w(s.w);
  const std::span<const Mat3<S>> R(s.R);
  poses<S>(tree, q, s.r, s.R);
  velocities<S>(tree, qd, r, R, s.v, s.w);
  for (int i = 0; i < model.size(); ++i) {
    const std::vector<int> path = path_to(tree, tree.link_of[i]);
    robot.in_base[i] = pose_in_base<S>(tree, path, model.placement(i), q);
    robot.twist[i] = twist_against_base<S>(tree, path, r[0], qd, r, R);
  }
  robot.common = common_body<S>(tree, r, R, v, w);
  robot.shifted = s.r;
  shift_all<S>(robot.shifted, robot.shift);
  link_motions<S>(tree, r, R, s.w[0], qd, robot.dynamics.links);
  run_inverse_dynamics(tree, s, robot.dynamics);
  run_forward_dynamics(tree, robot.dynamics);
  for (int i = 0; i < 100; ++i) advance<S>(robot.body, robot.acceleration, 1e-3);
}

/// Moves eight robots into lanes; robot i goes to lane order[i].
Robot<Pack8> packed(const Model& model, std::vector<Robot<double>>& robots, const std::array<int, 8>& order) {
  Robot<Pack8> pack(model);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::vector<double> row = row_of_numbers(robots[i]);
    std::size_t n = 0;
    pack.all([&](Pack8& x) { x.set_lane(order[i], row[n++]); });
  }
  return pack;
}

/// 0 if lane and robot have the same bits everywhere; else the number of differences.
int differences(Robot<Pack8>& pack, int lane, Robot<double>& robot) {
  const std::vector<double> row = row_of_numbers(robot);
  std::size_t n = 0;
  int count = 0;
  pack.all([&](Pack8& x) { count += fixtures::same_bits(x.lane(lane), row[n++]) ? 0 : 1; });
  return count;
}

class LanesOf : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  LanesOf() : model_(GetParam() == 0 ? fixtures::two_legged() : fixtures::random_model(GetParam())) {
    Dice dice("lanes", GetParam());
    for (int i = 0; i < 8; ++i) start_.push_back(random_robot(model_, dice));
    alone_ = start_;
    for (Robot<double>& robot : alone_) run_kernels(model_, robot);
  }

  Model model_;
  std::vector<Robot<double>> start_, alone_;  // before and after the kernels
};

constexpr std::array<int, 8> in_order{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> reversed{7, 6, 5, 4, 3, 2, 1, 0};

TEST_P(LanesOf, EqualRobotsAlone) {
  Robot<Pack8> pack = packed(model_, start_, in_order);
  run_kernels(model_, pack);
  law::Worst count;
  for (int i = 0; i < 8; ++i) count.see(differences(pack, i, alone_[i]), "lane", i);
  law::expect_equal({.law = "robots in lanes: numbers that differ from those of the robot alone",
                     .level = "all kernels",
                     .source = "none, bit for bit"},
                    count, 0, "");
}

TEST_P(LanesOf, EqualRobotsAloneInReversedOrder) {
  Robot<Pack8> pack = packed(model_, start_, reversed);
  run_kernels(model_, pack);
  law::Worst count;
  for (int i = 0; i < 8; ++i) count.see(differences(pack, 7 - i, alone_[i]), "robot", i);
  law::expect_equal({.law = "robots in lanes, reversed: numbers that differ from those of the robot alone",
                     .level = "all kernels",
                     .source = "none, bit for bit"},
                    count, 0, "");
}

TEST_P(LanesOf, BadNumbersStayInTheirLane) {
  law::Worst count;
  for (const int bad : {0, 3, 7}) {
    std::vector<Robot<double>> start = start_;
    for (double& q : start[bad].state.q) q = std::nan("");
    start[bad].state.r[0].y = std::nan("");
    start[bad].state.w[0].x = std::numeric_limits<double>::infinity();
    start[bad].body.rate.z = std::nan("");
    Robot<Pack8> pack = packed(model_, start, in_order);
    run_kernels(model_, pack);
    for (int i = 0; i < 8; ++i) {
      if (i == bad) continue;
      count.see(differences(pack, i, alone_[i]), "lane", i, "with NaN in", bad);
    }
    EXPECT_TRUE(std::isnan(pack.common.center.y.lane(bad)));
    EXPECT_TRUE(std::isnan(pack.body.turn.w.lane(bad)));
    EXPECT_TRUE(std::isnan(pack.dynamics.bodies[0].acceleration.v.x.lane(bad)));
  }
  law::expect_equal({.law =
                         "robots in lanes, NaN in one: numbers of the others that differ from those of the robot alone",
                     .level = "all kernels",
                     .source = "none, bit for bit"},
                    count, 0, "");
}

// The check sees the last bit: a robot that starts one bit beside the other does not equal it afterwards.
TEST_P(LanesOf, OneBitIsSeen) {
  std::vector<Robot<double>> start = start_;
  start[2].state.r[0].x = std::nextafter(start[2].state.r[0].x, 10);
  Robot<Pack8> pack = packed(model_, start, in_order);
  run_kernels(model_, pack);
  EXPECT_GT(differences(pack, 2, alone_[2]), 0);
  EXPECT_EQ(differences(pack, 1, alone_[1]), 0);
}

// 0 is the two-legged robot, the others are random trees; in 6 the sign of a model's -0 shows
INSTANTIATE_TEST_SUITE_P(Trees, LanesOf, ::testing::Range<std::uint64_t>(0, 7));

}  // namespace
}  // namespace murosimf::multibody
