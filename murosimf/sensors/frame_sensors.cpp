#include "murosimf/sensors/frame_sensors.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

Position::Position(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"position", "m", xyz()}}), mounting_(setup, spec) {}

void Position::measure(std::span<double> values) noexcept { write(mounting_.position(), values); }

LinearVelocity::LinearVelocity(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"velocity", "m/s", xyz()}}), mounting_(setup, spec) {}

void LinearVelocity::measure(std::span<double> values) noexcept { write(mounting_.velocity(), values); }

Velocimeter::Velocimeter(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"velocity", "m/s", xyz()}}), mounting_(setup, spec) {}

void Velocimeter::measure(std::span<double> values) noexcept {
  write(transpose(mounting_.orientation()) * mounting_.velocity(), values);
}

AngularVelocity::AngularVelocity(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"velocity", "rad/s", xyz()}}), mounting_(setup, spec) {}

void AngularVelocity::measure(std::span<double> values) noexcept { write(mounting_.angular_velocity(), values); }

CenterOfMass::CenterOfMass(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"position", "m", xyz()}, {"velocity", "m/s", xyz()}}),
      tree_(setup.model().tree()),
      r_(setup.read(properties::position)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      R_(setup.read(properties::orientation)) {
  if (tree_.mass <= 0) throw SetupError("a robot without mass has no center of mass");
}

void CenterOfMass::measure(std::span<double> values) noexcept {
  Vec3d moment, momentum;
  for (const Link& link : tree_.links) {
    const Vec3d arm = R_[link.object] * link.com;
    moment += link.mass * (r_[link.object] + arm);
    momentum += link.mass * (v_[link.object] + cross(w_[link.object], arm));
  }
  write((1 / tree_.mass) * moment, values);
  write((1 / tree_.mass) * momentum, values.subspan(3));
}

}  // namespace murosimf::sensors
