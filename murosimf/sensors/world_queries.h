/// world_queries.h - what sensors with rays see: everything that collides, with the poses of this instant.
///
/// All sensors of a simulation ask the same scenes (collision/queries.h), one for each kind of bounding volume, so an entity's
/// tree is worked out once in a tick however many look at it. Their algorithm declares a write of `query_turn` and the
/// sensors a read: so it comes in a wave before theirs, and questions of one wave may be asked by several threads.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "murosimf/collision/queries.h"
#include "murosimf/sensors/sensor_spec.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::sensors {

/// Stands for the scenes that are shared; there is nothing in it, and so no state.
struct QueryTurn {};
inline void append_hash(Hasher&, const QueryTurn&) {}
inline void state(StateArchive&, QueryTurn&) {}

/// Of the world. Algorithms that read it query after the shared scenes have been refreshed.
inline constexpr Property<QueryTurn> query_turn{
    {"query_turn", "-", "-", "questions of sensors may be asked of the poses of this tick", Scope::wiring}};

/// Algorithm: the scenes that sensors share. To be attached to the world, at the rate of the simulation's steps.
class WorldQueries final : public Algorithm {
 public:
  /// After all entities are added; reads the poses of `moving_entities`.
  WorldQueries(Setup& setup, const std::vector<Entity*>& moving_entities);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::survey; }
  void initialize() override { refresh(); }
  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;
  void entity_entered(const Entity&) override { refresh(); }
  void model_exchanged(const Entity& entity) override;
  void step(const Instant&) noexcept override { refresh(); }

  /// The scene with volumes of this kind, made when it is first asked for: while setting up only. The algorithm of `setup`
  /// may ask it questions in its steps. Throws SetupError if there is no such volume.
  [[nodiscard]] collision::QueryScene& scene(const Setup& setup, const std::string& volume);

 private:
  void refresh() noexcept;

  const World& world_;
  Entity& common_;
  std::map<std::string, std::unique_ptr<collision::QueryScene>> scenes_;  // by volume
};

/// The scene of one sensor: a shared one, or its own where none is shared.
class WorldView {
 public:
  /// Reads the poses of all moving entities. Volumes are of the kind that the robot's own collisions use.
  WorldView(Setup& setup, const SensorSurroundings& surroundings);

  /// The scene, for questions in this step.
  [[nodiscard]] collision::QueryScene& now() noexcept;
  /// An entity has been added (Algorithm::entity_added), and taken back.
  void add(Setup& setup);
  void take_back(const Entity& entity) noexcept;
  /// An entity has another model (Algorithm::model_exchanged).
  void model_exchanged(const Entity& entity);
  /// The same while setting up.
  [[nodiscard]] const collision::QueryScene& scene() const { return *scene_; }

 private:
  std::unique_ptr<collision::QueryScene> own_;
  collision::QueryScene* scene_;
};

/// Declares that pose and velocity of the entity of `setup` are read: as sources of pictures need them (view_source.h).
void read_motion(Setup& setup);
/// The same of all moving entities.
void read_motion_of_all(Setup& setup, const SensorSurroundings& surroundings);

}  // namespace murosimf::sensors
