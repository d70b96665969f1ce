#include "murosimf/collision/continuous_collision.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/bounce.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/geometry/distance.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr double fast = 0.5;  // [1] of the thinner body's radius in a step: slower bodies are caught by penetration
constexpr double soft = 0.1;  // [1] of that radius that is left to contact

/// A body under way within a step.
struct Flight {
  const MovingEntity& body;
  double radius;       // [m]
  Vec3d start;         // [m] of its middle
  Vec3d velocity;      // [m/s] that is left of its own
  Vec3d moved{};       // [m] so far
  double elapsed = 0;  // [s]

  /// [m] Its middle relative to a shape of that velocity [m/s], whose pose is that of the beginning of the step.
  [[nodiscard]] Vec3d relative_to(const Vec3d& other) const { return start + moved - elapsed * other; }
};

bool can_fly(const MovingEntity& body) {
  return !body.apart() && body.can_be_pushed() && body.compound.shapes().size() == 1 && body.model().joints().empty();
}

Flight flight_of(const MovingEntity& body, const Vec3d& velocity) {
  return {body, 0.5 * body.thickness(0), body.sphere(0).center, velocity};
}

/// Change of velocity [m/s] of a body due to a bounce; `normal` points away from the other body, `share` is its own part of the change.
Vec3d change_by_bounce(const ContactPoint& c, const Vec3d& normal, double share) {
  return is_bouncing(c) ? (share * std::max(0.0, c.bounce - dot(c.velocity, c.normal))) * normal : Vec3d{};
}

/// The same for all its contacts [m/s]: without friction, and as if the others were free.
Vec3d change_by_bounces(const MovingEntity& body, std::span<const MovingEntity> moving_entities, const PairSet& set) {
  Vec3d change;
  for (const ContactPoint& c : body.contacts.points) change += change_by_bounce(c, c.normal, 1);
  const double mass = body.model().tree().mass;
  for (const PairContact& c : set.points) {
    const MovingEntity &a = moving_entities[c.a], &b = moving_entities[c.b];
    if (&a != &body && &b != &body) continue;
    const MovingEntity& other = &a == &body ? b : a;
    const double other_mass = other.model().tree().mass;
    MUROSIMF_ASSERT(mass + other_mass > 0);
    const double share = other.can_be_pushed() ? other_mass / (mass + other_mass) : 1;
    change += change_by_bounce(c, &a == &body ? c.normal : -c.normal, share);
  }
  return change;
}

/// The first touch so far, and the velocity [m/s] of the touched body.
struct Stop {
  FirstTouch touch;
  Vec3d other;
};

/// A shape that the body may hit.
struct Obstacle {
  const Shape& shape;
  const Transformd& at;
  double radius;   // [m] half of its thickness
  Vec3d velocity;  // [m/s]
};

void inspect(const Flight& flight, const Obstacle& obstacle, double dt, std::optional<Stop>& first) {
  MUROSIMF_ASSERT(dt > 0 && flight.elapsed >= 0);
  const double way = norm(flight.body.v[0] - obstacle.velocity) * dt,
               thinner = std::min(flight.radius, obstacle.radius);
  if (way <= fast * thinner) return;
  const Vec3d center = flight.relative_to(obstacle.velocity), apart = obstacle.at.position - center;
  const double reach = bounding_radius(obstacle.shape) + flight.radius + way;
  if (dot(apart, apart) > reach * reach) return;  // cheap test first: most obstacles are far away
  const auto touch = first_touch(center, flight.radius - soft * thinner, flight.velocity - obstacle.velocity,
                                 obstacle.shape, obstacle.at, dt - flight.elapsed);
  if (touch && (!first || touch->time < first->touch.time)) first = Stop{*touch, obstacle.velocity};
}

void inspect_statics(const Flight& flight, const StaticCompound& environment, double dt, std::optional<Stop>& first) {
  for (int i = 0; i < static_cast<int>(environment.compound().shapes().size()); ++i) {
    if (const StaticCompound::Ground* ground = environment.ground_of(i)) {
      i = ground->first + static_cast<int>(ground->relief->triangles().size()) - 1;
      continue;
    }
    inspect(flight, {environment.shape(i).placed.shape, environment.pose(i), 0.5 * environment.thickness(i), {}}, dt,
            first);
  }
}

/// Uneven ground has very many shapes: only those near the path are tested. At equal times the shape with the smallest number counts.
void inspect_grounds(const Flight& flight, const StaticCompound& environment, double dt, std::optional<Stop>& first) {
  const double speed = norm(flight.body.v[0]);
  const auto is_slow = [&](const StaticCompound::Ground& ground) {
    return speed * dt <= fast * std::min(flight.radius, 0.5 * ground.relief->thickness());
  };
  if (std::ranges::all_of(environment.uneven_grounds(), is_slow)) return;
  const double way = std::max(speed, norm(flight.velocity)) * dt;
  const geometry::BoundingSphere around{flight.relative_to({}), flight.radius + way};
  int first_shape = 0;
  const auto visit = [&](int i) {
    if (!environment.ground_of(i)) return true;
    std::optional<Stop> stop;
    inspect(flight, {environment.shape(i).placed.shape, environment.pose(i), 0.5 * environment.thickness(i), {}}, dt,
            stop);
    const auto is_sooner = [&] {
      return !first || std::pair(stop->touch.time, i) < std::pair(first->touch.time, first_shape);
    };
    if (!stop || !is_sooner()) return true;
    first = stop;
    first_shape = i;
    return true;
  };
  const auto wanted = [&](const auto& volume) { return overlap(volume, around); };
  std::visit([&](const auto& tree) { (void)geometry::for_leaves(tree, wanted, visit); }, environment.compound().tree());
}

