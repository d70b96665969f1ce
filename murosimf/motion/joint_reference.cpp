#include "murosimf/motion/joint_reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "murosimf/model/error.h"
#include "murosimf/motion/motion_properties.h"

namespace murosimf::motion {
namespace {

constexpr ReferenceEntry reference_entries[] = {
    {"filter", "a critically damped filter follows the target", ReferenceKind::filter},
    {"linear", "at constant rate, in one control cycle (paper 4.3)", ReferenceKind::linear},
    {"exact", "the target is the position (paper 4.1, 4.2)", ReferenceKind::exact},
};

}  // namespace

std::span<const ReferenceEntry> joint_references() { return reference_entries; }

JointReference::JointReference(Setup& setup, const JointReferenceOptions& options)
    : options_(options),
      turning_(setup),
      coupled_(setup.model()),
      target_(setup.input(properties::joint_target, 0.0)),
      leader_(target_.size()),
      ratio_(target_.size()) {
  std::iota(leader_.begin(), leader_.end(), 0);
  for (const auto& pair : coupled_.pairs()) {
    leader_[pair.follower] = pair.leader;
    ratio_[pair.follower] = pair.ratio;
  }
  if (options_.kind == ReferenceKind::linear) cycle_target_ = setup.write(properties::cycle_target);
}

void JointReference::initialize(PoseColumns& columns) noexcept {
  for (std::size_t i = 0; i < target_.size(); ++i) {
    columns.q[i] = target(static_cast<int>(i));
    columns.qd[i] = 0;
    if (!cycle_target_.empty()) cycle_target_[i] = target_[i];
  }
  coupled_.follow(columns.q, columns.qd);
}

void JointReference::take_over(const PoseColumns& columns) noexcept {
  // no cycle has begun: the next step begins one for every joint that is not where it should be
  for (std::size_t i = 0; i < cycle_target_.size(); ++i) cycle_target_[i] = columns.q[i];
}

MUROSIMF_INLINE double JointReference::target(int joint) const noexcept {
  const auto& [lowest, highest] = coupled_.range(joint);
  return std::clamp(target_[joint], lowest, highest);
}

void JointReference::stop_at_limits(PoseColumns& columns) const noexcept {
  for (const int i : columns.model.joints()) {
    const auto& [lowest, highest] = coupled_.range(i);
    if (columns.q[i] >= lowest && columns.q[i] <= highest) continue;
    columns.q[i] = std::clamp(columns.q[i], lowest, highest);
    columns.qd[i] = 0;
  }
  coupled_.follow(columns.q, columns.qd);
}

bool JointReference::is_sane(const PoseColumns& columns) const noexcept {
  constexpr double largest = 1e4;  // [rad | m] sines lose their precision far beyond
  double sum = 0;
  for (const int i : columns.model.joints()) sum += std::abs(target_[i]) + std::abs(columns.q[i]);
  for (const int i : turning_.joints()) sum += std::abs(turning_.target(i));
  return sum < largest;  // NaN is not less
}

bool JointReference::advance(PoseColumns& columns, double dt) noexcept {
  if (!is_sane(columns)) return false;
  switch (options_.kind) {
    case ReferenceKind::filter: filter(columns, dt); break;
    case ReferenceKind::linear: linear(columns, dt); break;
    case ReferenceKind::exact: follow_exactly(columns, dt); break;
  }
  turn(columns, dt);
  stop_at_limits(columns);
  return true;
}

double JointReference::acceleration(const PoseColumns& columns, int joint) const noexcept {
  const double wf = options_.filter_frequency;
  const int leader = leader_[joint];
  if (leader != joint) return ratio_[joint] * acceleration(columns, leader);
  if (turning_.contains(joint)) return wf * (turning_.target(joint) - columns.qd[joint]);
  return wf * wf * (target(joint) - columns.q[joint]) - 2 * wf * columns.qd[joint];
}

void JointReference::check(Integrator integrator) const {
  if (integrator == Integrator::rk4 && options_.kind != ReferenceKind::filter) {
    throw SetupError("integrator 'rk4' needs the joint reference 'filter': the others jump from rate to rate");
  }
}

void JointReference::filter(PoseColumns& columns, double dt) const noexcept {
  const double wf = options_.filter_frequency;
  const double inverse = 1.0 / (1 + 2 * wf * dt + wf * wf * dt * dt);
  for (const int i : turning_.others()) {
    double& q = columns.q[i];
    double& qd = columns.qd[i];
    qd += dt * (wf * wf * (target(i) - q - dt * qd) - 2 * wf * qd) * inverse;
    q += dt * qd;
  }
}

void JointReference::follow_exactly(PoseColumns& columns, double dt) const noexcept {
  for (const int i : turning_.others()) {
    const double goal = target(i);
    columns.qd[i] = (goal - columns.q[i]) / dt;
    columns.q[i] = goal;
  }
}

void JointReference::turn(PoseColumns& columns, double dt) const noexcept {
  const double gain = dt * options_.filter_frequency / (1 + options_.filter_frequency * dt);
  for (const int i : turning_.joints()) {
    columns.qd[i] += gain * (turning_.target(i) - columns.qd[i]);
    columns.q[i] += dt * columns.qd[i];
  }
  turning_.wrap(columns.q);
}

void JointReference::linear(PoseColumns& columns, double dt) noexcept {
  for (const int i : turning_.others()) {
    double& q = columns.q[i];
    double& qd = columns.qd[i];
    const double goal = target(i);
    if (goal != cycle_target_[i]) {
      cycle_target_[i] = goal;
      qd = (goal - q) / options_.control_period;
    } else if (q == goal) {
      qd = 0;
    }
    const double rest = goal - q;
    q = std::abs(rest) <= std::abs(qd) * dt * (1 + 1e-9) ? goal : q + dt * qd;
  }
}

}  // namespace murosimf::motion
