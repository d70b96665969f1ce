#include "murosimf/collision/continuous_collision.h"

#include <algorithm>

#include "murosimf/collision/bounce.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/geometry/distance.h"

namespace murosimf::collision {
namespace {

constexpr double fast = 0.5;  // [1] of the thinner one's radius in a step
constexpr double soft = 0.1;  // [1] of that radius that is left to contact

/// A body on its way through a step.
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

/// [m/s] That a bounce makes to a body; `normal` out of what it bounces off, `share` of the change that is its own.
Vec3d change_by_bounce(const ContactPoint& c, const Vec3d& normal, double share) {
  return is_bouncing(c) ? (share * std::max(0.0, c.bounce - dot(c.velocity, c.normal))) * normal : Vec3d{};
}

/// [m/s] Without friction, and as if the others were free.
Vec3d change_by_bounces(const MovingEntity& body, std::span<const MovingEntity> moving_entities, const PairSet& set) {
  Vec3d change;
  for (const ContactPoint& c : body.contacts.points) change += change_by_bounce(c, c.normal, 1);
  const double mass = body.model().tree().mass;
  for (const PairContact& c : set.points) {
    const MovingEntity &a = moving_entities[c.a], &b = moving_entities[c.b];
    if (&a != &body && &b != &body) continue;
    const MovingEntity& other = &a == &body ? b : a;
    const double other_mass = other.model().tree().mass;
    const double share = other.can_be_pushed() ? other_mass / (mass + other_mass) : 1;
    change += change_by_bounce(c, &a == &body ? c.normal : -c.normal, share);
  }
  return change;
}

/// The first touch so far, and the velocity [m/s] of what is touched.
struct Stop {
  FirstTouch touch;
  Vec3d other;
};

/// A shape that may be in the way.
struct Obstacle {
  const Shape& shape;
  const Transformd& at;
  double radius;   // [m] half of its thickness
  Vec3d velocity;  // [m/s]
};

void look(const Flight& flight, const Obstacle& obstacle, double dt, std::optional<Stop>& first) {
  const double way = norm(flight.body.v[0] - obstacle.velocity) * dt,
               thinner = std::min(flight.radius, obstacle.radius);
  if (way <= fast * thinner) return;
  const Vec3d center = flight.relative_to(obstacle.velocity), apart = obstacle.at.position - center;
  const double reach = bounding_radius(obstacle.shape) + flight.radius + way;
  if (dot(apart, apart) > reach * reach) return;
  const auto touch = first_touch(center, flight.radius - soft * thinner, flight.velocity - obstacle.velocity,
                                 obstacle.shape, obstacle.at, dt - flight.elapsed);
  if (touch && (!first || touch->time < first->touch.time)) first = Stop{*touch, obstacle.velocity};
}

void look_at_statics(const Flight& flight, const StaticCompound& environment, double dt, std::optional<Stop>& first) {
  for (int i = 0; i < static_cast<int>(environment.compound().shapes().size()); ++i) {
    if (const StaticCompound::Ground* ground = environment.ground_of(i)) {
      i = ground->first + static_cast<int>(ground->relief->triangles().size()) - 1;
      continue;
    }
    look(flight, {environment.shape(i).placed.shape, environment.pose(i), 0.5 * environment.thickness(i), {}}, dt,
         first);
  }
}

/// Of uneven ground, which has very many shapes, those near its way; at one instant, the first of them counts.
void look_at_grounds(const Flight& flight, const StaticCompound& environment, double dt, std::optional<Stop>& first) {
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
    look(flight, {environment.shape(i).placed.shape, environment.pose(i), 0.5 * environment.thickness(i), {}}, dt,
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

/// Whether any shape of the other one can come there in time.
bool is_near(const Flight& flight, const MovingEntity& other, double dt) {
  constexpr double fastest_limb = 50;  // [m/s]
  const geometry::BoundingSphere reach = other.reach();
  const double near = reach.radius + flight.radius + (norm(flight.body.v[0] - other.v[0]) + fastest_limb) * dt;
  const Vec3d apart = reach.center - flight.start;
  return dot(apart, apart) < near * near;
}

/// `change` [m/s] of the other one's velocity in this step.
void look_at(const Flight& flight, MovingEntity& other, const Vec3d& change, double dt, std::optional<Stop>& first) {
  const Vec3d stopped = (1 / dt) * other.separation[0] + change;  // it has met something before
  for (int i = 0; i < static_cast<int>(other.compound.shapes().size()); ++i) {
    const CollidingShape& shape = other.compound.shapes()[i];
    const Vec3d velocity = other.velocity_at(shape.object, flight.start - other.r[shape.object]) + stopped;
    const double radius = 0.5 * other.thickness(i);
    if (norm(flight.body.v[0] - velocity) * dt <= fast * std::min(flight.radius, radius)) continue;
    look(flight, {shape.placed.shape, other.pose(i), radius, velocity}, dt, first);
  }
}

/// [m/s] What gravity would do along the normal in the rest of the step.
Vec3d take_gravity_back(MovingEntity& body, const FirstTouch& touch, const Vec3d& gravity, double dt) {
  const Vec3d lost = (dt - touch.time) * dot(gravity, touch.normal) * touch.normal;
  body.push(0, body.sphere(0).center, (-body.model().tree().mass / dt) * lost, dt);
  return lost;
}

/// To the touch, and along the other one's surface from there on.
void turn_aside(Flight& flight, const Stop& stop) {
  flight.moved += stop.touch.time * flight.velocity;
  flight.elapsed += stop.touch.time;
  flight.velocity -= dot(flight.velocity - stop.other, stop.touch.normal) * stop.touch.normal;
}

}  // namespace

std::optional<FirstTouch> first_touch(const Vec3d& center, double radius, const Vec3d& velocity, const Shape& shape,
                                      const Transformd& at, double dt) {
  constexpr double touching = 1e-6;  // [m] they stay that far apart, and so know the direction
  constexpr double along = 1e-9;     // [1] of the velocity: no approach
  constexpr int most = 50;
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
  constexpr int most_touches = 4;  // of one body in a step; after the last one it moves with what it touches
  for (MovingEntity& body : moving_entities) {
    if (!can_fly(body)) continue;
    // that places follow
    Vec3d end_velocity = body.v[0] + dt * gravity + change_by_bounces(body, moving_entities, set);
    Flight flight = flight_of(body, end_velocity);
    bool touched = false;
    for (int i = 0; i < most_touches; ++i) {
      std::optional<Stop> first;
      look_at_statics(flight, environment, dt, first);
      look_at_grounds(flight, environment, dt, first);
      for (MovingEntity& other : moving_entities) {
        if (&other == &body || other.apart() || !is_near(flight, other, dt)) continue;
        const Vec3d change = can_fly(other) ? change_by_bounces(other, moving_entities, set) : Vec3d{};
        look_at(flight, other, change, dt, first);
      }
      if (!first) break;
      if (!touched) end_velocity -= take_gravity_back(body, first->touch, gravity, dt);
      touched = true;
      turn_aside(flight, *first);
      if (i + 1 == most_touches) flight.velocity = first->other;
    }
    if (!touched) continue;
    body.separation[0] += flight.moved + (dt - flight.elapsed) * flight.velocity - dt * end_velocity;
  }
}

}  // namespace murosimf::collision
