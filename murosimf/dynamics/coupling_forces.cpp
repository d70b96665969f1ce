#include "murosimf/dynamics/coupling_forces.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

constexpr double damping_time = 0.5e-3;  // [s] d / k
constexpr double fastest_shift = 0.5;    // [m/s] rate at which a gap closes at most
constexpr double fastest_turn_back = 5;  // [rad/s]
constexpr double far_away = 0.05;        // [m] more than a tendon gives way

double product(std::span<const double> a, std::span<const double> b) {
  MUROSIMF_ASSERT(a.size() == b.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The part of a loop's gap that may close in `time` [s].
double bounded(const multibody::LoopRow& row, double time) {
  MUROSIMF_ASSERT(time > 0);
  const double most = time * (row.is_turn() ? fastest_turn_back : fastest_shift);
  return std::clamp(row.gap, -most, most);
}

}  // namespace

CouplingForces::CouplingForces(Setup& setup)
    : joints_(setup.model()), loops_(setup.model()), followers_(joints_of_loops(setup.model())) {
  if (empty()) return;
  const Model& model = setup.model();
  if (!joints_.empty()) torque_ = setup.write(properties::coupling_torque);
  if (!joints_.ties().empty()) tie_force_ = setup.write(properties::tie_force);
  if (!loops_.empty()) loop_force_ = setup.write(properties::loop_force);
  shift_stiffness_ = model.tree().mass * 9.81 / shift_under_load;
  turn_stiffness_ = 0.1 * model.tree().mass * 9.81 / bend_under_load;
  mass_ = model.tree().mass;
  rods_ = coupling_rods(model, joints_);
  coordinates_ = 5 + model.tree().links.size();
  rows_.resize(size() * coordinates_);
  matrix_.resize(size() * size());
  change_.resize(size());
  z_.resize(coordinates_);
  softness_.resize(size());
  answers_.resize(rows_.size());
  dense_.resize(coordinates_);
  answer_.resize(size());
}

void CouplingForces::assemble(PoseColumns& columns) {
  followers_.assemble(columns.q);
  for (CouplingRod& rod : tendon_rods()) {
    rod.follow(columns.q);
    columns.q[rod.follower.object] = rod.place(columns.q);
  }
}

void CouplingForces::start() noexcept {
  std::fill(torque_.begin(), torque_.end(), 0.0);
  std::fill(tie_force_.begin(), tie_force_.end(), 0.0);
  std::fill(loop_force_.begin(), loop_force_.end(), Wrenchd{});
}

void CouplingForces::take_up(PoseColumns& columns) noexcept {
  for (CouplingRod& rod : tendon_rods()) {
    rod.follow(columns.q);
    rod.weigh(moved_, mass_);
    const double length = rod.place(columns.q);
    if (std::abs(columns.q[rod.follower.object] - length) < far_away) continue;
    double rate = 0;
    for (const CouplingRod::Joint& leader : rod.leaders) rate += leader.share * columns.qd[leader.object];
    columns.q[rod.follower.object] = length;
    columns.qd[rod.follower.object] = rate;
    torque_[rod.follower.object] = 0;
  }
  for (CouplingRod& rod : ties()) rod.follow(columns.q);
}

void CouplingForces::look(const MovingTree& tree) noexcept {
  if (!loops_.empty()) loops_.find(tree.columns.r, tree.columns.R, tree.links);
}

void CouplingForces::add_loads(std::span<multibody::ArticulatedLink<double>> bodies) const noexcept {
  for (const multibody::LoopRow& row : loops_.rows()) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(row.links[0]) < bodies.size() &&
                    static_cast<std::size_t>(row.links[1]) < bodies.size());
    const Wrenchd force = force_of(row) * row.force;
    multibody::add_load(bodies[row.links[0]], -1.0 * force, {});
    multibody::add_load(bodies[row.links[1]], force, {});
  }
}

double& CouplingForces::force_of(const multibody::LoopRow& row) const noexcept {
  MUROSIMF_ASSERT(row.axis >= 0 && row.axis < 6);
  auto& [n, f] = loop_force_[row.object];
  double* const numbers[] = {&f.x, &f.y, &f.z, &n.x, &n.y, &n.z};
  return *numbers[row.axis];
}

void CouplingForces::count_at_leaders(std::span<const double> q, std::span<double> moved) {
  moved_.assign(moved.begin(), moved.end());
  for (CouplingRod& rod : rods_) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(rod.follower.link) < moved.size());
    if (rod.tie) continue;  // between sliders, which have their inertia by now
    rod.follow(q);
    const double mobility = rod.mobility(moved_, mass_);
    if (rod.tendon) rod.taken_along = 1 / mobility;
    if (moved[rod.follower.link] > least_inertia || !(1 / mobility > least_inertia)) continue;
    rod.trace = rod.lightest / mobility;
    moved[rod.follower.link] = moved_[rod.follower.link] = 1 / mobility;
  }
}

