// Loads on some links, on all or on none: forward dynamics of random trees, whose torques inverse dynamics gives back.
#include "murosimf/multibody/articulated_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::difference;
using Loaded = std::function<bool(std::size_t)>;  // which links have a load

/// A random tree with torques and rotors at its joints, and forces on those links that have a load.
struct Case {
  Case(std::uint64_t seed, const Loaded& loaded)
      : model(fixtures::random_model(seed)),
        tree(model.tree()),
        dice("articulated body", seed),
        state(fixtures::random_state(model, dice)),
        links(tree.links.size()),
        bodies(links.size()),
        external(links.size()),
        qdd(links.size()) {
    poses<double>(tree, state.q, state.r, state.R);
    link_motions<double>(tree, state.r, state.R, state.w[0], state.qd, links);
    for (auto& body : bodies) {  // nothing of the step before counts
      body.force = {{9, 9, 9}, {9, 9, 9}};
      body.inertia = {{9, 9, 9, 9, 9, 9}, {{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}, {9, 9, 9, 9, 9, 9}};
      body.loaded = true;
    }
    clear_loads<double>(bodies);
    for (std::size_t l = 0; l < links.size(); ++l) {
      bodies[l].torque = dice.uniform(-5, 5);
      bodies[l].added_inertia = dice.uniform(0.001, 0.02);
      if (!loaded(l)) continue;
      const Wrenchd one{dice.vector(1), dice.vector(10)}, other{dice.vector(1), dice.vector(10)};
      add_load(bodies[l], one, Sym6d{});
      add_load(bodies[l], other, Sym6d{});
      external[l] = one + other;
    }
  }
  void forward() {
    sweep_to_base<double>(tree, links, bodies);
    accelerate<double>(tree, links, bodies, solve(bodies[0].inertia, -1.0 * bodies[0].force));
    for (std::size_t l = 1; l < links.size(); ++l) qdd[l] = bodies[l].joint_acceleration;
  }
  /// The largest error of a torque, as a share of the largest force.
  [[nodiscard]] double error() const {
    std::vector<Wrenchd> force(links.size());
    std::vector<double> torque(links.size());
    inverse_dynamics<double>(tree, links, bodies[0].acceleration, qdd, external, force, torque);
    double scale = 1, worst = std::max(norm(force[0].n), norm(force[0].f));
    for (const Wrenchd& f : force) scale = std::max({scale, norm(f.f), norm(f.n)});
    for (std::size_t l = 1; l < links.size(); ++l) {
      const double needed = torque[l] + bodies[l].added_inertia * qdd[l];
      worst = fixtures::largest(worst, std::abs(needed - bodies[l].torque));
    }
    return worst / scale;
  }

  Model model;
  const Tree& tree;
  Dice dice;
  fixtures::State<double> state;
  std::vector<LinkMotion<double>> links;
  std::vector<ArticulatedLink<double>> bodies;
  std::vector<Wrenchd> external;
  std::vector<double> qdd;
};

void expect_torques_back(const Loaded& loaded) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Case c(seed, loaded);
    c.forward();
    EXPECT_LT(c.error(), 1e-10) << "tree " << seed;
  }
}

// Tolerance: rounding, with badly conditioned trees among the 40.
TEST(ArticulatedBody, WithoutLoads) {
  expect_torques_back([](std::size_t) { return false; });
}
TEST(ArticulatedBody, WithLoadsOnAllLinks) {
  expect_torques_back([](std::size_t) { return true; });
}
TEST(ArticulatedBody, WithLoadsOnSomeLinks) {
  for (const std::size_t part : {0U, 1U, 2U}) {
    expect_torques_back([=](std::size_t l) { return l % 3 == part; });
  }
}

// Every body knows its own acceleration: its joint's on top of that of its parent.
TEST(ArticulatedBody, AccelerationsAddUpAlongTheTree) {
  Case c(3, [](std::size_t l) { return l % 2 == 0; });
  c.forward();
  for (std::size_t l = 1; l < c.links.size(); ++l) {
    const Twistd& parent = c.bodies[static_cast<std::size_t>(c.tree.links[l].parent)].acceleration;
    const Twistd& own = c.bodies[l].acceleration;
    EXPECT_LT(difference(own.w, parent.w + c.qdd[l] * c.links[l].axis.w), 1e-9);
    EXPECT_LT(difference(own.v, parent.v + c.qdd[l] * c.links[l].axis.v), 1e-9);
  }
}

// A load's damping is an inertia that feels the acceleration only: here in a joint by itself, on a bolted base.
TEST(ArticulatedBody, DampingOfALoadAddsUp) {
  const Model model("wheel", Chain{}
                                 .base("wall")
                                 .revolute("axle", {0.6, 0, 0.8})
                                 .with(properties::mass, 3.0)
                                 .with(properties::inertia, diagonal(0.02)));
  fixtures::State<double> state(model.size());
  state.R[0] = Mat3d{};
  std::vector<LinkMotion<double>> links(2);
  std::vector<ArticulatedLink<double>> bodies(2);
  poses<double>(model.tree(), state.q, state.r, state.R);
  link_motions<double>(model.tree(), state.r, state.R, state.w[0], state.qd, links);
  clear_loads<double>(bodies);
  Sym6d damping;
  damping.J = diagonal(0.03);
  add_load(bodies[1], Wrenchd{0.5 * Vec3d{0.6, 0, 0.8}, {}}, damping);
  add_load(bodies[1], Wrenchd{}, damping);
  bodies[1].torque = 0.2;
  bodies[1].added_inertia = 0.01;
  sweep_to_base<double>(model.tree(), links, bodies);
  accelerate<double>(model.tree(), links, bodies, {});
  EXPECT_NEAR(bodies[1].joint_acceleration, (0.5 + 0.2) / (0.02 + 0.06 + 0.01), 1e-12);
}

}  // namespace
}  // namespace murosimf::multibody
