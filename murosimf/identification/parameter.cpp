#include "murosimf/identification/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

using multibody::BenchServo;

template <auto member>
void set_motor(BenchServo& servo, double value) {
  servo.*member = value;
}
template <auto member>
double get_motor(const BenchServo& servo) {
  return servo.*member;
}
/// Sets one number for one or two terms of the friction.
template <auto member, auto other = member>
void set_friction(BenchServo& servo, double value) {
  servo.friction.*member = value;
  servo.friction.*other = value;
}
template <auto member>
double get_friction(const BenchServo& servo) {
  return servo.friction.*member;
}

using B = BenchServo;
using F = GearFriction;
constexpr std::array all{
    Parameter{"torque_constant", "N m/A", 0.05, 5, true, set_motor<&B::torque_constant>,
              get_motor<&B::torque_constant>},
    Parameter{"resistance", "ohm", 0.5, 20, true, set_motor<&B::resistance>, get_motor<&B::resistance>},
    Parameter{"rotor_inertia", "kg m^2", 1e-4, 0.1, true, set_motor<&B::rotor_inertia>, get_motor<&B::rotor_inertia>},
    Parameter{"encoder_offset", "rad", -0.1, 0.1, false, set_motor<&B::encoder_offset>, get_motor<&B::encoder_offset>},
    Parameter{"viscous_friction", "N m s/rad", 1e-4, 1, true, set_friction<&F::viscous>, get_friction<&F::viscous>},
    Parameter{"coulomb_friction", "N m", 0, 0.2, false, set_friction<&F::coulomb>, get_friction<&F::coulomb>},
    Parameter{"stribeck_friction", "N m", 0, 0.2, false, set_friction<&F::stribeck>, get_friction<&F::stribeck>},
    Parameter{"stribeck_rate", "rad/s", 0.05, 5, true, set_friction<&F::stribeck_rate>,
              get_friction<&F::stribeck_rate>},
    Parameter{"stribeck_exponent", "1", 0.5, 4, true, set_friction<&F::stribeck_exponent>,
              get_friction<&F::stribeck_exponent>},
    Parameter{"load_friction", "1", 0, 0.5, false, set_friction<&F::motor_load, &F::external_load>,
              get_friction<&F::motor_load>},
    Parameter{"stribeck_load_friction", "1", 0, 0.5, false,
              set_friction<&F::stribeck_motor_load, &F::stribeck_external_load>, get_friction<&F::stribeck_motor_load>},
    Parameter{"motor_load_friction", "1", 0, 0.5, false, set_friction<&F::motor_load>, get_friction<&F::motor_load>},
    Parameter{"external_load_friction", "1", 0, 0.5, false, set_friction<&F::external_load>,
              get_friction<&F::external_load>},
    Parameter{"stribeck_motor_load_friction", "1", 0, 0.5, false, set_friction<&F::stribeck_motor_load>,
              get_friction<&F::stribeck_motor_load>},
    Parameter{"stribeck_external_load_friction", "1", 0, 0.5, false, set_friction<&F::stribeck_external_load>,
              get_friction<&F::stribeck_external_load>},
    Parameter{"quadratic_motor_load_friction", "1/(N m)", 0, 0.1, false, set_friction<&F::quadratic_motor_load>,
              get_friction<&F::quadratic_motor_load>},
    Parameter{"quadratic_external_load_friction", "1/(N m)", 0, 0.1, false, set_friction<&F::quadratic_external_load>,
              get_friction<&F::quadratic_external_load>}};

/// The first six of `all` belong to every model; `more` are further places in `all`.
FrictionModel model_of(std::string_view name, std::string_view meaning, const std::vector<std::size_t>& more) {
  FrictionModel model{name, meaning, {}};
  for (std::size_t i = 0; i < 6; ++i) model.parameters.push_back(&all[i]);
  for (const std::size_t i : more) {
    MUROSIMF_ASSERT(i < all.size());
    model.parameters.push_back(&all[i]);
  }
  return model;
}

}  // namespace

std::span<const Parameter> parameters() { return all; }

std::span<const FrictionModel> friction_models() {
  static const std::array models{model_of("m1", "Coulomb and viscous", {}),
                                 model_of("m2", "more at rest (Stribeck)", {6, 7, 8}),
                                 model_of("m3", "grows with the load", {9}),
                                 model_of("m4", "grows with the load, more at rest", {6, 7, 8, 9, 10}),
                                 model_of("m5", "the same, motor and load each in their own way",
                                          {6, 7, 8, 11, 12, 13, 14}),
                                 model_of("m6", "the same, and with the square of the load",
                                          {6, 7, 8, 11, 12, 13, 14, 15, 16})};
  return models;
}

const FrictionModel& friction_model(std::string_view name) {
  std::vector<std::string_view> known;
  for (const FrictionModel& model : friction_models()) {
    if (model.name == name) return model;
    known.push_back(model.name);
  }
  throw SetupError(unknown_name("friction model", name, known));
}

double place_of(const Parameter& p, double value) {
  MUROSIMF_ASSERT(p.low <= p.high && (!p.by_ratio || p.low > 0));
  const double place = p.by_ratio ? std::log(value / p.low) / std::log(p.high / p.low)  //
                                  : (value - p.low) / (p.high - p.low);
  return std::clamp(place, 0.0, 1.0);
}

double value_at(const Parameter& p, double place) {
  MUROSIMF_ASSERT(p.low <= p.high);
  return p.by_ratio ? p.low * std::pow(p.high / p.low, place) : p.low + (p.high - p.low) * place;
}

}  // namespace murosimf::identification
