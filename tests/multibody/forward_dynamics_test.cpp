// Inverse and forward dynamics against each other, and against momentum from kinematics alone.
#include <algorithm>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/inverse_dynamics.h"
#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"
#include "tests/law.h"

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

  /// ABA with everything in it, and a damping on one link; the result stands in `bodies`.
  void forward(std::size_t damped = 0, const Sym6d& damping = {}) {
    clear_loads<double>(bodies);
    add_load(bodies[damped], Wrenchd{}, damping);
    for (std::size_t l = 0; l < links.size(); ++l) {
      add_load(bodies[l], external[l], Sym6d{});
      bodies[l].torque = torque[l];
      bodies[l].added_inertia = rotor[l];
    }
    sweep_to_base<double>(tree, links, bodies);
    accelerate<double>(tree, links, bodies, solve(bodies[0].inertia, -1.0 * bodies[0].force));
  }

  [[nodiscard]] std::vector<double> joint_accelerations() const {
    std::vector<double> result(links.size());
    for (std::size_t l = 1; l < result.size(); ++l) result[l] = bodies[l].joint_acceleration;
    return result;
  }

  struct Inverse {
    std::vector<Wrenchd> force;
    std::vector<double> torque;
  };
  [[nodiscard]] Inverse inverse(const Twistd& base, const std::vector<double>& joint_acceleration) const {
    Inverse result{std::vector<Wrenchd>(links.size()), std::vector<double>(links.size())};
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
    const Wrenchd& base = result.force[0];
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
  std::vector<Wrenchd> external;
  std::vector<double> torque, rotor, qdd;
};

/// The largest error(case) in 200 states: 5 of each of 40 random trees.
template <class Error>
law::Worst worst_case(const Error& error) {
  law::Worst worst;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Model model = fixtures::random_model(seed);
    for (std::uint64_t state = 1; state <= 5; ++state) {
      SCOPED_TRACE(::testing::Message() << "model " << seed << ", state " << state);
      Case c(model, 100 * seed + state);
      worst.see(error(c), "tree", seed, "state", state);
    }
  }
  return worst;
}

/// One row about the kernels of forward and inverse dynamics.
void expect_kernel(const std::string& level, const std::string& law, const std::string& source,
                   const law::Measured& error, double limit) {
  law::expect_below({.law = "random trees: " + law, .level = level, .source = source}, error, limit, "");
}

/// Larger part of the difference of two spatial vectors.
double difference(const Twistd& a, const Twistd& b) {
  return fixtures::largest(fixtures::difference(a.w, b.w), fixtures::difference(a.v, b.v));
}
double difference(const Wrenchd& a, const Wrenchd& b) {
  return fixtures::largest(fixtures::difference(a.n, b.n), fixtures::difference(a.f, b.f));
}

// Tolerance: rounding, with badly conditioned trees among the 40; relative to the largest force.
TEST(ForwardDynamics, InverseDynamicsGivesTheTorquesBack) {
  const auto error = [](Case& c) {
    c.forward();
    const std::vector<double> qdd = c.joint_accelerations();
    const auto back = c.inverse(c.bodies[0].acceleration, qdd);
    double scale = 1, worst = difference(back.force[0], Wrenchd{});
    for (const Wrenchd& f : back.force) scale = std::max({scale, norm(f.f), norm(f.n)});
    for (std::size_t l = 1; l < qdd.size(); ++l) {
      worst = fixtures::largest(worst, std::abs(back.torque[l] + c.rotor[l] * qdd[l] - c.torque[l]));
    }
    return worst / scale;
  };
  expect_kernel("articulated bodies", "relative error of the torques that the accelerations take",
                "inverse dynamics gives the torques back, and no force at the base", worst_case(error), 1e-10);
}

