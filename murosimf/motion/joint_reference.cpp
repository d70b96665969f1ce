#include "murosimf/motion/joint_reference.h"

#include <cmath>

namespace murosimf::motion {

JointReference::JointReference(Setup& setup, const JointReferenceOptions& options)
    : options_(options), target_(setup.input(properties::joint_target, 0.0)) {
  if (options_.kind == ReferenceKind::linear) cycle_target_ = setup.write(properties::cycle_target);
}

void JointReference::initialize(PoseColumns& columns) noexcept {
  for (std::size_t i = 0; i < target_.size(); ++i) {
    columns.q[i] = target_[i];
    columns.qd[i] = 0;
    if (!cycle_target_.empty()) cycle_target_[i] = target_[i];
  }
}

bool JointReference::advance(PoseColumns& columns, double dt) noexcept {
  constexpr double largest = 1e4;  // [rad | m] sines lose their precision far beyond
  double sum = 0;
  for (const int i : columns.model.joints()) sum += std::abs(target_[i]) + std::abs(columns.q[i]);
  if (!(sum < largest)) return false;  // NaN is not less
  if (options_.kind == ReferenceKind::filter) {
    filter(columns, dt);
  } else {
    linear(columns, dt);
  }
  return true;
}

void JointReference::filter(PoseColumns& columns, double dt) const noexcept {
  const double wf = options_.filter_frequency;
  const double inverse = 1.0 / (1 + 2 * wf * dt + wf * wf * dt * dt);
  for (const int i : columns.model.joints()) {
    double& q = columns.q[i];
    double& qd = columns.qd[i];
    qd += dt * (wf * wf * (target_[i] - q - dt * qd) - 2 * wf * qd) * inverse;
    q += dt * qd;
  }
}

void JointReference::linear(PoseColumns& columns, double dt) noexcept {
  for (const int i : columns.model.joints()) {
    double& q = columns.q[i];
    double& qd = columns.qd[i];
    if (target_[i] != cycle_target_[i]) {
      cycle_target_[i] = target_[i];
      qd = (target_[i] - q) / options_.control_period;
    } else if (q == target_[i]) {
      qd = 0;
    }
    const double rest = target_[i] - q;
    q = std::abs(rest) <= std::abs(qd) * dt * (1 + 1e-9) ? target_[i] : q + dt * qd;
  }
}

}  // namespace murosimf::motion
