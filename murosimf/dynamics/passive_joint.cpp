#include "murosimf/dynamics/passive_joint.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"

namespace murosimf::dynamics {
namespace {

double number(const Model& model, const Property<double>& property, int joint) {
  const double* value = model.find(property, joint);
  /// 0 where the model has no such number.
  return value ? *value : 0;
}

}  // namespace

PassiveJoint passive_joint(const Model& model, int joint) {
  const PassiveJoint passive{number(model, properties::joint_damping, joint),
                             number(model, properties::joint_stiffness, joint),
                             number(model, properties::joint_spring_reference, joint),
                             number(model, properties::joint_spring_slack, joint)};
  if (!(passive.slack >= 0) || !std::isfinite(passive.slack)) {
    throw SetupError(
        fmt::format("model '{}', joint '{}': its spring is slack over {} rad (m); that must be finite and at least 0",
                    model.name(), model.objects()[joint].name, passive.slack));
  }
  if (!(passive.stiffness >= 0) || !std::isfinite(passive.stiffness) || !std::isfinite(passive.rest)) {
    throw SetupError(
        fmt::format("model '{}', joint '{}': a spring of {} N m/rad (N/m) about {} rad (m) is none; its stiffness "
                    "must not be negative, and both finite",
                    model.name(), model.objects()[joint].name, passive.stiffness, passive.rest));
  }
  return passive;
}

}  // namespace murosimf::dynamics
