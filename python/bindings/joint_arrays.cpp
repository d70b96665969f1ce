#include "joint_arrays.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

#include "murosimf/error.h"

namespace murosimf::python {

void JointArrays::Row::gather(std::span<const double> now) {
  values.resize(now.size());  // once: arrays show this memory
  std::ranges::copy(now, values.begin());
  known.assign(now.begin(), now.end());
}

void JointArrays::Row::blank(std::size_t size) {
  values.assign(size, std::numeric_limits<double>::quiet_NaN());
  known = values;
}

bool JointArrays::Row::was_written() const {
  // bits, not numbers: NaN stands where a level has none
  return !values.empty() && std::memcmp(values.data(), known.data(), values.size() * sizeof(double)) != 0;
}

JointArrays::JointArrays(Robot robot) : robot_(std::move(robot)) { gather(); }

void JointArrays::gather() {
  if (!robot_.present()) {
    for (Row* row : {&position, &velocity, &torque, &target}) row->blank(robot_.joints().size());
    return;
  }
  position.gather(robot_.joint_position());
  velocity.gather(robot_.joint_velocity());
  torque.gather(robot_.joint_torque());
  target.gather(robot_.joint_target());
}

void JointArrays::put_written() {
  const bool any = position.was_written() || velocity.was_written() || target.was_written();
  if (any && !robot_.present()) throw Error("'" + robot_.name() + "' has left the scene: enter() brings it back");
  if (position.was_written()) robot_.set_joint_position(position.values);
  if (velocity.was_written()) robot_.set_joint_velocity(velocity.values);
  if (target.was_written()) robot_.set_joint_target(target.values);
}

void JointArrays::put() {
  try {
    put_written();
  } catch (...) {
    gather();
    throw;
  }
}

void JointArrays::show(const ControlCycle& cycle) {
  position.gather(cycle.joint_position);
  velocity.gather(cycle.joint_velocity);
  target.gather(cycle.joint_target);
}

void JointArrays::take(ControlCycle& cycle) const { std::ranges::copy(target.values, cycle.joint_target.begin()); }

}  // namespace murosimf::python