/// Whether any shape of the other entity can reach the flight within the step.
bool is_near(const Flight& flight, const MovingEntity& other, double dt) {
  constexpr double fastest_limb = 50;  // [m/s]
  const geometry::BoundingSphere reach = other.reach();
  const double near = reach.radius + flight.radius + (norm(flight.body.v[0] - other.v[0]) + fastest_limb) * dt;
  const Vec3d apart = reach.center - flight.start;
  return dot(apart, apart) < near * near;
}

/// `change` [m/s] of the other entity's velocity in this step.
void inspect(const Flight& flight, MovingEntity& other, const Vec3d& change, double dt, std::optional<Stop>& first) {
  MUROSIMF_ASSERT(dt > 0);
  const Vec3d stopped = (1 / dt) * other.separation[0] + change;  // it may have been stopped itself in this step
  for (int i = 0; i < static_cast<int>(other.compound.shapes().size()); ++i) {
    const CollidingShape& shape = other.compound.shapes()[i];
    const Vec3d velocity = other.velocity_at(shape.object, flight.start - other.r[shape.object]) + stopped;
    const double radius = 0.5 * other.thickness(i);
    if (norm(flight.body.v[0] - velocity) * dt <= fast * std::min(flight.radius, radius)) continue;
    inspect(flight, {shape.placed.shape, other.pose(i), radius, velocity}, dt, first);
  }
}

/// Compensates the effect of gravity along the normal in the rest of the step; returns the compensated velocity [m/s].
Vec3d take_gravity_back(MovingEntity& body, const FirstTouch& touch, const Vec3d& gravity, double dt) {
  MUROSIMF_ASSERT(dt > 0);
  const Vec3d lost = (dt - touch.time) * dot(gravity, touch.normal) * touch.normal;
  body.push(0, body.sphere(0).center, (-body.model().tree().mass / dt) * lost, dt);
  return lost;
}

/// Moves the flight to the touch, and redirects it along the other body's surface.
void redirect(Flight& flight, const Stop& stop) {
  MUROSIMF_ASSERT(stop.touch.time >= 0);
  flight.moved += stop.touch.time * flight.velocity;
  flight.elapsed += stop.touch.time;
  flight.velocity -= dot(flight.velocity - stop.other, stop.touch.normal) * stop.touch.normal;
}

}  // namespace

std::optional<FirstTouch> first_touch(const Vec3d& center, double radius, const Vec3d& velocity, const Shape& shape,
                                      const Transformd& at, double dt) {
  constexpr double touching = 1e-6;  // [m] distance that is kept, so that the direction stays defined
  constexpr double along = 1e-9;     // [1] of the velocity: no approach
  constexpr int most = 50;           // conservative advancement converges linearly at grazing angles
  MUROSIMF_ASSERT(dt >= 0 && radius >= 0);
  const Shape sphere = Sphere{radius};
  FirstTouch touch;
  for (int i = 0; i < most; ++i) {
    const geometry::Gap gap = geometry::distance(sphere, {center + touch.time * velocity, Mat3d{}}, shape, at);
    if (gap.distance == 0) return touch;  // at i = 0 without a direction: nothing is stopped
    touch.normal = (1 / gap.distance) * (gap.on_b - gap.on_a);
    const double approach = dot(velocity, touch.normal);
    if (approach <= along * norm(velocity)) return std::nullopt;
    if (gap.distance <= 2 * touching) return touch;
    touch.time += (gap.distance - touching) / approach;
    if (touch.time >= dt) return std::nullopt;
  }
  return touch;
}

void stop_at_touch(std::span<MovingEntity> moving_entities, const PairSet& set, const StaticCompound& environment,
                   const Vec3d& gravity, double dt) noexcept {
  constexpr int most_touches = 4;  // of one body in a step; after the last one it moves with the touched body
  for (MovingEntity& body : moving_entities) {
    if (!can_fly(body)) continue;
    // the velocity by which its level will move it
    Vec3d end_velocity = body.v[0] + dt * gravity + change_by_bounces(body, moving_entities, set);
    Flight flight = flight_of(body, end_velocity);
    bool touched = false;
    for (int i = 0; i < most_touches; ++i) {
      std::optional<Stop> first;
      inspect_statics(flight, environment, dt, first);
      inspect_grounds(flight, environment, dt, first);
      for (MovingEntity& other : moving_entities) {
        if (&other == &body || other.apart() || !is_near(flight, other, dt)) continue;
        const Vec3d change = can_fly(other) ? change_by_bounces(other, moving_entities, set) : Vec3d{};
        inspect(flight, other, change, dt, first);
      }
      if (!first) break;
      if (!touched) end_velocity -= take_gravity_back(body, first->touch, gravity, dt);
      touched = true;
      redirect(flight, *first);
      if (i + 1 == most_touches) flight.velocity = first->other;
    }
    if (!touched) continue;
    body.separation[0] += flight.moved + (dt - flight.elapsed) * flight.velocity - dt * end_velocity;
    // the level adds this shift to its own motion of the step, hence the difference
  }
}

}  // namespace murosimf::collision
