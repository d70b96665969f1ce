#include "murosimf/collision/contact_laws/contact_parameters.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "murosimf/geometry/volume.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double standard_gravity = 9.80665;    // [m/s^2]
constexpr double explicit_deflection = 0.4e-3;  // [m] at least
constexpr double least_pressure = 500;          // [Pa] that whatever stands there carries
constexpr double implicit_damping_ratio = 1;
constexpr double explicit_damping_ratio = 0.5;
constexpr double bounce_resolution = 0.15;  // [1] dt^2 k / m
// dt^2 k / m at a point: that of kid21 (4.3 kg, 13 kN/m at 8 points, 1 ms), with room for limbs that weigh less than it
constexpr double explicit_resolution = 0.02;

bool is_round(const Model& model) {
  if (model.bodies().size() != 1) return false;
  const Shapes* shapes = model.find(properties::shapes, model.bodies()[0]);
  return shapes && shapes->size() == 1 && std::holds_alternative<Sphere>(shapes->front().shape);
}

/// What meets: as in the head of the header.
struct Masses {
  double moved = 0;   // [kg] m: of the entity, or reduced mass of two
  double load = 0;    // [N] that the points carry
  double points = 1;  // n_c
  bool round = false;
};

/// [kg] at a point.
double mass_at_point(const Masses& masses) { return masses.moved / std::max(1.0, masses.points / 2); }

double stiffness_of(const Masses& masses, const PairSurface& pair, bool implicit_law) {
  if (pair.stiffness > 0) return pair.stiffness;
  const double deflection =
      implicit_law ? pair.static_deflection : std::max(pair.static_deflection, explicit_deflection);
  return masses.load / (masses.points * deflection);
}

double weight(double mass) { return standard_gravity * mass; }

/// [m^2] Of a body without joints: mean of the faces of the box about its shapes. Others are 0.
double area(const Model& model) {
  if (!model.joints().empty() || model.bodies().empty()) return 0;
  const Shapes* shapes = model.find(properties::shapes, model.bodies()[0]);
  if (!shapes) return 0;
  std::optional<geometry::Aabb> box;
  for (const PlacedShape& placed : *shapes) {
    if (!placed.collides || std::holds_alternative<Plane>(placed.shape)) continue;
    const auto own = geometry::fit<geometry::Aabb>(placed.shape, placed.place());
    box = box ? geometry::merged(*box, own) : own;
  }
  if (!box) return 0;
  const Vec3d half = box->half;
  return 4.0 / 3 * (half.x * half.y + half.y * half.z + half.z * half.x);
}

/// [N]
double load(const Model& model) { return std::max(weight(model.tree().mass), least_pressure * area(model)); }

/// A spring and damper that lose what `p.restitution` says, as stiff as explicit steps of dt bear; the numbers with which such steps
/// follow the oscillation of those that it has.
void resolve_bounce(ContactParameters& p, double dt) {
  p.stiffness = std::min(p.stiffness, bounce_resolution * p.mass / (dt * dt));
  const double w = std::sqrt(p.stiffness / p.mass), z = damping_ratio(p.restitution);
  const double decay = std::exp(-z * w * dt);
  p.stiffness = p.mass * (1 + decay * decay - 2 * decay * std::cos(w * std::sqrt(1 - z * z) * dt)) / (dt * dt);
  p.damping = p.mass * (1 - decay * decay) / dt;
  p.theta = 0;
  p.restitution = -1;  // the spring does it
  p.tangent_stiffness = p.stiffness;
  p.tangent_damping = z * std::sqrt(p.stiffness * p.mass);
}

ContactParameters parameters_of(const Masses& masses, const PairSurface& pair, const ContactConditions& given) {
  ContactParameters p;
  p.mass = mass_at_point(masses);
  p.stiffness = stiffness_of(masses, pair, given.implicit_law);
  const double ratio = given.implicit_law ? implicit_damping_ratio : explicit_damping_ratio;
  p.damping = 2 * ratio * std::sqrt(p.stiffness * p.mass);
  p.tangent_stiffness = p.stiffness;
  p.tangent_damping = 0.5 * p.damping;
  p.friction = pair.friction;
  p.rolling = pair.rolling;
  p.torsional = pair.torsional;
  p.rebound = pair.rebound;
  p.viscous_friction = pair.viscous_friction;
  p.spin_friction = pair.spin_friction;
  if (!masses.round) return p;
  p.restitution = pair.restitution;
  if (!given.implicit_law) resolve_bounce(p, given.dt);
  return p;
}

}  // namespace

double restitution(double z) {
  const double w = std::sqrt(1 - z * z);
  return std::exp(-(z / w) * (pi - std::atan2(2 * z * w, w * w - z * z)));
}

double damping_ratio(double e) {
  double low = 0, high = 0.95;  // restitution falls steadily with the ratio
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution(middle) > e ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

ContactParameters contact_parameters(const Model& model, const PairSurface& pair, const ContactConditions& conditions) {
  const double mass = model.tree().mass;
  if (is_round(model)) return parameters_of({mass, weight(mass), 1, true}, pair, conditions);
  const double corners = 4.0 * static_cast<double>(model.having(properties::sole).size());
  const double carried = conditions.implicit_law ? load(model) : weight(mass);
  return parameters_of({mass, carried, std::max(4.0, corners), false}, pair, conditions);
}

ContactParameters contact_parameters(const Model& a, const Model& b, const PairSurface& pair,
                                     const ContactConditions& conditions) {
  const double mass_a = a.tree().mass, mass_b = b.tree().mass;
  const bool b_is_lighter = mass_b > 0 && (mass_b < mass_a || mass_a == 0);
  const auto [light, heavy] = b_is_lighter ? std::pair{mass_b, mass_a} : std::pair{mass_a, mass_b};
  const double moved = heavy > 0 ? light * heavy / (light + heavy) : light;
  if (is_round(b_is_lighter ? b : a)) return parameters_of({moved, weight(light), 1, true}, pair, conditions);
  const bool limbs = !a.joints().empty() && !b.joints().empty();
  const ContactConditions stiff{conditions.dt, conditions.implicit_law && !limbs};
  const bool heavy_rests = stiff.implicit_law && heavy > 0;
  const double carried = heavy_rests ? std::max(load(a), load(b)) : weight(light);
  return parameters_of({moved, carried, 4, false}, pair, stiff);
}

ContactParameters for_explicit_step(const ContactParameters& parameters, double dt) {
  ContactParameters p = parameters;
  if (p.theta == 0) return p;
  if (p.restitution >= 0) {
    resolve_bounce(p, dt);
    return p;
  }
  p.stiffness = std::min(p.stiffness, explicit_resolution * p.mass / (dt * dt));
  const double softer = std::sqrt(p.stiffness / parameters.stiffness);
  p.damping *= softer;
  p.tangent_stiffness *= softer * softer;
  p.tangent_damping *= softer;
  return p;
}

}  // namespace murosimf::collision
