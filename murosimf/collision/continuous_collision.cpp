#include "murosimf/collision/continuous_collision.h"

#include <algorithm>

#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/geometry/distance.h"

namespace murosimf::collision {
namespace {

constexpr double fast = 0.5;  // [1] of the thinner one's radius in a step

/// A body whose motion may be cut off.
struct Flier {
  MovingEntity& body;
  Vec3d center;   // [m] world
  double radius;  // [m]
};

bool can_fly(const MovingEntity& body) {
  return !body.apart() && body.can_be_pushed() && body.compound.shapes().size() == 1 && body.model().joints().empty();
}

Flier flier(MovingEntity& body) { return {body, body.sphere(0).center, 0.5 * body.thickness(0)}; }

/// The first touch of a body so far.
struct Touch {
  double time = 0;   // [s]
  Vec3d velocity;    // [m/s] relative
  double share = 1;  // [1] of the way back that is this body's
};

/// A shape that may be in the way.
struct Obstacle {
  const Shape& shape;
  const Transformd& at;
  double radius;  // [m] half of its thickness
  double share = 1;
};

void look(const Flier& one, const Obstacle& obstacle, const Vec3d& velocity, double dt, std::optional<Touch>& first) {
  const double way = norm(velocity) * dt;
  if (way <= fast * std::min(one.radius, obstacle.radius)) return;
  const double reach = bounding_radius(obstacle.shape) + one.radius + way;
  const Vec3d apart = obstacle.at.position - one.center;
  if (dot(apart, apart) > reach * reach) return;
  const auto time = time_of_touch(one.center, one.radius, velocity, obstacle.shape, obstacle.at, dt);
  if (time && (!first || *time < first->time)) first = Touch{*time, velocity, obstacle.share};
}

void look_at_statics(const Flier& one, const StaticCompound& environment, double dt, std::optional<Touch>& first) {
  for (int i = 0; i < static_cast<int>(environment.compound().shapes().size()); ++i) {
    const Shape& shape = environment.shape(i).placed.shape;
    look(one, {shape, environment.pose(i), 0.5 * thickness(shape)}, one.body.v[0], dt, first);
  }
}

/// Whether any shape of the other one can come there in time.
bool is_near(const Flier& one, const MovingEntity& other, double dt) {
  constexpr double fastest_limb = 50;  // [m/s]
  const geometry::BoundingSphere reach = other.reach();
  const double near = reach.radius + one.radius + (norm(one.body.v[0] - other.v[0]) + fastest_limb) * dt;
  const Vec3d apart = reach.center - one.center;
  return dot(apart, apart) < near * near;
}

void look_at(const Flier& one, MovingEntity& other, double dt, std::optional<Touch>& first) {
  for (int i = 0; i < static_cast<int>(other.compound.shapes().size()); ++i) {
    const CollidingShape& shape = other.compound.shapes()[i];
    const Vec3d velocity = one.body.v[0] - other.velocity_at(shape.object, one.center - other.r[shape.object]);
    const double radius = 0.5 * other.thickness(i);
    if (norm(velocity) * dt <= fast * std::min(one.radius, radius)) continue;
    look(one, {shape.placed.shape, other.pose(i), radius, can_fly(other) ? 0.5 : 1}, velocity, dt, first);
  }
}

}  // namespace

std::optional<double> time_of_touch(const Vec3d& center, double radius, const Vec3d& velocity, const Shape& shape,
                                    const Transformd& at, double dt) {
  constexpr double touching = 1e-7;  // [m]
  constexpr int most = 50;
  const Shape sphere = Sphere{radius};
  double time = 0;
  for (int i = 0; i < most; ++i) {
    const geometry::Gap gap = geometry::distance(sphere, {center + time * velocity, Mat3d{}}, shape, at);
    if (gap.distance < 0 && i == 0) return std::nullopt;
    const Vec3d way = gap.on_b - gap.on_a;
    const double length = norm(way);
    if (gap.distance <= touching || length == 0) return time;
    const double approach = dot(velocity, way) / length;
    if (approach <= 0) return std::nullopt;
    time += gap.distance / approach;
    if (time >= dt) return std::nullopt;
  }
  return time;
}

void stop_at_touch(std::span<MovingEntity> moving_entities, const StaticCompound& environment, double dt) noexcept {
  for (MovingEntity& body : moving_entities) {
    if (!can_fly(body)) continue;
    const Flier one = flier(body);
    std::optional<Touch> first;
    look_at_statics(one, environment, dt, first);
    for (MovingEntity& other : moving_entities) {
      if (&other != &body && !other.apart() && is_near(one, other, dt)) look_at(one, other, dt, first);
    }
    if (!first) continue;
    const double speed = norm(first->velocity);
    body.separation[0] += first->share * (touching_depth / speed - (dt - first->time)) * first->velocity;
  }
}

}  // namespace murosimf::collision
