#include "murosimf/collision/contact_parameters.h"

#include <algorithm>
#include <utility>

#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double static_sink = 0.4e-3;  // [m]
constexpr double robot_damping_ratio = 0.5;
// c: dt^2 k / m at a point under an implicit law
constexpr double resolved_on_ground = 0.25;
constexpr double resolved_between_bodies = 1;
constexpr double bounce_resolution = 0.15;
// dt^2 k / m at a point: that of kid21 (4.3 kg, 13 kN/m at 8 points, 1 ms), with room for limbs that weigh less than it
constexpr double explicit_resolution = 0.02;

bool is_round(const Model& model) {
  if (model.bodies().size() != 1) return false;
  const Shapes* shapes = model.find(properties::shapes, model.bodies()[0]);
  return shapes && shapes->size() == 1 && std::holds_alternative<Sphere>(shapes->front().shape);
}

/// What meets: as in the head of the header.
struct Masses {
  double moved = 0;    // [kg] m: of the entity, or reduced mass of two
  double resting = 0;  // [kg] m_w or m_l: whose weight the points carry
  double points = 1;   // n_c
  bool round = false;
  double resolved = 0;  // [1] c
};

/// [kg] at a point.
double mass_at_point(const Masses& masses) { return masses.moved / std::max(1.0, masses.points / 2); }

double stiffness_of(const Masses& masses, const ContactConditions& given) {
  // without gravity the weight on Earth still gives a sensible stiffness
  const double weight = masses.resting * (given.gravity > 0.1 ? given.gravity : 9.81);
  const double by_weight = weight / (masses.points * static_sink);
  if (masses.round) return std::min(by_weight, bounce_resolution * masses.moved / (given.dt * given.dt));
  if (!given.implicit_law) return by_weight;
  return std::max(by_weight, masses.resolved * mass_at_point(masses) / (given.dt * given.dt));
}

/// Gives the spring and damper of a round body the numbers with which steps of dt follow the oscillation of those that it has. An
/// implicit law takes the damper at the velocity after the step.
void resolve_bounce(ContactParameters& p, double dt, bool implicit_law) {
  const double w = std::sqrt(p.stiffness / p.mass), z = p.damping / (2 * p.mass * w);
  const double decay = std::exp(-z * w * dt);
  const double scale = implicit_law ? p.mass / (decay * decay) : p.mass;
  p.stiffness = scale * (1 + decay * decay - 2 * decay * std::cos(w * std::sqrt(1 - z * z) * dt)) / (dt * dt);
  p.damping = scale * (1 - decay * decay) / dt;
}

ContactParameters parameters_of(const Masses& masses, const PairSurface& pair, const ContactConditions& given) {
  ContactParameters p;
  p.mass = mass_at_point(masses);
  p.stiffness = pair.stiffness > 0 ? pair.stiffness : stiffness_of(masses, given);
  const double ratio = masses.round ? damping_ratio(pair.restitution) : robot_damping_ratio;
  p.damping = 2 * ratio * std::sqrt(p.stiffness * p.mass);
  p.tangent_stiffness = p.stiffness;
  p.tangent_damping = 0.5 * p.damping;
  p.friction = pair.friction;
  p.rolling = pair.rolling;
  p.rebound = pair.rebound;
  p.viscous_friction = pair.viscous_friction;
  p.spin_friction = pair.spin_friction;
  if (!masses.round || !resolves_bounce(p.stiffness, p.mass, given.dt)) return p;
  p.theta = 0;
  resolve_bounce(p, given.dt, given.implicit_law);
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

bool resolves_bounce(double stiffness, double mass, double dt) { return dt * dt * stiffness / mass < 0.36; }

ContactParameters contact_parameters(const Model& model, const PairSurface& pair, const ContactConditions& conditions) {
  const double mass = model.tree().mass;
  if (is_round(model)) return parameters_of({mass, mass, 1, true, 0}, pair, conditions);
  const double corners = 4.0 * static_cast<double>(model.having(properties::sole).size());
  return parameters_of({mass, mass, std::max(4.0, corners), false, resolved_on_ground}, pair, conditions);
}

ContactParameters contact_parameters(const Model& a, const Model& b, const PairSurface& pair,
                                     const ContactConditions& conditions) {
  const double mass_a = a.tree().mass, mass_b = b.tree().mass;
  const bool b_is_lighter = mass_b > 0 && (mass_b < mass_a || mass_a == 0);
  const auto [light, heavy] = b_is_lighter ? std::pair{mass_b, mass_a} : std::pair{mass_a, mass_b};
  const double moved = heavy > 0 ? light * heavy / (light + heavy) : light;
  if (is_round(b_is_lighter ? b : a)) return parameters_of({moved, light, 1, true, 0}, pair, conditions);
  const bool limbs = !a.joints().empty() && !b.joints().empty();
  const ContactConditions stiff{conditions.gravity, conditions.dt, conditions.implicit_law && !limbs};
  const bool heavy_rests = stiff.implicit_law && heavy > 0;
  return parameters_of({moved, heavy_rests ? heavy : light, 4, false, resolved_between_bodies}, pair, stiff);
}

ContactParameters for_explicit_step(const ContactParameters& parameters, double dt) {
  ContactParameters p = parameters;
  if (p.theta == 0) return p;
  p.stiffness = std::min(p.stiffness, explicit_resolution * p.mass / (dt * dt));
  const double softer = std::sqrt(p.stiffness / parameters.stiffness);
  p.damping *= softer;
  p.tangent_stiffness *= softer * softer;
  p.tangent_damping *= softer;
  return p;
}

}  // namespace murosimf::collision
