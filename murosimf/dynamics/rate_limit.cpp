#include "murosimf/dynamics/rate_limit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {

RateLimit rate_limit(const Servo& servo, double rate) {
  MUROSIMF_ASSERT(rate > 0);
  constexpr double share = 0.02;  // [1] of the rate in which the line falls to nothing
  RateLimit limit{.rate = rate};
  if (servo.stall_torque > 0) {
    limit.most = servo.stall_torque;
    limit.line = servo.stall_torque / (share * rate);
  } else {
    // no stall torque to scale by: a line much steeper than the controller, but still soft against the step
    limit.line = 10 * std::max(servo.velocity_gain, 0.05 * servo.position_gain);
  }
  return limit;
}

double joint_rate_limit(const Model& model, int joint) {
  const double* rate = model.find(properties::joint_rate_limit, joint);
  if (!rate || *rate == 0) return std::numeric_limits<double>::infinity();
  if (*rate > 0) return *rate;
  throw SetupError(
      fmt::format("model '{}', joint '{}': a largest rate of {} rad/s (m/s) is none; it must not be negative",
                  model.name(), model.objects()[joint].name, *rate));
}

double fastest_rate(const Model& model, int joint) {
  const double limit = joint_rate_limit(model, joint);
  const Servo* servo = model.find(properties::servo, joint);
  return servo && servo->no_load_speed > 0 ? std::min(limit, servo->no_load_speed) : limit;
}

}  // namespace murosimf::dynamics
