#include "murosimf/collision/ball_contact.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "murosimf/collision/contact_force.h"
#include "murosimf/collision/contact_parameters.h"
#include "murosimf/collision/sphere_contact.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double fastest_walker = 3.0;  // [m/s] speed of an unpushable body's point that counts

const PlacedShape& only_sphere(const Entity& ball) {
  const Shapes* shapes = ball.model().find(properties::shapes, 0);
  const bool one = ball.model().bodies().size() == 1 && shapes && shapes->size() == 1;
  if (!one || !std::holds_alternative<Sphere>(shapes->front().shape) || norm(shapes->front().position) > 0) {
    throw SetupError(fmt::format("'{}' cannot be a ball: its model is not one sphere about its base", ball.name()));
  }
  return shapes->front();
}

/// How far a slider can go; without limits, anywhere.
double longest_travel(const Model& model, int joint) {
  const Vec3d* range = model.find(properties::joint_range, joint);
  return range ? std::max(std::abs(range->x), std::abs(range->y)) : std::numeric_limits<double>::infinity();
}

/// Longest chain of offsets from the base plus the size of what sits there: holds in every posture.
double farthest_reach(const Model& model, const std::vector<GroundShape>& shapes) {
  double reach = 0;
  for (const GroundShape& shape : shapes) {
    double length = norm(shape.placed.position) + shape.reach;
    for (int i = shape.object; i >= 0; i = model.objects()[i].parent) {
      if (model.objects()[i].kind == Kind::translation) length += norm(model.objects()[i].vector);
      if (model.objects()[i].kind == Kind::prismatic) length += longest_travel(model, i);
    }
    reach = std::max(reach, length);
  }
  return reach;
}

/// The force is explicit: the step must resolve the impact.
void check_steps(const Entity& ball, const ContactParameters& p, double dt) {
  const double mass = ball.model().tree().mass;
  if (dt * dt * p.stiffness / mass < 0.25) return;
  throw SetupError(fmt::format("'{}' is too stiff for steps of {:.2g} ms; use a rate of at least {:.0f} Hz",
                               ball.name(), 1e3 * dt, std::ceil(2 * std::sqrt(p.stiffness / mass))));
}

}  // namespace

BallContact::Partner::Partner(Setup setup, const MaterialTable& materials, const Model& ball,
                              const Surface& ball_surface, double gravity, double dt)
    : shapes(ground_shapes(setup.model())),
      reach(farthest_reach(setup.model(), shapes)),
      r(setup.read(properties::position)),
      v(setup.read(properties::linear_velocity)),
      w(setup.read(properties::angular_velocity)),
      R(setup.read(properties::orientation)),
      pushable(setup.read(properties::pushable)),
      force(setup.write(properties::interaction_force)),
      ledger(setup.write(properties::absorbed_impulse)) {
  for (const GroundShape& shape : shapes) {
    parameters.push_back(contact_parameters(ball, materials.find(ball_surface, shape.placed.surface), gravity, dt));
  }
  loaded.reserve(shapes.size());
}

BallContact::BallContact(Setup& setup, Entity& ball, const std::vector<Entity*>& robots, const MaterialTable& materials)
    : ball_(ball) {
  Setup of_ball = setup.of(ball);
  const PlacedShape& sphere = only_sphere(ball);
  radius_ = std::get<Sphere>(sphere.shape).radius;
  r_ = of_ball.read(properties::position);
  v_ = of_ball.read(properties::linear_velocity);
  w_ = of_ball.read(properties::angular_velocity);
  force_ = of_ball.write(properties::interaction_force);
  const double dt = seconds(setup.period());
  for (Entity* robot : robots) {
    partners_.emplace_back(setup.of(*robot), materials, ball.model(), sphere.surface, norm(setup.world().gravity), dt);
    for (const ContactParameters& p : partners_.back().parameters) check_steps(ball, p, dt);
  }
}

void BallContact::initialize() {
  std::fill(force_.begin(), force_.end(), Forced{});
  for (Partner& partner : partners_) {
    std::fill(partner.force.begin(), partner.force.end(), Forced{});
    partner.ledger[0] = Forced{};
  }
}

void BallContact::step(const Instant& instant) noexcept {
  force_[0] = Forced{};
  for (Partner& partner : partners_) {
    for (const int object : partner.loaded) partner.force[object] = Forced{};
    partner.loaded.clear();
    if (ball_.frozen()) continue;
    const Vec3d away = r_[0] - partner.r[0];
    const double near = partner.reach + radius_;
    if (dot(away, away) < near * near) touch(partner, seconds(instant.period));
  }
}

void BallContact::touch(Partner& partner, double dt) noexcept {
  for (std::size_t i = 0; i < partner.shapes.size(); ++i) {
    const GroundShape& shape = partner.shapes[i];
    const Vec3d middle = partner.r[shape.object] + partner.R[shape.object] * shape.placed.position;
    const double near = shape.reach + radius_;
    if (dot(r_[0] - middle, r_[0] - middle) < near * near) push(partner, shape, partner.parameters[i], dt);
  }
}

void BallContact::push(Partner& partner, const GroundShape& shape, const ContactParameters& p, double dt) noexcept {
  const int o = shape.object;
  const Mat3d R = partner.R[o] * shape.placed.orientation;
  const Vec3d middle = partner.r[o] + partner.R[o] * shape.placed.position;
  const auto touching = sphere_contact(transposed_times(R, r_[0] - middle), radius_, shape.placed.shape);
  if (!touching) return;
  const Vec3d point = middle + R * touching->point;
  const Vec3d normal = R * touching->normal;  // from the robot to the ball

  const bool pushable = partner.pushable[0] != 0;
  Vec3d v_robot = partner.v[o] + cross(partner.w[o], point - partner.r[o]);
  const double speed = norm(v_robot);
  if (!pushable && speed > fastest_walker) v_robot = (fastest_walker / speed) * v_robot;
  const Vec3d v = v_[0] + cross(w_[0], point - r_[0]) - v_robot;
  const double v_n = dot(v, normal);
  const Vec3d v_t = v - v_n * normal;
  const double slide = norm(v_t);

  const double f_n = spring_force(p, touching->depth, v_n);
  Vec3d f = f_n * normal;
  if (slide > 0) f -= (std::min(p.friction * f_n, p.tangent_damping * slide) / slide) * v_t;

  force_[0] += Forced{cross(point - r_[0], f), f};
  if (pushable) {
    partner.force[o] += Forced{cross(point - partner.r[o], -f), -f};
    if (std::find(partner.loaded.begin(), partner.loaded.end(), o) == partner.loaded.end()) partner.loaded.push_back(o);
  } else {
    partner.ledger[0] += Forced{cross(point, -dt * f), -dt * f};
  }
}

}  // namespace murosimf::collision
