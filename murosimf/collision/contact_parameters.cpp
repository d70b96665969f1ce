#include "murosimf/collision/contact_parameters.h"

#include <algorithm>

#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double static_sink = 0.4e-3;  // [m]
constexpr double robot_damping_ratio = 0.5;

bool is_round(const Model& model) {
  if (model.bodies().size() != 1) return false;
  const Shapes* shapes = model.find(properties::shapes, model.bodies()[0]);
  return shapes && shapes->size() == 1 && std::holds_alternative<Sphere>(shapes->front().shape);
}

/// How many points carry the weight: one for a ball, four corners per sole on the ground, four for anything else.
double carrying_points(const Model& model, Partner partner) {
  if (is_round(model)) return 1;
  if (partner == Partner::body) return 4;
  return std::max<double>(4, 4.0 * static_cast<double>(model.having(properties::sole).size()));
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

ContactParameters contact_parameters(const Model& model, const PairSurface& pair, double gravity, double dt,
                                     Partner partner) {
  const double mass = model.tree().mass;
  const double points = carrying_points(model, partner);
  const double mass_per_point = mass / std::max(1.0, points / 2);
  // without gravity the weight on Earth still gives a sensible stiffness
  const double weight = mass * (gravity > 0.1 ? gravity : 9.81);

  ContactParameters p;
  p.stiffness = pair.stiffness > 0 ? pair.stiffness : weight / (points * static_sink);
  const double ratio = is_round(model) ? damping_ratio(pair.restitution) : robot_damping_ratio;
  p.damping = 2 * ratio * std::sqrt(p.stiffness * mass_per_point);
  p.tangent_stiffness = p.stiffness;
  p.tangent_damping = 0.5 * p.damping;
  p.friction = pair.friction;
  p.rolling = pair.rolling;
  p.rebound = pair.rebound;
  p.viscous_friction = pair.viscous_friction;
  p.spin_friction = pair.spin_friction;
  // implicit in the depth only where it does not spoil a bounce: dt^2 k / m < 0.25 resolves the impact of a ball
  p.theta = is_round(model) && dt * dt * p.stiffness / mass < 0.25 ? 0.0 : 1.0;
  return p;
}

}  // namespace murosimf::collision
