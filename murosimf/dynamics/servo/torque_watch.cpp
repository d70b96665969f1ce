#include "murosimf/dynamics/servo/torque_watch.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

constexpr double smoothing = 0.02;  // [s] time constant: peaks of single steps, as at a landing, overload no servo

}  // namespace

TorqueWatch::TorqueWatch(Setup& setup)
    : need_(setup.write(properties::torque_need)), overload_(setup.write(properties::overload)) {
  const Model& model = setup.model();
  for (const int object : model.having(properties::servo)) {
    const Servo& servo = *model.find(properties::servo, object);
    if (servo.stall_torque > 0 || servo.torque_limit > 0) joints_.push_back({object, make_servo_law(servo)});
  }
}

void TorqueWatch::initialize() noexcept {
  std::fill(need_.begin(), need_.end(), 0.0);
  std::fill(overload_.begin(), overload_.end(), Overload{});
}

void TorqueWatch::look(const Instant& instant, std::span<const double> torque, std::span<const double> rate) noexcept {
  MUROSIMF_ASSERT(instant.period > Duration{} && torque.size() == need_.size() && rate.size() == need_.size());
  const double share = seconds(instant.period) / (smoothing + seconds(instant.period));
  for (const Joint& joint : joints_) {
    const int i = joint.object;
    // first-order filter, implicit: stable for any step
    need_[i] += share * (torque[i] - need_[i]);
    const double needed = std::abs(need_[i]);
    const Overload& worst = overload_[i];
    if (needed <= worst.needed - worst.given) continue;  // cannot exceed the worst: no servo gives less than nothing
    const double given = joint.law->available(rate[i], std::copysign(1.0, need_[i]));
    if (needed - given > worst.needed - worst.given) overload_[i] = {needed, given, rate[i], seconds(instant.now)};
  }
}

std::string overload_message(const Entity& entity) {
  const auto* column = entity.find(properties::overload);
  if (!column || entity.frozen()) return {};
  std::vector<int> weak;
  for (const int i : entity.model().joints()) {
    if (column->values[i].needed > column->values[i].given) weak.push_back(i);
  }
  if (weak.empty()) return {};
  const auto excess = [&](int i) { return column->values[i].needed - column->values[i].given; };
  std::stable_sort(weak.begin(), weak.end(), [&](int i, int j) { return excess(i) > excess(j); });
  const auto name = [&](int i) -> const std::string& { return entity.model().objects()[i].name; };
  const Overload& worst = column->values[weak[0]];
  std::string line =
      fmt::format("{}: not feasible: {} needs {:.1f} Nm, servo gives {:.1f} at {:.1f} rad/s (at {:.2f} s)",
                  entity.name(), name(weak[0]), worst.needed, worst.given, worst.rate, worst.time);
  constexpr std::size_t most = 4;
  for (std::size_t k = 1; k < std::min(weak.size(), most); ++k) line += (k == 1 ? "; also " : ", ") + name(weak[k]);
  if (weak.size() > most) line += fmt::format(" and {} more", weak.size() - most);
  return line;
}

double rotor_inertia(const Model& model, int joint) {
  const double* armature = model.find(properties::joint_armature, joint);
  const Servo* servo = model.find(properties::servo, joint);
  return (armature ? *armature : 0) + (servo ? servo->rotor_inertia : 0);
}

}  // namespace murosimf::dynamics
