/// balls.h - balls under `body_contact` and a level of their own, without a simulation.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/collision/body_contact.h"
#include "murosimf/collision/contact_laws/body_island_law.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {

/// Balls of 0.1 m under `body_contact`. Masses are 1, 2, 3 kg ..., velocities zero.
struct Balls {
  explicit Balls(const std::vector<Vec3d>& places,
                 std::unique_ptr<BodyContactLaw> law = std::make_unique<BodyIslandLaw>()) {
    field = &world.add("field", std::make_shared<const Model>("field", Chain{}.base("ground")));
    std::vector<Entity*> entities;
    for (std::size_t i = 0; i < places.size(); ++i) {
      balls.push_back(&world.add("ball" + std::to_string(i), ball(0.1, static_cast<double>(i + 1))));
      entities.push_back(balls[i]);
    }
    Setup setup(world, world.common(), access);
    contact = std::make_unique<BodyContact>(setup, field, entities, MaterialTable{}, std::move(law));
    for (std::size_t i = 0; i < places.size(); ++i) {
      column(i, properties::dynamic) = 1;
      column(i, properties::position) = places[i];
      column(i, properties::orientation) = {};
      column(i, properties::linear_velocity) = column(i, properties::angular_velocity) = {};
      column(i, properties::external_force) = column(i, properties::interaction_force) = {{1, 2, 3}, {4, 5, 6}};
      column(i, properties::external_damping).M = diagonal(7.0);
      column(i, properties::absorbed_impulse) = {{1, 2, 3}, {4, 5, 6}};
      column(i, properties::separation) = {1, 2, 3};
      column(i, contacts).rest_force.resize(1);
      answers.emplace_back();
      answers[i].mass = static_cast<double>(i + 1);
      answers[i].force = column_of(i, properties::external_force);
      interface(i).response = &answers[i];
    }
    contact->initialize();
  }
  template <class T>
  std::vector<T>& column_of(std::size_t i, const Property<T>& property) {
    return balls[i]->column(property).values;
  }
  template <class T>
  T& column(std::size_t i, const Property<T>& property) {
    return column_of(i, property)[0];
  }
  ContactInterface& interface(std::size_t i) { return column(i, contact_interface); }
  PairSet& set() { return world.common().column(pair_contacts).values[0]; }
  void step() { contact->step({{}, from_seconds(dt)}); }
  void launch(std::size_t i, const Vec3d& v) { column(i, properties::linear_velocity) = answers[i].now = v; }
  /// A ground contact of ball i as ground_contact leaves it, with `law`, below the ball, pressed by 1 mm.
  void stand(std::size_t i, const ContactLaw& law) {
    interface(i).law = &law;
    interface(i).terms.parameters = {ground()};
    ContactPoint point;
    point.normal = {0, 0, 1};
    point.point = column(i, properties::position) - Vec3d{0, 0, 0.099};
    point.depth = 1e-3;
    point.radius = 0.1;
    point.velocity = column(i, properties::linear_velocity);
    point.angular_velocity = {0, 10, 0};
    ContactSet& set = column(i, contacts);
    set.points = {point};
    set.loaded = {0};
    law.prepare(set.points, interface(i).terms);
    const std::vector<Vec3d> r{column(i, properties::position)};
    write_loads(set, r, column_of(i, properties::external_force), column_of(i, properties::external_damping));
  }
  static ContactParameters ground() {
    return {.stiffness = 1e4,
            .damping = 50,
            .tangent_stiffness = 8e3,
            .tangent_damping = 25,
            .friction = 0.5,
            .rolling = 0.03};
  }

  static constexpr double dt = 1e-3;  // [s]
  World world;
  AccessSet access;
  Entity* field = nullptr;
  std::vector<Entity*> balls;
  std::deque<PointMass> answers;
  std::unique_ptr<BodyContact> contact;
};

}  // namespace murosimf::collision
