#include "murosimf/sensors/joint_sensors.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::sensors {
namespace {

Output with_joint_names(Output output, const Model& model, const std::vector<int>& joints) {
  for (const int joint : joints) output.labels.push_back(model.objects()[joint].name);
  return output;
}

const Servo* servo_of(const Model& model, int joint) { return model.find(properties::servo, joint); }

}  // namespace

std::vector<int> sensed_joints(const Model& model, const SensorSpec& spec) {
  std::vector<int> joints(model.joints().begin(), model.joints().end());
  if (joints.empty()) throw SetupError(fmt::format("model '{}' has no joints", model.name()));
  if (spec.objects.empty()) return joints;
  std::vector<std::string_view> names;
  for (const int joint : joints) names.push_back(model.objects()[joint].name);
  joints.clear();
  for (const std::string& name : spec.objects) {
    const auto joint = model.find_object(name);
    // names of other objects are no joints
    if (!joint || !model.objects()[*joint].is_joint()) throw SetupError(unknown_name("joint", name, names));
    joints.push_back(*joint);
  }
  return joints;
}

JointSensor::JointSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                         const Property<double>& property, Output output)
    : Sensor(setup, spec, surroundings,
             {with_joint_names(std::move(output), setup.model(), sensed_joints(setup.model(), spec))}),
      joints_(sensed_joints(setup.model(), spec)),
      column_(setup.read(property)) {}

void JointSensor::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) values[i] = column_[joints_[i]];
}

JointPosition::JointPosition(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : JointSensor(setup, spec, surroundings, properties::joint_position, {"position", "rad", {}}) {}

JointRate::JointRate(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : JointSensor(setup, spec, surroundings, properties::joint_velocity, {"rate", "rad/s", {}}) {}

ServoSensor::ServoSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings, Output output)
    : Sensor(setup, spec, surroundings,
             {with_joint_names(std::move(output), setup.model(), sensed_joints(setup.model(), spec))}) {
  for (const int joint : sensed_joints(setup.model(), spec)) joints_.push_back({joint});
}

void ServoSensor::convert(std::span<double> values, std::span<const double> column) noexcept {
  MUROSIMF_ASSERT(values.size() == joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const double known = column[joint.object];
    // NaN: the present level does not write the column
    values[i] = std::isnan(known) ? joint.otherwise : joint.factor * known;
  }
}

JointTorque::JointTorque(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ServoSensor(setup, spec, surroundings, {"torque", "N m", {}}), torque_(setup.observe(properties::joint_torque)) {}

std::string JointTorque::diagnostic(const LevelTraits& level) const {
  if (level.joint_torque) return {};
  return "torques of joints are not known: it reports 0";
}

MotorCurrent::MotorCurrent(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ServoSensor(setup, spec, surroundings, {"current", "A", {}}),
      motor_torque_(setup.observe(properties::motor_torque)),
      joint_torque_(setup.observe(properties::joint_torque)) {
  for (Joint& joint : joints_) {
    const Servo* servo = servo_of(setup.model(), joint.object);
    // i = tau / k_t with k_t = voltage / no_load_speed (model/servo.h)
    joint.factor = servo && servo->voltage > 0 ? servo->no_load_speed / servo->voltage : 0;
  }
}

void MotorCurrent::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(!joints_.empty());
  // levels without servo models have joint torques only
  const bool motor_known = !std::isnan(motor_torque_[joints_[0].object]);
  ServoSensor::convert(values, motor_known ? motor_torque_ : joint_torque_);
}

std::string MotorCurrent::diagnostic(const LevelTraits& level) const {
  if (level.joint_torque && !level.servos) {
    return "joints move without servos: it reports the current for the torque that that would take";
  }
  if (level.joint_torque) return {};
  return "torques of joints are not known: it reports 0";
}

MotorVoltage::MotorVoltage(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ServoSensor(setup, spec, surroundings, {"voltage", "V", {}}),
      voltage_(setup.observe(properties::supply_voltage)) {
  for (Joint& joint : joints_) {
    if (const Servo* servo = servo_of(setup.model(), joint.object)) joint.otherwise = servo->voltage;
  }
}

MotorTemperature::MotorTemperature(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ServoSensor(setup, spec, surroundings, {"temperature", "C", {}}),
      temperature_(setup.observe(properties::servo_temperature)) {
  for (Joint& joint : joints_) {
    const Servo* servo = servo_of(setup.model(), joint.object);
    joint.otherwise = servo ? servo->heat.ambient_temperature : ServoHeat{}.ambient_temperature;
  }
}

std::string MotorTemperature::diagnostic(const LevelTraits& level) const {
  if (level.servos) return {};
  return "servos get warm only at a level that has them: it reports the temperature of the air";
}

}  // namespace murosimf::sensors