// Inverse dynamics is linear in the accelerations. Tolerance: rounding.
TEST(ForwardDynamics, MassMatrixIsTheDerivativeOfInverseDynamics) {
  const auto error = [](Case& c) {
    const Matrix M = c.mass();
    EXPECT_LT((M - M.transpose()).norm(), 1e-15 * M.norm());
    const Vector bias = c.forces(Vector::Zero(c.size()));
    double worst = 0;
    for (int k = 0; k < c.size(); ++k) {
      const Vector column = c.forces(Vector::Unit(c.size(), k)) - bias;
      worst = fixtures::largest(worst, (column - M.col(k)).norm() / M.norm());
    }
    return worst;
  };
  expect_kernel("mass matrix", "relative error of its columns", "derivative of inverse dynamics", worst_case(error),
                1e-10);
}

// Cholesky shows at the same time that the matrix, with rotors on its diagonal, is positive definite.
TEST(ForwardDynamics, EqualsTheSolutionWithTheMassMatrix) {
  const auto error = [](Case& c) {
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
    EXPECT_EQ(factor.info(), Eigen::Success);
    const Vector a = factor.solve(torque - c.forces(Vector::Zero(c.size())));
    double worst = difference(c.bodies[0].acceleration, {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}});
    for (std::size_t l = 1; l < c.links.size(); ++l) {
      worst = fixtures::largest(worst, std::abs(c.bodies[l].joint_acceleration - a[5 + static_cast<int>(l)]));
    }
    return worst / a.norm();
  };
  expect_kernel("articulated bodies", "relative error of the accelerations",
                "Cholesky factorization of the mass matrix", worst_case(error), 1e-10);
}

// The joint accelerations are those that forward dynamics finds.
TEST(ForwardDynamics, PrescribedJointsGiveTheSameBase) {
  const auto error = [](Case& c) {
    c.forward();
    std::vector<Twistd> working(c.links.size());
    Wrenchd force = -1.0 * base_bias<double>(c.tree, c.links, c.joint_accelerations(), working);
    for (const Wrenchd& f : c.external) force += f;
    const Twistd base = solve(to_sym6(composite_inertia<double>(c.links)), force);
    const Twistd& expected = c.bodies[0].acceleration;
    return difference(base, expected) / (1 + norm(expected.w) + norm(expected.v));
  };
  expect_kernel("eq. (3)", "relative error of the base's acceleration, joints prescribed",
                "articulated bodies with the same joint accelerations", worst_case(error), 1e-10);
}

// A body's force f - h B a. Tolerance: ten times that of the others; the damping is stiff.
TEST(ForwardDynamics, AddedDampingIsAForceThatFollowsTheAcceleration) {
  const auto error = [](Case& c) {
    Dice dice("damping", static_cast<std::uint64_t>(1e6 * std::abs(c.torque.back())));
    const std::size_t l = c.links.size() - 1;
    const Sym6d damping = at_point(SymMat3d{3, 2, 1, 0.5, 0.2, 0.1}, dice.vector(0.3));
    c.external.assign(c.links.size(), Wrenchd{});
    c.forward(l, damping);
    const Twistd base = c.bodies[0].acceleration;
    const auto joints = c.joint_accelerations();
    c.external[l] = -1.0 * (damping * c.bodies[l].acceleration);
    c.forward();
    double worst = difference(base, c.bodies[0].acceleration) / (1 + norm(base.w) + norm(base.v));
    const auto expected = c.joint_accelerations();
    for (std::size_t i = 1; i < joints.size(); ++i) {
      worst = std::fmax(worst, std::abs(joints[i] - expected[i]) / (1 + std::abs(expected[i])));
    }
    return worst;
  };
  expect_kernel("articulated bodies", "relative error of all accelerations, one body damped",
                "the constant force that results", worst_case(error), 1e-9);
}

