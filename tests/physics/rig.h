/// rig.h - small worlds for tests of physical laws.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/body_contact.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/dynamics/full_dynamics.h"
#include "murosimf/dynamics/kinematic_walking.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/odometer.h"
#include "murosimf/locomotion/walk_engine.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene_file/ball.h"

namespace murosimf::test {

inline constexpr double g = 9.81;           // [m/s^2]
inline constexpr double degree = pi / 180;  // [rad]

/// Every level.
inline std::vector<std::string> all_levels() {
  return {"kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"};
}
/// Levels at which forces move an entity: every law of contact is tested at each of them.
inline std::vector<std::string> dynamic_levels() {
  return {"simplified_dynamics", "full_dynamics", "articulated_dynamics"};
}

using LawPtr = std::shared_ptr<const collision::ContactLaw>;

/// A contact law by its registered name.
inline LawPtr law_named(const std::string& name) { return catalog::make_contact_law(name); }

/// A law of contact between bodies by its registered name.
inline std::unique_ptr<collision::BodyContactLaw> body_law_named(const std::string& name) {
  return catalog::make_body_contact_law(name);
}
/// All of them.
inline std::vector<std::string> body_laws() {
  std::vector<std::string> names;
  for (const auto& entry : catalog::body_contacts()) names.emplace_back(entry.name);
  return names;
}

/// Parameters of a test of a contact law: a level and a law, by name.
using LevelAndLaw = std::tuple<std::string, std::string>;

/// All dynamic levels with these laws.
inline auto at_every_level(const std::vector<std::string>& laws) {
  return testing::Combine(testing::ValuesIn(dynamic_levels()), testing::ValuesIn(laws));
}

/// How an entity moves in a rig. `law`: null for implicit_stick. `tree`: for the levels that have links.
struct Dynamics {
  std::string level = dynamic_levels().front();
  LawPtr law;
  bool on_ground = true;
  catalog::LevelOptions options;
  dynamics::MovingTreeOptions tree;
};

/// The test's level and law.
inline Dynamics dynamics(const LevelAndLaw& names) {
  return {.level = std::get<0>(names), .law = law_named(std::get<1>(names))};
}
inline std::string name_of(const LevelAndLaw& names) { return std::get<0>(names) + "_" + std::get<1>(names); }
/// The level of a statement: "simplified_dynamics, paper".
inline std::string words_of(const LevelAndLaw& names) { return std::get<0>(names) + ", " + std::get<1>(names); }
/// The last part of the test's name: "simplified_dynamics_paper".
inline std::string test_name(const testing::TestParamInfo<LevelAndLaw>& info) { return name_of(info.param); }

/// The last part of the name of a test whose parameter is a level.
inline std::string level_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

/// A world with a ground plane of some surface or friction, and gravity turned by `slope` [rad] about y, so that
/// things slide towards +x.
struct Rig {
  explicit Rig(double friction = 0.8, double slope = 0, double rate_hz = 1000, int threads = 1)
      : Rig({"", friction}, slope, rate_hz, threads) {}
  explicit Rig(const Surface& surface, double slope, double rate_hz = 1000, int threads = 1)
      : simulation(threads), rate(rate_hz) {
    simulation.world().gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
    PlacedShape plane;
    plane.shape = Plane{};
    plane.surface = surface;
    auto model =
        std::make_shared<const Model>("ground", Chain{}.base("ground").with(properties::shapes, Shapes{plane}));
    ground = &simulation.world().add("ground", model);
  }

  Entity& add(const std::string& name, ModelPtr model, const EntityOptions& options = {}) {
    return simulation.world().add(name, std::move(model), options);
  }