void CouplingForces::drive(std::span<multibody::FrictionalJoint<double>> joints) const noexcept {
  for (const CouplingRod& rod : rods_) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(rod.follower.link) < joints.size());
    const double torque = force_of(rod);
    joints[rod.follower.link].torque += torque;
    joints[rod.follower.link].inertia += rod.trace;
    if (rod.taken_along > 0) joints[rod.follower.link].coupled = rod.taken_along;
    for (const CouplingRod::Joint& leader : rod.leaders) joints[leader.link].torque -= leader.share * torque;
  }
}

std::span<const double> CouplingForces::solve(const MovingTree& tree,
                                              std::span<const multibody::ArticulatedLink<double>> bodies,
                                              std::span<const double> roots, double h) noexcept {
  MUROSIMF_ASSERT(h > 0 && roots.size() == bodies.size());
  h_ = h;
  fill_rows(tree, bodies, roots);
  fill_right_side(tree, bodies, h);
  factor();
  solve_factored(change_);
  std::fill(z_.begin(), z_.end(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t k = 0; k < coordinates_; ++k) z_[k] += change_[i] * rows_[i * coordinates_ + k];
  }
  return z_;
}

void CouplingForces::count_as_drive(std::span<multibody::FrictionalJoint<double>> joints) noexcept {
  MUROSIMF_ASSERT(h_ > 0);
  // the change has acted as a load in the accelerations; from now on it is part of the drive, so the sum p stays the same
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const CouplingRod& rod = rods_[i];
    const double change = change_[i] / h_;
    force_of(rod) += change;
    const auto move = [](multibody::FrictionalJoint<double>& joint, double torque) {
      joint.torque += torque;
      joint.drive += torque;
      joint.load -= torque;
    };
    move(joints[rod.follower.link], change);
    for (const CouplingRod::Joint& leader : rod.leaders) move(joints[leader.link], -leader.share * change);
  }
  for (std::size_t i = 0; i < loops_.rows().size(); ++i) force_of(loops_.rows()[i]) += change_[rods_.size() + i] / h_;
}

void CouplingForces::fill_rows(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                               std::span<const double> roots) noexcept {
  for (std::size_t i = 0; i < rods_.size(); ++i) fill_row(i, tree, bodies, roots);
  for (std::size_t i = 0; i < loops_.rows().size(); ++i) {
    const multibody::LoopRow& loop = loops_.rows()[i];
    const std::span row(rows_.data() + (rods_.size() + i) * coordinates_, coordinates_);
    std::fill(row.begin(), row.end(), 0.0);
    add_response(loop.links[0], 0, -1.0 * loop.force, tree, bodies, roots, row);
    add_response(loop.links[1], 0, loop.force, tree, bodies, roots, row);
  }
}

void CouplingForces::fill_row(std::size_t rod, const MovingTree& tree,
                              std::span<const multibody::ArticulatedLink<double>> bodies,
                              std::span<const double> roots) noexcept {
  const std::span row(rows_.data() + rod * coordinates_, coordinates_);
  std::fill(row.begin(), row.end(), 0.0);
  add_response(rods_[rod].follower.link, 1, {}, tree, bodies, roots, row);
  for (const CouplingRod::Joint& leader : rods_[rod].leaders)
    add_response(leader.link, -leader.share, {}, tree, bodies, roots, row);
}

/// Adds the response F^-1 of a torque in a link's joint and a force on the link: the joints on the path to the base, then the base.
void CouplingForces::add_response(int link, double torque, Wrenchd force, const MovingTree& tree,
                                  std::span<const multibody::ArticulatedLink<double>> bodies,
                                  std::span<const double> roots, std::span<double> row) const noexcept {
  const auto& links = tree.columns.model.tree().links;
  for (int l = link; l > 0; l = links[l].parent) {  // force: on link l, reduced joint by joint
    const double along = dot(tree.links[l].axis, force) + (l == link ? torque : 0);
    row[5 + l] += roots[l] * along;
    force -= (along * bodies[l].inverse_D) * bodies[l].U;
  }
  tree.respond_at_base(force, row);
}

