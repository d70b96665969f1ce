// Inverse and forward dynamics against each other, and against momentum from kinematics alone.
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::State;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A random tree in a random state with random forces on every link, torques and rotors at every joint.
struct Case {
  Case(const Model& m, std::uint64_t seed) : Case(m, Dice("forward dynamics", seed)) {}
  Case(const Model& m, Dice dice)
      : model(m),
        tree(model.tree()),
        state(fixtures::random_state(model, dice)),
        links(tree.links.size()),
        bodies(links.size()),
        external(links.size()),
        torque(links.size()),
        rotor(links.size()),
        qdd(links.size()) {
    update(state);
    for (std::size_t l = 0; l < links.size(); ++l) {
      external[l] = {dice.vector(1), dice.vector(10)};
      torque[l] = l == 0 ? 0 : dice.uniform(-5, 5);
      rotor[l] = dice.uniform(0.001, 0.02);
      qdd[l] = l == 0 ? 0 : dice.uniform(-20, 20);
    }
  }

  void update(State<double>& s) {
    poses<double>(tree, s.q, s.r, s.R);
    link_motions<double>(tree, s.r, s.R, s.w[0], s.qd, links);
  }

  /// ABA with everything in it; the result stands in `bodies`.
  void forward() {
    clear_loads<double>(bodies);
    for (std::size_t l = 0; l < links.size(); ++l) {
      add_load(bodies[l], external[l], Sym6d{});
      bodies[l].torque = torque[l];
      bodies[l].added_inertia = rotor[l];
    }
    sweep_to_base<double>(tree, links, bodies);
    accelerate<double>(tree, links, bodies, solve(bodies[0].inertia, -1.0 * bodies[0].force));
  }

  struct Inverse {
    std::vector<Forced> force;
    std::vector<double> torque;
  };
  [[nodiscard]] Inverse inverse(const Motiond& base, const std::vector<double>& joint_acceleration) const {
    Inverse result{std::vector<Forced>(links.size()), std::vector<double>(links.size())};
    inverse_dynamics<double>(tree, links, base, joint_acceleration, external, result.force, result.torque);
    return result;
  }
  /// [base force; joint torques without rotors].
  [[nodiscard]] Vector forces(const Vector& acceleration) const {
    std::vector<double> joints(links.size());
    for (std::size_t l = 1; l < links.size(); ++l) joints[l] = acceleration[5 + static_cast<int>(l)];
    const Inverse result = inverse({{acceleration[0], acceleration[1], acceleration[2]},
                                    {acceleration[3], acceleration[4], acceleration[5]}},
                                   joints);
    Vector all(acceleration.size());
    const Forced& base = result.force[0];
    all.head<6>() << base.n.x, base.n.y, base.n.z, base.f.x, base.f.y, base.f.z;
    for (std::size_t l = 1; l < links.size(); ++l) all[5 + static_cast<int>(l)] = result.torque[l];
    return all;
  }
  [[nodiscard]] int size() const { return 5 + static_cast<int>(links.size()); }
  [[nodiscard]] Matrix mass() const {
    Matrix M(size(), size());
    std::vector<RigidInertia<double>> composite(links.size());
    mass_matrix(tree, links, composite, {M.data(), static_cast<std::size_t>(M.size())});
    return M;
  }

  Model model;
  const Tree& tree;
  State<double> state;
  std::vector<LinkMotion<double>> links;
  std::vector<ArticulatedLink<double>> bodies;
  std::vector<Forced> external;
  std::vector<double> torque, rotor, qdd;
};

template <class Check>
void for_cases(const Check& check) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Model model = fixtures::random_model(seed);
    for (std::uint64_t state = 1; state <= 5; ++state) {
      SCOPED_TRACE(::testing::Message() << "model " << seed << ", state " << state);
      Case c(model, 100 * seed + state);
      check(c);
    }
  }
}

// Law: inverse dynamics of the accelerations that forward dynamics finds gives back the torques, and no force
// at the free base. Tolerance: 1e-10 of the largest force.
TEST(ForwardDynamics, InverseDynamicsGivesTheTorquesBack) {
  for_cases([](Case& c) {
    c.forward();
    std::vector<double> qdd(c.links.size());
    for (std::size_t l = 1; l < qdd.size(); ++l) qdd[l] = c.bodies[l].joint_acceleration;
    const auto back = c.inverse(c.bodies[0].acceleration, qdd);
    double scale = 1;
    for (const Forced& f : back.force) scale = std::max({scale, norm(f.f), norm(f.n)});
    EXPECT_LT(norm(back.force[0].f) + norm(back.force[0].n), 1e-10 * scale);
    for (std::size_t l = 1; l < qdd.size(); ++l) {
      EXPECT_NEAR(back.torque[l] + c.rotor[l] * qdd[l], c.torque[l], 1e-10 * scale);
    }
  });
}

