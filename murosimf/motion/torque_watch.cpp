#include "murosimf/motion/torque_watch.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/properties.h"

namespace murosimf::motion {
namespace {

constexpr double smoothing = 0.02;  // [s]

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
  std::fill(overload_.begin(), overload_.end(), Vec3d{});
}

void TorqueWatch::look(const Instant& instant, std::span<const double> torque, std::span<const double> rate) noexcept {
  const double share = seconds(instant.period) / (smoothing + seconds(instant.period));
  for (const Joint& joint : joints_) {
    const int i = joint.object;
    need_[i] += share * (torque[i] - need_[i]);
    const double needed = std::abs(need_[i]);
    const Vec3d& worst = overload_[i];
    if (needed <= worst.x) continue;  // no more than what is known
    const double given = joint.law->available(rate[i], std::copysign(1.0, need_[i]));
    if (needed - given > worst.x - worst.y) overload_[i] = {needed, given, seconds(instant.now)};
  }
}

std::vector<std::string> overload_messages(const Entity& entity) {
  struct Line {
    double excess;
    std::string text;
  };
  std::vector<Line> lines;
  const auto* column = entity.find(properties::overload);
  if (!column) return {};
  for (const int i : entity.model().joints()) {
    const auto& [needed, given, time] = column->values[i];
    if (!(needed > given)) continue;
    lines.push_back(
        {needed - given, fmt::format("{}: not feasible: {} needs {:.1f} Nm, servo gives {:.1f} (at {:.2f} s)",
                                     entity.name(), entity.model().objects()[i].name, needed, given, time)});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.excess > b.excess; });
  std::vector<std::string> messages;
  for (Line& line : lines) messages.push_back(std::move(line.text));
  return messages;
}

double rotor_inertia(const Model& model, int joint) {
  const double* armature = model.find(properties::joint_armature, joint);
  const Servo* servo = model.find(properties::servo, joint);
  return (armature ? *armature : 0) + (servo ? servo->rotor_inertia : 0);
}

}  // namespace murosimf::motion