void CouplingForces::fill_right_side(const MovingTree& tree, std::span<const multibody::ArticulatedLink<double>> bodies,
                                     double h) noexcept {
  MUROSIMF_ASSERT(h > 0);
  const PoseColumns& columns = tree.columns;
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const CouplingRod& rod = rods_[i];
    const auto next_rate = [&](const CouplingRod::Joint& joint) {
      return columns.qd[joint.object] + h * bodies[joint.link].joint_acceleration;
    };
    // implicit Euler of spring and damper: the error at the end of the step, see the header
    double e = columns.q[rod.follower.object] - rod.offset, rate = next_rate(rod.follower);
    for (const CouplingRod::Joint& leader : rod.leaders) {
      e -= leader.share * columns.q[leader.object];
      rate -= leader.share * next_rate(leader);
    }
    const double softness = 1 / (rod.stiffness * h * (h + damping_time));
    const double most = fastest_shift * (h + damping_time);  // a robot may start with tendons that are not tied yet
    if (rod.tie) e = std::clamp(e, -most, most);
    change_[i] = -(rate + e / (h + damping_time) + softness * h * force_of(rod));
    fill_matrix(i, softness);
  }
  for (std::size_t i = 0; i < loops_.rows().size(); ++i) {
    const multibody::LoopRow& loop = loops_.rows()[i];
    const Twistd change = bodies[loop.links[1]].acceleration + -1.0 * bodies[loop.links[0]].acceleration;
    const double rate = loop.rate + h * (dot(change, loop.force) + 0.5 * loop.bias);
    const double softness = 1 / (stiffness_of(loop) * h * (h + damping_time));
    const double gap = bounded(loop, h + damping_time);
    change_[rods_.size() + i] = -(rate + gap / (h + damping_time) + softness * h * force_of(loop));
    fill_matrix(rods_.size() + i, softness);
  }
}

void CouplingForces::fill_matrix(std::size_t i, double softness) noexcept {
  MUROSIMF_ASSERT(i < size() && softness > 0);
  // the lower triangle is all that the factorization reads
  for (std::size_t j = 0; j <= i; ++j) matrix_[i * size() + j] = product(row(i), row(j));
  matrix_[i * size() + i] += softness;
  softness_[i] = softness;
}

/// Replaces A + C by its Cholesky factor.
void CouplingForces::factor() noexcept {
  const std::size_t count = size();
  const auto L = [&](std::size_t i, std::size_t j) -> double& { return matrix_[i * count + j]; };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double sum = L(i, j) - product({&L(i, 0), j}, {&L(j, 0), j});
      L(i, j) = i == j ? std::sqrt(sum) : sum / L(j, j);
    }
  }
}

void CouplingForces::solve_factored(std::span<double> x) const noexcept {
  MUROSIMF_ASSERT(x.size() == size());
  const std::size_t count = size();
  const auto L = [&](std::size_t i, std::size_t j) -> const double& { return matrix_[i * count + j]; };
  for (std::size_t i = 0; i < count; ++i) x[i] = (x[i] - product({&L(i, 0), i}, x.first(i))) / L(i, i);
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t j = i + 1; j < count; ++j) x[i] -= L(j, i) * x[j];
    x[i] /= L(i, i);
  }
}

void CouplingForces::prepare_responses() noexcept {
  for (std::size_t k = 0; k < coordinates_; ++k) {
    // change_ serves as working memory: column k of the matrix of answers
    for (std::size_t i = 0; i < size(); ++i) change_[i] = rows_[i * coordinates_ + k];
    solve_factored(change_);
    for (std::size_t i = 0; i < size(); ++i) answers_[i * coordinates_ + k] = change_[i];
  }
}

void CouplingForces::hold(collision::ResponseRows& y, std::size_t first) const noexcept {
  MUROSIMF_ASSERT(first <= y.index.size() && y.index.size() == y.value.size());
  std::fill(dense_.begin(), dense_.end(), Vec3d{});
  for (std::size_t k = first; k < y.index.size(); ++k) dense_[y.index[k]] = y.value[k];
  y.index.resize(first);
  y.value.resize(first);
  for (std::size_t i = 0; i < size(); ++i) {
    answer_[i] = {};
    for (std::size_t k = 0; k < coordinates_; ++k) answer_[i] += answers_[i * coordinates_ + k] * dense_[k];
    y.add(static_cast<int>(coordinates_ + i), std::sqrt(softness_[i]) * answer_[i]);
  }
  for (std::size_t k = 0; k < coordinates_; ++k) {
    for (std::size_t i = 0; i < size(); ++i) dense_[k] -= rows_[i * coordinates_ + k] * answer_[i];
    // zeros stay out: sweeps of the island solver cost by the number
    if (!is_zero(dense_[k])) y.add(static_cast<int>(k), dense_[k]);
  }
}

std::span<const double> CouplingForces::held(std::span<const double> z) noexcept {
  MUROSIMF_ASSERT(z.size() >= coordinates_ + size());
  std::copy_n(z.begin(), coordinates_, z_.begin());
  for (std::size_t i = 0; i < size(); ++i) {
    const std::span<const double> answer(answers_.data() + i * coordinates_, coordinates_);
    const double taken = product(answer, z.first(coordinates_)), left = std::sqrt(softness_[i]) * z[coordinates_ + i];
    for (std::size_t k = 0; k < coordinates_; ++k) z_[k] += left * answer[k] - taken * row(i)[k];
    change_[i] = -z[coordinates_ + i] / std::sqrt(softness_[i]);
  }
  return z_;
}

}  // namespace murosimf::dynamics