// Law: inverse dynamics is linear in the accelerations, with the mass matrix as its derivative.
TEST(ForwardDynamics, MassMatrixIsTheDerivativeOfInverseDynamics) {
  for_cases([](Case& c) {
    const Matrix M = c.mass();
    const Vector bias = c.forces(Vector::Zero(c.size()));
    for (int k = 0; k < c.size(); ++k) {
      const Vector column = c.forces(Vector::Unit(c.size(), k)) - bias;
      EXPECT_LT((column - M.col(k)).norm(), 1e-10 * M.norm());
    }
    EXPECT_LT((M - M.transpose()).norm(), 1e-15 * M.norm());
  });
}

// Law: with rotors on its diagonal the mass matrix is positive definite, and its Cholesky factorization gives the
// same accelerations as the articulated bodies. Tolerance: 1e-10 times the condition that Cholesky sees.
TEST(ForwardDynamics, EqualsTheSolutionWithTheMassMatrix) {
  for_cases([](Case& c) {
    c.forward();
    Matrix M = c.mass();
    Vector torque(c.size());
    torque.head<6>().setZero();
    for (std::size_t l = 1; l < c.links.size(); ++l) {
      const int i = 5 + static_cast<int>(l);
      M(i, i) += c.rotor[l];
      torque[i] = c.torque[l];
    }
    const Eigen::LLT<Matrix> factor(M);
    ASSERT_EQ(factor.info(), Eigen::Success);
    const Vector a = factor.solve(torque - c.forces(Vector::Zero(c.size())));
    const Motiond& base = c.bodies[0].acceleration;
    EXPECT_LT(fixtures::difference(base.v, {a[3], a[4], a[5]}), 1e-10 * a.norm());
    EXPECT_LT(fixtures::difference(base.w, {a[0], a[1], a[2]}), 1e-10 * a.norm());
    for (std::size_t l = 1; l < c.links.size(); ++l) {
      EXPECT_NEAR(c.bodies[l].joint_acceleration, a[5 + static_cast<int>(l)], 1e-10 * a.norm());
    }
  });
}

// Law: eq. (3) of the paper. Given the joint accelerations that forward dynamics finds, composite inertia and
// the force that the joints take of the base give the same base acceleration.
TEST(ForwardDynamics, PrescribedJointsGiveTheSameBase) {
  for_cases([](Case& c) {
    c.forward();
    std::vector<double> qdd(c.links.size());
    for (std::size_t l = 1; l < qdd.size(); ++l) qdd[l] = c.bodies[l].joint_acceleration;
    std::vector<Motiond> working(c.links.size());
    Forced force = -1.0 * base_bias<double>(c.tree, c.links, qdd, working);
    for (const Forced& f : c.external) force += f;
    const Motiond base = solve(to_sym6(composite_inertia<double>(c.links)), force);
    const Motiond& expected = c.bodies[0].acceleration;
    const double scale = 1 + norm(expected.w) + norm(expected.v);
    EXPECT_LT(fixtures::difference(base.w, expected.w), 1e-10 * scale);
    EXPECT_LT(fixtures::difference(base.v, expected.v), 1e-10 * scale);
  });
}