/// Momentum about the base's origin from poses and velocities of the links, by sums of point masses and inertias.
Wrenchd momentum_by_sums(const Model& model, const State<double>& s) {
  Wrenchd sum;
  for (const Link& link : model.tree().links) {
    const int i = link.object;
    const Vec3d c = s.r[i] + s.R[i] * link.com;
    const Vec3d p = link.mass * (s.v[i] + cross(s.w[i], c - s.r[i]));
    sum += Wrenchd{cross(c - s.r[0], p) + rotated(s.R[i], link.inertia) * s.w[i], p};
  }
  return sum;
}

// Tolerance: rounding.
TEST(LinkMotion, MomentumIsTheSumOverTheBodies) {
  const auto error = [](Case& c) {
    State<double>& s = c.state;
    s.v[0] = {};
    velocities<double>(c.tree, s.qd, s.r, s.R, s.v, s.w);
    const Wrenchd sums = momentum_by_sums(c.model, s);
    return difference(momentum<double>(c.links), sums) / (1 + norm(sums.n) + norm(sums.f));
  };
  expect_kernel("link motion", "relative error of the momentum", "sum over the bodies", worst_case(error), 1e-12);
}

// The base here turns uniformly and its origin rests, the joints run uniformly; the rate is a central difference over
// 2 * 0.1 ms (error of the order of 1e-8 of the third derivative).
TEST(LinkMotion, BiasForceIsTheRateOfMomentum) {
  constexpr double h = 1e-4;
  const auto error = [](Case& c) {
    State<double>& s = c.state;
    s.v[0] = {};
    Wrenchd change;
    for (const double sign : {-1.0, 1.0}) {
      State<double> t = s;
      for (const int i : c.model.joints()) t.q[i] += sign * h * t.qd[i];
      t.R[0] = to_matrix(exponential(sign * h * s.w[0])) * s.R[0];
      poses<double>(c.tree, t.q, t.r, t.R);
      velocities<double>(c.tree, t.qd, t.r, t.R, t.v, t.w);
      change += (sign / (2 * h)) * momentum_by_sums(c.model, t);
    }
    std::vector<Twistd> working(c.links.size());
    const Wrenchd bias = base_bias<double>(c.tree, c.links, std::vector<double>(c.links.size()), working);
    return difference(bias, change) / (1 + norm(change.n) + norm(change.f));
  };
  expect_kernel("link motion", "relative error of the force at a base that moves uniformly",
                "central differences of the momentum", worst_case(error), 1e-4);
}

// For a moving base it gains P v0 + m v0^2 / 2. Tolerance: rounding.
TEST(LinkMotion, KineticEnergyIsTheQuadraticFormOfTheMassMatrix) {
  const auto error = [](Case& c) {
    Vector v(c.size());
    const State<double>& s = c.state;
    v.head<6>() << s.w[0].x, s.w[0].y, s.w[0].z, s.v[0].x, s.v[0].y, s.v[0].z;
    for (std::size_t l = 1; l < c.links.size(); ++l) v[5 + static_cast<int>(l)] = s.qd[c.tree.links[l].object];
    const double expected = 0.5 * v.dot(c.mass() * v);
    return std::abs(kinetic_energy<double>(c.links, s.v[0]) / expected - 1);
  };
  expect_kernel("link motion", "relative error of the kinetic energy", "v M v / 2", worst_case(error), 1e-12);
}

TEST(LinkMotion, PotentialEnergyIsTheSumOverTheBodies) {
  const auto error = [](Case& c) {
    const State<double>& s = c.state;
    double potential = 0;
    for (const Link& link : c.tree.links) {
      potential += 9.81 * link.mass * (s.r[link.object] + s.R[link.object] * link.com).z;
    }
    return std::abs(potential_energy<double>(c.links, s.r[0], {0, 0, -9.81}) - potential);
  };
  law::expect_below({.law = "random trees: error of the potential energy",
                     .level = "link motion",
                     .source = "sum of m g z over the bodies"},
                    worst_case(error), 1e-10, "J");
}

}  // namespace
}  // namespace murosimf::multibody