  void attach_dynamics(Entity& entity, const Dynamics& dynamics = {}) {
    attach_ground(entity, dynamics);
    if (dynamics.law && dynamics.law->island_use() == collision::IslandUse::always) {
      simulation.attach<collision::BodyContact>("body_contact", rate, ground, std::vector<Entity*>{&entity}, materials,
                                                body_law_named("island_gauss_seidel"));
    }
    attach_level(entity, dynamics);
  }
  void attach_ground(Entity& entity, const Dynamics& dynamics) {
    simulation.attach<collision::GroundContact>("ground_contact", entity, rate, dynamics.on_ground ? ground : nullptr,
                                                dynamics.law ? dynamics.law : law_named("implicit_stick"), materials);
  }

  /// Any level; kinematic_walking without contact.
  void attach_motion(Entity& entity, const Dynamics& dynamics) {
    if (dynamics.level == "kinematic_walking") return attach_level(entity, dynamics);
    attach_dynamics(entity, dynamics);
  }

  /// Entities that touch each other: the ground, then `body_contact`, then how each of them moves.
  struct Together {
    Entity* entity;
    Dynamics dynamics;
  };
  void attach_together(const std::vector<Together>& all, const std::string& body_law = "island_gauss_seidel") {
    std::vector<Entity*> moving_entities;
    for (const auto& [entity, dynamics] : all) {
      moving_entities.push_back(entity);
      if (find_entry(catalog::levels(), "level", dynamics.level).traits.dynamic) attach_ground(*entity, dynamics);
    }
    simulation.attach<collision::BodyContact>("body_contact", rate, ground, moving_entities, materials,
                                              body_law_named(body_law));
    for (const auto& [entity, dynamics] : all) attach_level(*entity, dynamics);
  }

  /// Another level moves the entity from now on.
  void exchange(Entity& entity, const std::string& level, const catalog::LevelOptions& options = {}) {
    const catalog::LevelType& entry = find_entry(catalog::levels(), "level", level);
    simulation.exchange(level, entity, [&](Setup& setup) { return entry.make(setup, options); });
  }

  void run(double s) { simulation.run(from_seconds(s)); }

  /// Sets the velocity [m/s] of the center of mass and the angular velocity [rad/s], world frame.
  static void launch(Entity& entity, const Vec3d& v, const Vec3d& w = {}) {
    const Vec3d change = v - entity.base().get(properties::common_center_of_mass_velocity);
    entity.base().set(properties::linear_velocity, entity.base().get(properties::linear_velocity) + change);
    entity.base().set(properties::angular_velocity, w);
  }
  static Vec3d place(Entity& entity) { return entity.base().get(properties::position); }
  static Vec3d velocity(Entity& entity) { return entity.base().get(properties::common_center_of_mass_velocity); }

  Simulation simulation;
  MaterialTable materials;
  Entity* ground = nullptr;
  double rate;

 private:
  void attach_level(Entity& entity, const Dynamics& dynamics) {
    catalog::LevelOptions options = dynamics.options;
    options.tree = dynamics.tree;
    const catalog::LevelType& level = find_entry(catalog::levels(), "level", dynamics.level);
    simulation.attach(dynamics.level, entity, rate, [&](Setup& setup) { return level.make(setup, options); });
  }
};

/// A box of 4.3 kg, 0.30 x 0.20 x 0.10 m.
inline ModelPtr box_model(const Surface& surface) {
  const double m = 4.3;
  const Vec3d h{0.15, 0.10, 0.05};
  PlacedShape box;
  box.shape = Box{h};
  box.surface = surface;
  const SymMat3d inertia{
      m / 3 * (h.y * h.y + h.z * h.z), m / 3 * (h.x * h.x + h.z * h.z), m / 3 * (h.x * h.x + h.y * h.y), 0, 0, 0};
  return std::make_shared<const Model>("box", Chain{}
                                                  .base("box")
                                                  .with(properties::mass, m)
                                                  .with(properties::inertia, inertia)
                                                  .with(properties::shapes, Shapes{box}));
}

inline ModelPtr box_model(double friction = 0.8) { return box_model({"", friction}); }

inline ModelPtr kid21() {
  static const ModelPtr model = robot::read_robot(std::string(MUROSIMF_SOURCE_DIR) + "/models/kid21.xml").model;
  return model;
}

}  // namespace murosimf::test
