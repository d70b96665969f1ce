#include "murosimf/air/air.h"

#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "murosimf/air/air_properties.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::air {
namespace {

constexpr int base = 0;           // the object
constexpr double slowest = 1e-6;  // [m/s] below it the force on a ball is less than 1e-14 N; at rest it is exactly zero

const Sphere* sphere_of(const Model& model) {
  const Shapes* shapes = model.find(properties::shapes, base);
  return shapes && shapes->size() == 1 ? std::get_if<Sphere>(&shapes->front().shape) : nullptr;
}

/// [1/m] rho A / (2 m).
double air_per_meter(double density, const RoundBody& body) {
  MUROSIMF_ASSERT(body.radius >= 0 && !(body.mass <= 0));
  return 0.5 * density * pi * body.radius * body.radius / body.mass;
}

}  // namespace

double drag_per_meter(double density, const RoundBody& body) noexcept {
  return body.drag * air_per_meter(density, body);
}

Vec3d air_force(double density, const RoundBody& body, const Vec3d& u, const Vec3d& w, const Vec3d& acceleration,
                double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && density >= 0 && !(body.mass <= 0));
  const double speed = norm(u);
  if (!(speed > slowest)) return {};
  const double k = air_per_meter(density, body);  // [1/m]
  const Vec3d across = cross(w, u);
  const double spin = body.radius * norm(across) / (speed * speed);
  const double lift = k * body.lift / (spin + half_lift_spin);  // [1/m] per spin
  const double turn = dt * lift * spin * speed;                 // [rad]
  const Vec3d turned = (1 / (1 + 0.25 * turn * turn)) * ((dt * lift * body.radius) * across - (0.5 * turn * turn) * u);
  const double brake = k * body.drag * speed;  // [1/s]
  return (body.mass / (1 + dt * brake)) * ((1 / dt) * turned - brake * (u + dt * acceleration));
}

bool feels_air(const Model& model) {
  return sphere_of(model) && model.find(properties::drag_coefficient, base) &&
         model.find(properties::lift_coefficient, base);
}

Air::Air(Setup& setup, const AirOptions& options)
    : entity_(setup.entity()),
      options_(options),
      gravity_(setup.world().gravity),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      mass_(setup.read(properties::total_mass)[0]),
      dynamic_(setup.input(properties::dynamic, 1)[0]),
      external_force_(setup.write(properties::external_force)),
      contacts_(setup.write(collision::contacts)[0]) {
  take_model();
}

void Air::take_model() {
  const Model& model = entity_.model();
  if (!feels_air(model)) throw SetupError(fmt::format("air acts on single spheres only; '{}' is none", model.name()));
  body_.radius = sphere_of(model)->radius;
  body_.drag = *model.find(properties::drag_coefficient, base);
  body_.lift = *model.find(properties::lift_coefficient, base);
}

void Air::model_exchanged(const Entity& entity) {
  if (&entity == &entity_) take_model();
}

void Air::step(const Instant& instant) noexcept {
  if (dynamic_ == 0) return;
  body_.mass = mass_;
  MUROSIMF_ASSERT(instant.period > Duration{});
  const bool flies = contacts_.points.empty();
  const Vec3d others = flies ? gravity_ + (1 / mass_) * external_force_[base].f : Vec3d{};
  const Wrenchd force{{},
                      air_force(options_.density, body_, v_[base] - options_.wind, w_[base], others,
                                seconds(instant.period))};
  external_force_[base] += force;
  contacts_.rest_force[base] += force;
}

}  // namespace murosimf::air
