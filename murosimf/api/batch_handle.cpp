// include/murosimf/batch.h.
#include "murosimf/batch.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf {

namespace api {

struct BatchInside {
  std::uint64_t seed = 1;
  std::vector<std::shared_ptr<SceneInside>> worlds;
  std::vector<int> robot;  ///< by world: number of its first robot
  ThreadPool pool;
  std::vector<double> position, velocity, pose, base_velocity;
  std::vector<std::uint8_t> fallen;

  explicit BatchInside(int threads) : pool(threads) {}

  /// Calls use(i) for all worlds, in several threads. The first that throws is told.
  template <class Use>
  void for_each(const Use& use) {
    std::vector<std::exception_ptr> thrown(worlds.size());
    pool.for_each(worlds.size(), [&](std::size_t i) {
      try {
        use(i);
      } catch (...) {
        thrown[i] = std::current_exception();
      }
    });
    const auto first = std::ranges::find_if(thrown, [](const auto& error) { return error != nullptr; });
    if (first != thrown.end()) std::rethrow_exception(*first);
  }

  [[nodiscard]] Entity& entity(std::size_t i) { return worlds[i]->entity(robot[i]); }
  [[nodiscard]] JointRows& joints(std::size_t i) { return worlds[i]->joints(robot[i]); }

  std::span<const double> gather(const Property<double>& property, std::vector<double>& into) {
    const std::size_t joints_each = joints(0).objects.size();
    into.resize(worlds.size() * joints_each);
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      const std::vector<double>& column = entity(i).column(property).values;
      const std::vector<int>& objects = joints(i).objects;
      for (std::size_t k = 0; k < joints_each; ++k) {
        into[i * joints_each + k] = column[static_cast<std::size_t>(objects[k])];
      }
    }
    return into;
  }
};

namespace {

void put(const Vec3d& v, double*& to) {
  for (const double x : {v.x, v.y, v.z}) *to++ = x;
}

}  // namespace
}  // namespace api

inline namespace v0 {

using api::told;

Batch::Batch(const std::string& scene, std::size_t worlds, const SceneOptions& options, int threads) {
  if (worlds == 0) throw InputError("a batch of no worlds");
  if (threads < 1) throw InputError(fmt::format("threads = {}: at least 1", threads));
  inside_ = told([&] { return std::make_unique<api::BatchInside>(threads); });
  auto first = api::open_scene(scene, options);
  inside_->seed = first->scene.spec().seed;
  inside_->worlds.resize(worlds);
  inside_->worlds[0] = std::move(first);
  inside_->for_each([&](std::size_t i) {
    if (i > 0) inside_->worlds[i] = api::another_scene(*inside_->worlds[0], inside_->seed + i);
  });
  inside_->for_each([&](std::size_t i) { inside_->worlds[i]->begin(); });
  for (const auto& world : inside_->worlds) {
    const auto& robots = world->scene.parts().robots;
    if (robots.empty()) throw InputError(fmt::format("scene '{}' has no robot", scene));
    inside_->robot.push_back(world->world().index_of(robots[0]));
  }
}

Batch::~Batch() = default;
Batch::Batch(Batch&&) noexcept = default;
Batch& Batch::operator=(Batch&&) noexcept = default;

api::BatchInside& Batch::inside() const {
  if (!inside_) throw Error("this batch was moved from");
  return *inside_;
}

std::size_t Batch::size() const { return inside().worlds.size(); }

Scene Batch::world(std::size_t number) const {
  if (number >= size()) throw InputError(fmt::format("world {} of a batch of {}", number, size()));
  return Scene(inside().worlds[number]);
}

void Batch::step(int steps) {
  if (steps < 0) throw InputError(fmt::format("{} steps", steps));
  inside().for_each([&](std::size_t i) {
    for (int step = 0; step < steps; ++step) inside().worlds[i]->step();
  });
}

void Batch::reset(std::span<const std::uint8_t> which) { reset(inside().seed, which); }

/// Each world has a seed of its own, also after a reset.
void Batch::reset(std::uint64_t seed, std::span<const std::uint8_t> which) {
  if (!which.empty() && which.size() != size()) {
    throw InputError(fmt::format("reset takes {} entries, one for each world, not {}", size(), which.size()));
  }
  inside().for_each([&](std::size_t i) {
    if (which.empty() || which[i]) told([&] { inside().worlds[i]->scene.reset(seed + i); });
  });
}

std::size_t Batch::joints() const { return inside().joints(0).objects.size(); }

std::span<const double> Batch::joint_position() {
  return inside().gather(properties::joint_position, inside().position);
}

std::span<const double> Batch::joint_velocity() {
  return inside().gather(properties::joint_velocity, inside().velocity);
}

std::span<const double> Batch::base_pose() {
  inside().pose.resize(7 * size());
  double* to = inside().pose.data();
  for (std::size_t i = 0; i < size(); ++i) {
    const Entity& robot = inside().entity(i);
    api::put(robot.find(properties::position)->values[0], to);
    const Rotation turned = api::rotation_of(robot.find(properties::orientation)->values[0]);
    for (const double x : {turned.w, turned.x, turned.y, turned.z}) *to++ = x;
  }
  return inside().pose;
}

std::span<const double> Batch::base_velocity() {
  inside().base_velocity.resize(6 * size());
  double* to = inside().base_velocity.data();
  for (std::size_t i = 0; i < size(); ++i) {
    const Entity& robot = inside().entity(i);
    api::put(robot.find(properties::linear_velocity)->values[0], to);
    api::put(robot.find(properties::angular_velocity)->values[0], to);
  }
  return inside().base_velocity;
}

std::span<const std::uint8_t> Batch::fallen() {
  inside().fallen.resize(size());
  for (std::size_t i = 0; i < size(); ++i) inside().fallen[i] = Robot(inside().worlds[i], inside().robot[i]).fallen();
  return inside().fallen;
}

/// The size is checked for all worlds at once, before any target changes.
void Batch::set_joint_target(std::span<const double> targets) {
  const std::size_t each = joints();
  api::check_row(targets, size() * each, "joint_target of the batch");
  for (std::size_t i = 0; i < size(); ++i) {
    Robot(inside().worlds[i], inside().robot[i]).set_joint_target(targets.subspan(i * each, each));
  }
}

}  // namespace v0
}  // namespace murosimf