// Law: a body's force f - h B a, linear in its acceleration, equals the constant force that results.
TEST(ForwardDynamics, AddedDampingIsAForceThatFollowsTheAcceleration) {
  for_cases([](Case& c) {
    Dice dice("damping", c.links.size());
    const std::size_t l = c.links.size() - 1;
    Sym6d damping = at_point(SymMat3d{3, 2, 1, 0.5, 0.2, 0.1}, dice.vector(0.3));
    clear_loads<double>(c.bodies);
    add_load(c.bodies[l], Forced{}, damping);
    for (std::size_t i = 0; i < c.links.size(); ++i) {
      c.bodies[i].torque = c.torque[i];
      c.bodies[i].added_inertia = c.rotor[i];
    }
    sweep_to_base<double>(c.tree, c.links, c.bodies);
    accelerate<double>(c.tree, c.links, c.bodies, solve(c.bodies[0].inertia, -1.0 * c.bodies[0].force));
    const Motiond base = c.bodies[0].acceleration;
    std::fill(c.external.begin(), c.external.end(), Forced{});
    c.external[l] = -1.0 * (damping * c.bodies[l].acceleration);
    c.forward();
    const double scale = 1 + norm(base.w) + norm(base.v);
    EXPECT_LT(fixtures::difference(base.w, c.bodies[0].acceleration.w), 1e-9 * scale);
    EXPECT_LT(fixtures::difference(base.v, c.bodies[0].acceleration.v), 1e-9 * scale);
  });
}

/// Momentum about the base's origin from poses and velocities of the links, by sums of point masses and inertias.
Forced momentum_by_sums(const Model& model, const State<double>& s) {
  Forced sum;
  for (const Link& link : model.tree().links) {
    const int i = link.object;
    const Vec3d c = s.r[i] + s.R[i] * link.com;
    const Vec3d p = link.mass * (s.v[i] + cross(s.w[i], c - s.r[i]));
    sum += Forced{cross(c - s.r[0], p) + rotated(s.R[i], link.inertia) * s.w[i], p};
  }
  return sum;
}

// Law: momentum is the sum over the bodies; the force at the base is its rate of change. The base here turns uniformly
// and its origin rests, the joints run uniformly; the rate is a central difference over 2 * 0.1 ms (error of the
// order of 1e-8 of the third derivative).
TEST(LinkMotion, BiasForceIsTheRateOfMomentum) {
  for_cases([](Case& c) {
    State<double>& s = c.state;
    s.v[0] = {};
    velocities<double>(c.tree, s.qd, s.r, s.R, s.v, s.w);
    const Forced now = momentum<double>(c.links);
    const Forced sums = momentum_by_sums(c.model, s);
    const double scale = 1 + norm(sums.n) + norm(sums.f);
    EXPECT_LT(fixtures::difference(now.n, sums.n), 1e-12 * scale);
    EXPECT_LT(fixtures::difference(now.f, sums.f), 1e-12 * scale);

    constexpr double h = 1e-4;
    Forced change;
    for (const double sign : {-1.0, 1.0}) {
      State<double> t = s;
      for (const int i : c.model.joints()) t.q[i] += sign * h * t.qd[i];
      t.R[0] = to_matrix(exponential(sign * h * s.w[0])) * s.R[0];
      poses<double>(c.tree, t.q, t.r, t.R);
      velocities<double>(c.tree, t.qd, t.r, t.R, t.v, t.w);
      change += (sign / (2 * h)) * momentum_by_sums(c.model, t);
    }
    std::vector<Motiond> working(c.links.size());
    const Forced bias = base_bias<double>(c.tree, c.links, std::vector<double>(c.links.size()), working);
    const double size = 1 + norm(change.n) + norm(change.f);
    EXPECT_LT(fixtures::difference(bias.n, change.n), 1e-4 * size);
    EXPECT_LT(fixtures::difference(bias.f, change.f), 1e-4 * size);
  });
}

// Law: kinetic energy is half of momentum times velocity, and for a moving base it gains P v0 + m v0^2 / 2.
TEST(LinkMotion, KineticEnergyIsTheQuadraticFormOfTheMassMatrix) {
  for_cases([](Case& c) {
    Vector v(c.size());
    const State<double>& s = c.state;
    v.head<6>() << s.w[0].x, s.w[0].y, s.w[0].z, s.v[0].x, s.v[0].y, s.v[0].z;
    for (std::size_t l = 1; l < c.links.size(); ++l) v[5 + static_cast<int>(l)] = s.qd[c.tree.links[l].object];
    const double expected = 0.5 * v.dot(c.mass() * v);
    EXPECT_NEAR(kinetic_energy<double>(c.links, s.v[0]), expected, 1e-12 * expected);
    double potential = 0;
    for (const Link& link : c.tree.links) {
      potential += 9.81 * link.mass * (s.r[link.object] + s.R[link.object] * link.com).z;
    }
    EXPECT_NEAR(potential_energy<double>(c.links, s.r[0], {0, 0, -9.81}), potential, 1e-10);
  });
}

}  // namespace
}  // namespace murosimf::multibody
