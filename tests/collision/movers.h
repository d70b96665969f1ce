/// movers.h - moving entities without a simulation, for tests of what contact between bodies is made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/model/parallel_for.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "tests/fixtures.h"

namespace murosimf::collision {

/// A level that answers an island solver and does nothing.
struct Answer final : ImpulseResponse {
  explicit Answer(std::size_t numbers = 6) : count(numbers) {}
  bool free_pass(double) noexcept override { return true; }
  [[nodiscard]] std::size_t coordinates() const noexcept override { return count; }
  [[nodiscard]] Vec3d free_velocity(int, const Vec3d&, const Vec3d&) const noexcept override { return {}; }
  void respond(int, const Vec3d&, const Mat3d&, ResponseRows&) const noexcept override {}
  void apply(std::span<const double>) noexcept override {}
  std::size_t count;
};

/// A ball that does not turn, as a level: free step under its external force, then what the island gives.
struct PointMass final : ImpulseResponse {
  bool free_pass(double h) noexcept override {
    ++passes;
    next = now + (h / mass) * force[0].f;
    return sane;
  }
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 3; }
  [[nodiscard]] Vec3d free_velocity(int, const Vec3d&, const Vec3d&) const noexcept override { return next; }
  void respond(int, const Vec3d&, const Mat3d& directions, ResponseRows& y) const noexcept override {
    const double s = 1 / std::sqrt(mass);
    const auto& [a, b, c] = directions;
    y.add(0, s * Vec3d{a.x, b.x, c.x});
    y.add(1, s * Vec3d{a.y, b.y, c.y});
    y.add(2, s * Vec3d{a.z, b.z, c.z});
  }
  void apply(std::span<const double> z) noexcept override { next += (1 / std::sqrt(mass)) * Vec3d{z[0], z[1], z[2]}; }
  double mass = 1;
  std::span<const Wrenchd> force;
  Vec3d now, next;
  bool sane = true;
  int passes = 0;
};

/// A law that only says whether it wants an island.
struct Request final : ContactLaw {
  explicit Request(IslandUse its_use) : use(its_use) {}
  [[nodiscard]] IslandUse island_use() const noexcept override { return use; }
  void prepare(std::vector<ContactPoint>&, const ContactTerms&) const noexcept override {}
  bool accept(std::span<ContactPoint>, const ContactTerms&, std::span<const Vec3d>) const noexcept override {
    return true;
  }
  void commit(std::span<ContactPoint>, const ContactTerms&, std::span<const Vec3d>) const noexcept override {}
  IslandUse use;
};

/// At rest at the origin, pushed by forces, with an answer and no law unless a test changes that.
struct Movers {
  MovingEntity& add(const std::string& name, const ModelPtr& model, const Vec3d& at = {},
                    const EntityOptions& options = {}) {
    Entity& entity = world.add(name, model, options);
    MovingEntity& mover = all.emplace_back(Setup(world, entity, access));
    rest(entity, mover);
    place(mover, at);
    mover.interface.response = &answers.emplace_back();
    return mover;
  }
  /// With all joints at zero.
  static void place(MovingEntity& mover, const Vec3d& at, const Mat3d& turn = {}) {
    auto& r = mover.entity->column(properties::position).values;
    auto& R = mover.entity->column(properties::orientation).values;
    r[0] = at;
    R[0] = turn;
    const std::vector<double> q(r.size());
    multibody::poses<double>(mover.model().tree(), q, std::span<Vec3d>(r), std::span<Mat3d>(R));
  }
  /// Of its base; all of it turns with `w`.
  static void launch(MovingEntity& mover, const Vec3d& v, const Vec3d& w = {}) {
    for (std::size_t i = 0; i < mover.r.size(); ++i) {
      mover.entity->column(properties::linear_velocity).values[i] = v + cross(w, mover.r[i] - mover.r[0]);
      mover.entity->column(properties::angular_velocity).values[i] = w;
    }
  }
  static void stand_fast(MovingEntity& mover) { mover.entity->column(properties::dynamic).values[0] = 0; }
  SerialFor serial;
  void start_step() {
    for (MovingEntity& mover : all) mover.start_step();
  }

  World world;
  AccessSet access;
  std::vector<MovingEntity> all = reserved();
  std::deque<Answer> answers;
  PairSet set;

 private:
  static std::vector<MovingEntity> reserved() {
    std::vector<MovingEntity> none;
    none.reserve(16);  // references stay valid
    return none;
  }
  static void rest(Entity& entity, MovingEntity& mover) {
    entity.column(properties::dynamic).values[0] = 1;
    std::ranges::fill(entity.column(properties::linear_velocity).values, Vec3d{});
    std::ranges::fill(entity.column(properties::angular_velocity).values, Vec3d{});
    std::ranges::fill(mover.interaction_force, Wrenchd{});
    std::ranges::fill(mover.external_force, Wrenchd{});
    std::ranges::fill(mover.external_damping, Sym6d{});
    mover.ledger[0] = {};
    mover.separation[0] = {};
    mover.contacts.rest_force.resize(mover.r.size());
  }
};

/// A ball of some mass and radius whose center is `center` from its origin.
inline ModelPtr ball(double radius, double mass, const Surface& surface = {}, const Vec3d& center = {}) {
  PlacedShape sphere = fixtures::placed(Sphere{radius}, center);
  sphere.surface = surface;
  return std::make_shared<const Model>("ball", Chain{}
                                                   .base("ball")
                                                   .with(properties::mass, mass)
                                                   .with(properties::inertia, diagonal(0.4 * mass * radius * radius))
                                                   .with(properties::shapes, Shapes{sphere}));
}

/// A contact that joins two of them.
inline PairContact joint_of(int a, int b) {
  PairContact c;
  c.a = a;
  c.b = b;
  return c;
}

}  // namespace murosimf::collision
