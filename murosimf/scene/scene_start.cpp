#include "murosimf/scene/scene_start.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/constant_changes.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_settings.h"
#include "murosimf/scene/section_changes.h"
#include "murosimf/scene/start_posture.h"

namespace murosimf::scene {
namespace {

/// A rotation about a random axis, by up to `largest` [rad].
Mat3d random_tilt(const RandomStream& random, double largest) {
  // uniform z and longitude give a uniform distribution of axes on the sphere (Archimedes)
  const double z = random.uniform(3, -1, 1), longitude = random.uniform(4, -pi, pi), across = std::sqrt(1 - z * z);
  return rotation(Vec3d{across * std::cos(longitude), across * std::sin(longitude), z},
                  random.uniform(5, -largest, largest));
}

/// A start pose in the scene's file.
struct Start {
  const std::string& name;
  Vec3d position;
  double heading;
  Mat3d attitude;
};

void place(const scene_file::SceneSpec& spec, const Start& start, Entity& entity) {
  const double j = spec.jitter_position;
  // a stream per entity: starts do not depend on the other entities of the scene
  const RandomStream random(spec.seed, start.name + "/start");
  entity.place(start.position + Vec3d{random.uniform(0, -j, j), random.uniform(1, -j, j), 0},
               start.heading + random.uniform(2, -spec.jitter_heading, spec.jitter_heading),
               random_tilt(random, spec.jitter_tilt) * start.attitude);
}

/// Varies joint targets about the start posture, by up to jitter_posture; controllers that set them override this.
void scatter_posture(const SceneParts& parts, const Keyframe* key, Entity& robot) {
  const double largest = parts.spec.jitter_posture;
  if (largest == 0) return;
  const RandomStream random(parts.spec.seed, robot.name() + "/posture");
  auto& targets = robot.column(properties::joint_target).values;
  for (const int joint : robot.model().joints()) {
    const Vec3d* range = robot.model().find(properties::joint_range, joint);
    const double angle = start_position(robot.model(), key, joint) +
                         random.uniform(static_cast<std::uint64_t>(joint), -largest, largest);
    targets[joint] = range ? std::clamp(angle, range->x, range->y) : angle;
  }
}

}  // namespace

void place_at_start(const SceneParts& parts, Entity& entity) {
  const auto robot = std::ranges::find(parts.spec.robots, entity.name(), &scene_file::RobotSpec::name);
  const scene_file::BodySpec* body = body_spec(parts.spec, entity);
  if (body && body->jitters)
    place(parts.spec, {body->name, body->position, body->heading, rotation_y(body->pitch) * rotation_x(body->roll)},
          entity);
  if (robot == parts.spec.robots.end()) return;
  const Keyframe* key = find_keyframe(entity.model(), robot->keyframe);
  place(parts.spec,
        {robot->name, robot->position, robot->heading,
         rotation_y(robot->pitch) * rotation_x(robot->roll) * (key ? key->base : Mat3d{})},
        entity);
  take_posture(key, entity);
  scatter_posture(parts, key, entity);
}

/// Posture and velocity belong to the start as well as the place.
void start_moving(const SceneParts& parts, Entity& entity) {
  const auto robot = std::ranges::find(parts.spec.robots, entity.name(), &scene_file::RobotSpec::name);
  if (robot != parts.spec.robots.end()) take_targets(find_keyframe(entity.model(), robot->keyframe), entity);
  if (&entity == parts.ball) entity.base().set(properties::linear_velocity, parts.spec.ball->velocity);
  if (const scene_file::BodySpec* body = body_spec(parts.spec, entity)) {
    entity.base().set(properties::linear_velocity, body->velocity);
    entity.base().set(properties::angular_velocity, body->angular_velocity);
  }
}

void begin_at_every_start(SceneParts& parts) {
  parts.simulation->before_start([&parts] {
    for (Entity* entity : parts.moving_entities) place_at_start(parts, *entity);
  });
  parts.simulation->after_start([&parts] {
    if (!parts.at_start.diagnostics)
      parts.at_start.diagnostics = parts.diagnostics;  // includes those of the first picture
    check_properties(parts);
    for (Entity* entity : parts.moving_entities) start_moving(parts, *entity);
    apply_settings(parts);
    warn_about_start(parts);
  });
}

void reset(SceneParts& parts, std::optional<std::uint64_t> seed) {
  parts.simulation->initialize();  // errors of the scene are thrown before anything changes
  MUROSIMF_ASSERT(parts.at_start.algorithms.size() == parts.moving_entities.size());
  MUROSIMF_ASSERT(parts.at_start.diagnostics.has_value());
  for (std::size_t i = 0; i < parts.moving_entities.size(); ++i) {
    put_in_force(parts, *parts.moving_entities[i], parts.at_start.algorithms[i]);
  }
  put_in_force(parts, ChangedConstants{});
  put_in_force(parts, parts.at_start.sections);
  parts.diagnostics = *parts.at_start.diagnostics;
  parts.times_set.clear();
  for (Addition& addition : parts.additions) addition.time = {};
  if (seed) {
    parts.spec.seed = *seed;
    parts.simulation->reseed(*seed);
  }
  parts.simulation->reset();
}

}  // namespace murosimf::scene
