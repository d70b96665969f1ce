#include "murosimf/motion/coupling_forces.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"

namespace murosimf::motion {
namespace {

constexpr double bend = 0.2e-3;          // [rad] deflection under T; these numbers are explained in the header
constexpr double shift = 0.02e-3;        // [m] deflection under T
constexpr double damping_time = 0.5e-3;  // [s] d / k
constexpr double fastest_shift = 0.5;    // [m/s] rate at which a gap closes at most
constexpr double fastest_turn_back = 5;  // [rad/s]
constexpr double trace_share = 1e-6;     // [1] of the leader's inertia: enough for the factors, too little to be seen

double stall_torque(const Model& model, int joint) {
  const Servo* servo = model.find(properties::servo, joint);
  return servo ? servo->stall_torque : 0;
}

double stiffness(const Model& model, const MimicJoints::Pair& pair) {
  MUROSIMF_ASSERT(pair.ratio != 0);
  const double weight = model.tree().mass * 9.81;
  const bool slider = model.objects()[pair.follower].kind == Kind::prismatic;
  const double servos =
      std::max(stall_torque(model, pair.follower), stall_torque(model, pair.leader) / std::abs(pair.ratio));
  return slider ? std::max(servos, weight) / shift : std::max(servos, 0.1 * weight) / bend;
}

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
  if (!loops_.empty()) loop_force_ = setup.write(properties::loop_force);
  shift_stiffness_ = model.tree().mass * 9.81 / shift;
  turn_stiffness_ = 0.1 * model.tree().mass * 9.81 / bend;
  const auto& link_of = model.tree().link_of;
  for (const auto& pair : joints_.pairs()) {
    rods_.push_back({link_of[pair.follower], link_of[pair.leader], stiffness(model, pair)});
  }
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

void CouplingForces::start() noexcept {
  std::fill(torque_.begin(), torque_.end(), 0.0);
  std::fill(loop_force_.begin(), loop_force_.end(), Wrenchd{});
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

void CouplingForces::count_at_leaders(std::span<double> moved) noexcept {
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    Rod& rod = rods_[i];
    MUROSIMF_ASSERT(static_cast<std::size_t>(rod.leader) < moved.size() &&
                    static_cast<std::size_t>(rod.follower) < moved.size());
    const double leader = moved[rod.leader], ratio = joints_.pairs()[i].ratio;
    if (moved[rod.follower] > least_inertia || !(leader > least_inertia)) continue;
    // seen from the leader, by the square of the ratio
    rod.trace = trace_share * leader / (ratio * ratio);
    moved[rod.follower] = leader;
  }
}

void CouplingForces::drive(std::span<multibody::FrictionalJoint<double>> joints) const noexcept {
  MUROSIMF_ASSERT(joints_.pairs().size() == rods_.size());
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const auto& pair = joints_.pairs()[i];
    joints[rods_[i].follower].torque += torque_[pair.follower];
    joints[rods_[i].follower].inertia += rods_[i].trace;
    joints[rods_[i].leader].torque -= pair.ratio * torque_[pair.follower];
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

void CouplingForces::fill_row(std::size_t pair, const MovingTree& tree,
                              std::span<const multibody::ArticulatedLink<double>> bodies,
                              std::span<const double> roots) noexcept {
  const std::span row(rows_.data() + pair * coordinates_, coordinates_);
  std::fill(row.begin(), row.end(), 0.0);
  add_response(rods_[pair].follower, 1, {}, tree, bodies, roots, row);
  add_response(rods_[pair].leader, -joints_.pairs()[pair].ratio, {}, tree, bodies, roots, row);
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
    const auto& pair = joints_.pairs()[i];
    // implicit Euler of spring and damper: the error at the end of the step, see the header
    const double e = columns.q[pair.follower] - pair.offset - pair.ratio * columns.q[pair.leader];
    const double rate = columns.qd[pair.follower] + h * bodies[rods_[i].follower].joint_acceleration -
                        pair.ratio * (columns.qd[pair.leader] + h * bodies[rods_[i].leader].joint_acceleration);
    const double softness = 1 / (rods_[i].stiffness * h * (h + damping_time));
    change_[i] = -(rate + e / (h + damping_time) + softness * h * torque_[pair.follower]);
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

}  // namespace murosimf::motion
