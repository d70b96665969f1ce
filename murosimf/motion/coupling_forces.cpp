#include "murosimf/motion/coupling_forces.h"

#include <algorithm>
#include <cmath>

#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"

namespace murosimf::motion {
namespace {

constexpr double bend = 0.2e-3;          // [rad] under T
constexpr double shift = 0.02e-3;        // [m] under T
constexpr double damping_time = 0.5e-3;  // [s] d / k

double stall_torque(const Model& model, int joint) {
  const Servo* servo = model.find(properties::servo, joint);
  return servo ? servo->stall_torque : 0;
}

double stiffness(const Model& model, const MimicJoints::Pair& pair) {
  const double weight = model.tree().mass * 9.81;
  const bool slider = model.objects()[pair.follower].kind == Kind::prismatic;
  const double servos =
      std::max(stall_torque(model, pair.follower), stall_torque(model, pair.leader) / std::abs(pair.ratio));
  return slider ? std::max(servos, weight) / shift : std::max(servos, 0.1 * weight) / bend;
}

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

CouplingForces::CouplingForces(Setup& setup) : joints_(setup.model()) {
  if (empty()) return;
  const Model& model = setup.model();
  torque_ = setup.write(properties::coupling_torque);
  const auto& link_of = model.tree().link_of;
  for (const auto& pair : joints_.pairs()) {
    rods_.push_back({link_of[pair.follower], link_of[pair.leader], stiffness(model, pair)});
  }
  coordinates_ = 5 + model.tree().links.size();
  rows_.resize(rods_.size() * coordinates_);
  matrix_.resize(rods_.size() * rods_.size());
  change_.resize(rods_.size());
  z_.resize(coordinates_);
}

void CouplingForces::start() noexcept { std::fill(torque_.begin(), torque_.end(), 0.0); }

void CouplingForces::drive(std::span<multibody::FrictionalJoint<double>> joints) const noexcept {
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const auto& pair = joints_.pairs()[i];
    joints[rods_[i].follower].torque += torque_[pair.follower];
    joints[rods_[i].leader].torque -= pair.ratio * torque_[pair.follower];
  }
}

std::span<const double> CouplingForces::solve(const MovingTree& tree,
                                              std::span<const multibody::ArticulatedLink<double>> bodies,
                                              std::span<const double> roots, double h) noexcept {
  h_ = h;
  for (std::size_t i = 0; i < rods_.size(); ++i) fill_row(i, tree, bodies, roots);
  fill_right_side(tree, bodies, h);
  solve_pairs();
  std::fill(z_.begin(), z_.end(), 0.0);
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    for (std::size_t k = 0; k < coordinates_; ++k) z_[k] += change_[i] * rows_[i * coordinates_ + k];
  }
  return z_;
}

void CouplingForces::count_as_drive(std::span<multibody::FrictionalJoint<double>> joints) noexcept {
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const auto& pair = joints_.pairs()[i];
    const double change = change_[i] / h_;
    torque_[pair.follower] += change;
    const auto move = [](multibody::FrictionalJoint<double>& joint, double torque) {
      joint.torque += torque;
      joint.drive += torque;
      joint.load -= torque;
    };
    move(joints[rods_[i].follower], change);
    move(joints[rods_[i].leader], -pair.ratio * change);
  }
}

void CouplingForces::fill_row(std::size_t pair, const MovingTree& tree,
                              std::span<const multibody::ArticulatedLink<double>> bodies,
                              std::span<const double> roots) noexcept {
  const std::span row(rows_.data() + pair * coordinates_, coordinates_);
  std::fill(row.begin(), row.end(), 0.0);
  add_response(rods_[pair].follower, 1, tree, bodies, roots, row);
  add_response(rods_[pair].leader, -joints_.pairs()[pair].ratio, tree, bodies, roots, row);
}

/// Adds what a torque in the joint of a link does: numbers of the joints on the way to the base, then of the base.
void CouplingForces::add_response(int link, double torque, const MovingTree& tree,
                                  std::span<const multibody::ArticulatedLink<double>> bodies,
                                  std::span<const double> roots, std::span<double> row) const noexcept {
  const auto& links = tree.columns.model.tree().links;
  Wrenchd force;  // on link l
  for (int l = link; l > 0; l = links[l].parent) {
    const double along = l == link ? torque : dot(tree.links[l].axis, force);
    row[5 + l] += roots[l] * along;
    force -= (along * bodies[l].inverse_D) * bodies[l].U;
  }
  tree.respond_at_base(force, row);
}

void CouplingForces::fill_right_side(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                                     double h) noexcept {
  const PoseColumns& columns = tree.columns;
  const std::size_t count = rods_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& pair = joints_.pairs()[i];
    const double e = columns.q[pair.follower] - pair.offset - pair.ratio * columns.q[pair.leader];
    const double rate = columns.qd[pair.follower] + h * bodies[rods_[i].follower].joint_acceleration -
                        pair.ratio * (columns.qd[pair.leader] + h * bodies[rods_[i].leader].joint_acceleration);
    const double softness = 1 / (rods_[i].stiffness * h * (h + damping_time));
    change_[i] = -(rate + e / (h + damping_time) + softness * h * torque_[pair.follower]);
    for (std::size_t j = 0; j <= i; ++j) {
      matrix_[i * count + j] =
          product({rows_.data() + i * coordinates_, coordinates_}, {rows_.data() + j * coordinates_, coordinates_});
    }
    matrix_[i * count + i] += softness;
  }
}

/// By Cholesky's factorization.
void CouplingForces::solve_pairs() noexcept {
  const std::size_t count = rods_.size();
  const auto L = [&](std::size_t i, std::size_t j) -> double& { return matrix_[i * count + j]; };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double sum = L(i, j) - product({&L(i, 0), j}, {&L(j, 0), j});
      L(i, j) = i == j ? std::sqrt(sum) : sum / L(j, j);
    }
    change_[i] = (change_[i] - product({&L(i, 0), i}, {change_.data(), i})) / L(i, i);
  }
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t j = i + 1; j < count; ++j) change_[i] -= L(j, i) * change_[j];
    change_[i] /= L(i, i);
  }
}

}  // namespace murosimf::motion
