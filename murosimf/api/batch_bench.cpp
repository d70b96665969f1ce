#include "murosimf/api/batch_bench.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/api/told.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"

namespace murosimf::api {
namespace {

template <class T>
const std::vector<T>& values_of(const Entity& robot, const Property<T>& property) {
  const Column<T>* column = robot.find(property);
  if (!column) throw SetupError(fmt::format("'{}' has no {} at {}", robot.name(), property.name, robot.level));
  return column->values;
}

}  // namespace

RobotColumns columns_of(SceneInside& scene, int robot) {
  return {scene.entity(robot), scene.joints(robot), scene.scene.parts().ball};
}

RobotColumns::RobotColumns(Entity& of, const JointRows& rows, const Entity* ball)
    : robot(of),
      joints(rows.objects),
      position(values_of(of, properties::joint_position)),
      velocity(values_of(of, properties::joint_velocity)),
      place(values_of(of, properties::position)),
      linear(values_of(of, properties::linear_velocity)),
      angular(values_of(of, properties::angular_velocity)),
      orientation(values_of(of, properties::orientation)),
      lying(of.find(properties::lying)),
      target(of.find(properties::joint_target) ? &of.column(properties::joint_target) : nullptr),
      ball_place(ball ? &values_of(*ball, properties::position) : nullptr),
      ball_velocity(ball ? &values_of(*ball, properties::linear_velocity) : nullptr) {}

BatchBench::BatchBench(std::vector<std::shared_ptr<SceneInside>> scenes, int robot)
    : scenes_(std::move(scenes)), seeds_(scenes_.size()), robot_(robot), lanes_(simulations_of(scenes_)) {
  for (const auto& scene : scenes_) scene->begun = true;
  look_at_columns();
}

void BatchBench::look_at_columns() {
  packers_.clear();
  columns_.clear();
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    packers_.emplace_back(scenes_[i]->simulation());
    columns_.push_back(columns_of(*scenes_[i], robot_));
    seeds_[i] = scenes_[i]->scene.spec().seed;  // a scene that begins at another level has another one
  }
}

std::vector<Simulation*> BatchBench::simulations_of(const std::vector<std::shared_ptr<SceneInside>>& scenes) {
  std::vector<Simulation*> simulations;
  for (const auto& scene : scenes) simulations.push_back(&scene->simulation());
  return simulations;
}

void BatchBench::join_again() {
  lanes_ = SimulationLanes(simulations_of(scenes_));
  look_at_columns();
}

void BatchBench::clear(std::vector<BatchWorld>& worlds) {
  store(worlds);
  first_ = nothing;
}

void BatchBench::forget() {
  first_ = nothing;
  for (StatePacker& packer : packers_) packer.forget();
}

LaneMask BatchBench::lanes(const std::vector<BatchWorld>& worlds) const {
  LaneMask lanes = 0;
  for (std::size_t i = 0; first_ != nothing && i < scenes_.size() && first_ + i < worlds.size(); ++i) {
    if (!worlds[first_ + i].whole) lanes |= lane_bit(static_cast<int>(i));
  }
  return lanes;
}

void BatchBench::store(std::vector<BatchWorld>& worlds) {
  for_lanes(lanes(worlds), [&](int lane) {
    const auto i = static_cast<std::size_t>(lane);
    packers_[i].save(worlds[first_ + i].state);
  });
}

void BatchBench::bring(std::vector<BatchWorld>& worlds, std::size_t first, LaneMask renewed) {
  if (first_ == first) return;
  store(worlds);
  first_ = first;
  for_lanes(lanes(worlds) & ~renewed, [&](int lane) {
    const auto i = static_cast<std::size_t>(lane);
    const BatchWorld& world = worlds[first_ + i];
    if (seeds_[i] != world.seed) scene(lane).simulation().reseed(world.seed);
    scene(lane).scene.parts().spec.seed = seeds_[i] = world.seed;
    told([&] { packers_[i].load(world.state); });
  });
}

void BatchBench::reset(int lane, std::uint64_t seed) {
  seeds_[static_cast<std::size_t>(lane)] = seed;
  told([&] { scene(lane).scene.reset(seed); });
  packers_[static_cast<std::size_t>(lane)].forget();
}

}  // namespace murosimf::api
