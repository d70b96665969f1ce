#include "murosimf/sensors/contact_sensors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::sensors {
namespace {

/// Intersection of the force with the plane of the sensor.
std::array<double, 2> center_of_pressure(const Wrenchd& load) noexcept {
  MUROSIMF_ASSERT(load.f.z != 0);
  return {-load.n.y / load.f.z, load.n.x / load.f.z};
}

template <class Options>
typename OptionTable<Options>::Row threshold_row() {
  return {"threshold", &Options::threshold, "N", "below it nothing touches", above(0)};
}

}  // namespace

const OptionTable<ContactSensorOptions>& contact_sensor_options() {
  static const OptionTable<ContactSensorOptions> table{threshold_row<ContactSensorOptions>()};
  return table;
}

const OptionTable<PressureCellsOptions>& pressure_cells_options() {
  using Options = PressureCellsOptions;
  static const OptionTable<Options> table{
      threshold_row<Options>(),
      {"length", &Options::length, "m", "between cells, along x; without it that of the sole", above(0)},
      {"width", &Options::width, "m", "between cells, along y; without it that of the sole", above(0)},
  };
  return table;
}

ContactLoad::ContactLoad(Setup& setup, const SensorSpec& spec)
    : model_(setup.model()),
      mounting_(setup, spec),
      feet_(feet_of(setup.model())),
      weight_(-setup.model().tree().mass * setup.world().gravity),
      r_(setup.read(properties::position)),
      R_(setup.read(properties::orientation)),
      external_(setup.input(properties::external_force, {})),
      applied_(setup.input(properties::applied_force, {})),
      dynamic_(setup.input(properties::dynamic, 1)),
      stance_foot_(setup.observe(properties::stance_foot)) {
  const auto& link_of = model_.tree().link_of;
  const int link = link_of[mounting_.link_object()];
  MUROSIMF_ASSERT(link >= 0);
  for (const int body : model_.bodies()) {
    // all bodies of the rigid part that the sensor is fixed to
    if (link_of[body] == link) bodies_.push_back(body);
  }
}

Wrenchd ContactLoad::load() const noexcept {
  if (dynamic_[0] == 0) return carried_weight();  // the level has no contact forces
  const Vec3d place = mounting_.position();
  Vec3d force, moment;
  for (const int k : bodies_) {
    // pushes of users do not act on the sole
    const Vec3d f = external_[k].f - applied_[k].f;
    force += f;
    moment += external_[k].n - applied_[k].n + cross(r_[k] - place, f);
  }
  const Mat3d to_sensor = transpose(mounting_.orientation());
  return {to_sensor * moment, to_sensor * force};
}

Wrenchd ContactLoad::carried_weight() const noexcept {
  const double stance = stance_foot_[0];
  if (std::isnan(stance)) return {};  // no level writes a standing foot
  const auto foot = static_cast<std::size_t>(stance);
  const int link = mounting_.link_object();
  // users may write any number there
  if (foot >= feet_.size() || !belongs_to(model_, feet_[foot], link)) return {};
  const Vec3d arm = r_[link] + R_[link] * feet_[foot].place.offset - mounting_.position();
  const Mat3d to_sensor = transpose(mounting_.orientation());
  return {to_sensor * cross(arm, weight_), to_sensor * weight_};
}

ContactSensor::ContactSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                             std::vector<Output> outputs)
    : Sensor(setup, spec, surroundings, std::move(outputs)),
      load_(setup, spec),
      threshold_(options_of(spec, contact_sensor_options()).threshold) {}

std::string ContactSensor::diagnostic(const LevelTraits& level) const {
  if (level.dynamic) return {};
  return "there are no contact forces: it reports the whole weight on the foot that stands";
}

ContactSwitch::ContactSwitch(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ContactSensor(setup, spec, surroundings, {{"contact", "1", {}}}) {}

void ContactSwitch::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 1);
  values[0] = norm(load_.load().f) > threshold_ ? 1 : 0;
}

ContactForce::ContactForce(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ContactSensor(setup, spec, surroundings, {{"force", "N", {}}}) {}

void ContactForce::measure(std::span<double> values) noexcept { values[0] = norm(load_.load().f); }

ForceTorque::ForceTorque(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ContactSensor(setup, spec, surroundings, {{"force", "N", xyz()}, {"torque", "N m", xyz()}}) {}

void ForceTorque::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 6);
  const Wrenchd load = load_.load();
  write(load.f, values);
  write(load.n, values.subspan(3));
}

PressureCenter::PressureCenter(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ContactSensor(setup, spec, surroundings, {{"center", "m", {"x", "y"}}, {"force", "N", {}}}) {}

void PressureCenter::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 3);
  const Wrenchd load = load_.load();
  // without load there is no center of pressure
  values[0] = values[1] = std::nan("");
  values[2] = load.f.z;
  if (load.f.z <= threshold_) return;
  const auto [x, y] = center_of_pressure(load);
  values[0] = x;
  values[1] = y;
}

PressureCells::PressureCells(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : ContactSensor(setup, spec, surroundings,
                    {{"force", "N", {"front_left", "front_right", "hind_left", "hind_right"}}}) {
  const Sole* sole = setup.model().find(properties::sole, mounted_on(setup.model(), spec));
  const PressureCellsOptions options = options_of(spec, pressure_cells_options());
  if (!sole && !(options.length && options.width)) {
    throw SetupError("pressure cells that are not mounted on a sole need length and width");
  }
  length_ = options.length ? *options.length : 2 * sole->half_length;
  width_ = options.width ? *options.width : 2 * sole->half_width;
}

void PressureCells::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 4);
  const Wrenchd load = load_.load();
  std::fill(values.begin(), values.end(), 0.0);
  if (load.f.z <= threshold_) return;
  const auto [x, y] = center_of_pressure(load);
  // bilinear shares: exact for force and center of pressure within the rectangle of the cells
  const double front = std::clamp(0.5 + x / length_, 0.0, 1.0), left = std::clamp(0.5 + y / width_, 0.0, 1.0);
  values[0] = load.f.z * front * left;
  values[1] = load.f.z * front * (1 - left);
  values[2] = load.f.z * (1 - front) * left;
  values[3] = load.f.z * (1 - front) * (1 - left);
}

}  // namespace murosimf::sensors
