/// batch_bench.h - a place where up to eight worlds of a batch are stepped side by side: one compiled scene for each, lanes across them.
///
/// A batch has one bench for each thread. Worlds that have none for good are stored as packed states (runtime/state_packer.h), and put on
/// one, up to eight at a time, while they are needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "murosimf/api/scene_inside.h"
#include "murosimf/runtime/simulation_lanes.h"
#include "murosimf/runtime/state_packer.h"

namespace murosimf::api {

/// One world of a batch.
struct BatchWorld {
  std::uint64_t seed = 0;
  std::vector<StatePacker::Word> state;  ///< when it was last taken from a bench
  std::shared_ptr<SceneInside> whole;    ///< a scene of its own, which steps by itself; null: it has none
  bool has_targets = false;              ///< of joints, which wait until it is on a bench
};

/// Columns of the robot, and of the ball, to which rows belong.
struct RobotColumns {
  /// `ball`: null if there is none.
  RobotColumns(Entity& robot, const JointRows& joints, const Entity* ball);

  const Entity& robot;
  const std::vector<int>& joints;  ///< their objects
  const std::vector<double>&position, &velocity;
  const std::vector<Vec3d>&place, &linear, &angular;
  const std::vector<Mat3d>& orientation;
  const Column<double>* lying;                          ///< null: the robot never lies
  Column<double>* target;                               ///< null: the level has no targets
  const std::vector<Vec3d>*ball_place, *ball_velocity;  ///< null: there is no ball
};

[[nodiscard]] RobotColumns columns_of(SceneInside& scene, int robot);

class BatchBench {
 public:
  static constexpr std::size_t nothing = static_cast<std::size_t>(-1);

  /// Scenes that were built alike; `robot` is the number of the entity that the batch shows.
  BatchBench(std::vector<std::shared_ptr<SceneInside>> scenes, int robot);

  /// The number of the first world that is here.
  [[nodiscard]] std::size_t first() const { return first_; }
  /// Has the worlds from number `first` on here, of which there are as many as scenes, or less at the end. Those of `renewed` are to be
  /// reset: their states are not needed.
  void bring(std::vector<BatchWorld>& worlds, std::size_t first, LaneMask renewed);
  /// Stores the states of all that are here; they stay.
  void store(std::vector<BatchWorld>& worlds);

  /// The lanes of the worlds that are here and have no whole scene.
  [[nodiscard]] LaneMask lanes(const std::vector<BatchWorld>& worlds) const;
  [[nodiscard]] const std::vector<std::shared_ptr<SceneInside>>& scenes() const { return scenes_; }
  [[nodiscard]] SceneInside& scene(int lane) { return *scenes_[static_cast<std::size_t>(lane)]; }
  [[nodiscard]] const RobotColumns& columns(int lane) const { return columns_[static_cast<std::size_t>(lane)]; }
  void reset(int lane, std::uint64_t seed);
  void step(LaneMask lanes, int steps) { lanes_.step(lanes, steps); }
  /// Stores the states of all that are here; nothing is here then.
  void clear(std::vector<BatchWorld>& worlds);
  /// Nothing is here then, either, but states stay as they were stored last.
  void forget();
  /// After levels of its scenes have been exchanged, while nothing is here.
  void join_again();

 private:
  [[nodiscard]] static std::vector<Simulation*> simulations_of(const std::vector<std::shared_ptr<SceneInside>>& scenes);
  void look_at_columns();

  std::vector<std::shared_ptr<SceneInside>> scenes_;
  std::vector<std::uint64_t> seeds_;  // of their random numbers
  int robot_;
  SimulationLanes lanes_;
  std::vector<StatePacker> packers_;
  std::vector<RobotColumns> columns_;
  std::size_t first_ = nothing;
};

}  // namespace murosimf::api
