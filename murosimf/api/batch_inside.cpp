#include "murosimf/api/batch_inside.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "murosimf/api/told.h"
#include "murosimf/model/properties.h"

namespace murosimf::api {
namespace {

/// Whether all that decides how a world of this scene goes on is its state: software from outside remembers more.
bool is_state_only(SceneInside& inside) {
  const scene::SceneParts& parts = inside.scene.parts();
  const auto from_outside = [](const scene_file::RobotSpec& robot) {
    return robot.controller == "library" || robot.controller == "serial" || robot.controller == "tcp";
  };
  return SimulationLanes::can_hold(inside.simulation()) && !parts.software && !parts.recorder &&
         std::ranges::none_of(parts.spec.robots, from_outside);
}

/// Has the robot at this level at each start from now on, and starts.
void begin_at(SceneInside& inside, int robot, const std::string& level, std::uint64_t seed) {
  scene::SceneParts& parts = inside.scene.parts();
  const auto moving = std::ranges::find(parts.moving_entities, &inside.entity(robot));
  parts.at_start.algorithms[static_cast<std::size_t>(moving - parts.moving_entities.begin())].level = level;
  told([&] { inside.scene.reset(seed); });
}

void put(const Vec3d& v, double* to) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

}  // namespace

BatchInside::BatchInside(const std::string& scene, std::size_t worlds, const SceneOptions& options, int threads)
    : template_(open_scene(scene, options)), seed_(template_->scene.spec().seed), worlds_(worlds), pool_(threads) {
  template_->begin();
  const auto& robots = template_->scene.parts().robots;
  if (robots.empty()) throw InputError(fmt::format("scene '{}' has no robot", scene));
  robot_ = template_->world().index_of(robots[0]);
  const auto workers = static_cast<std::size_t>(threads);
  width_ = std::min<std::size_t>(Pack8::lanes, (worlds + workers - 1) / workers);
  rows_.position.resize(worlds * joints());
  rows_.velocity = rows_.target = rows_.position;
  rows_.pose.resize(7 * worlds);
  rows_.base_velocity.resize(6 * worlds);
  rows_.fallen.resize(worlds);
  if (template_->scene.parts().ball) ball_rows_ = {std::vector<double>(3 * worlds), std::vector<double>(3 * worlds)};
  for (std::size_t i = 0; i < worlds; ++i) worlds_[i].seed = seed_ + i;
  if (is_state_only(*template_)) {
    make_benches(threads);
    reset(seed_, {});
  } else {
    for (std::size_t i = 0; i < worlds; ++i) {
      worlds_[i].whole = i == 0 ? template_ : another_scene(*template_, seed_ + i);
      worlds_[i].whole->begin();
    }
  }
}

void BatchInside::make_benches(int threads) {
  const std::size_t blocks = (worlds_.size() + width_ - 1) / width_, most = static_cast<std::size_t>(threads);
  benches_change_ = blocks > most;
  for (std::size_t b = 0; b < std::min(most, blocks); ++b) {
    std::vector<std::shared_ptr<SceneInside>> scenes;
    while (scenes.size() < width_) {
      const bool first = b == 0 && scenes.empty();
      scenes.push_back(first ? template_ : another_scene(*template_, seed_));
    }
    benches_.push_back(told([&] { return std::make_unique<BatchBench>(std::move(scenes), robot_); }));
    free_.push_back(benches_.back().get());
  }
}

/// Calls use(block) for all blocks of worlds, in several threads. The first that throws is told.
template <class Use>
void BatchInside::for_blocks(const Use& use) {
  const std::size_t blocks = (worlds_.size() + width_ - 1) / width_;
  std::vector<std::exception_ptr> thrown(blocks);
  pool_.for_each(blocks, [&](std::size_t block) {
    try {
      use(block);
    } catch (...) {
      thrown[block] = std::current_exception();
    }
  });
  const auto first = std::ranges::find_if(thrown, [](const auto& error) { return error != nullptr; });
  if (first != thrown.end()) std::rethrow_exception(*first);
}

/// Its own, if there are enough of them; else any that is free.
BatchBench& BatchInside::take_bench(std::size_t block) {
  if (!benches_change_) return *benches_[block];
  const std::lock_guard lock(choosing_);
  BatchBench& bench = *free_.back();
  free_.pop_back();
  return bench;
}

void BatchInside::give_back(BatchBench& bench) {
  if (!benches_change_) return;
  const std::lock_guard lock(choosing_);
  free_.push_back(&bench);
}

/// Calls use(bench) with the worlds of a block on it. Benches that change their worlds are empty before and afterwards: so states are
/// written only by the thread that works on their block.
template <class Use>
void BatchInside::use_bench(std::size_t block, LaneMask renewed, const Use& use) {
  if (benches_.empty()) return;
  BatchBench& bench = take_bench(block);
  try {
    bench.bring(worlds_, block * width_, renewed);
    take_targets(bench);
    use(bench);
    if (benches_change_) bench.clear(worlds_);
  } catch (...) {
    if (benches_change_) bench.forget();
    give_back(bench);
    throw;
  }
  give_back(bench);
}

void BatchInside::take_targets(BatchBench& bench) {
  for_lanes(bench.lanes(worlds_), [&](int lane) {
    const std::size_t i = bench.first() + static_cast<std::size_t>(lane);
    if (std::exchange(worlds_[i].has_targets, false)) put_targets(i, bench.columns(lane));
  });
}

void BatchInside::put_targets(std::size_t world, const RobotColumns& robot) const {
  const double* from = rows_.target.data() + world * robot.joints.size();
  for (const int joint : robot.joints) robot.target->values[static_cast<std::size_t>(joint)] = *from++;
}

void BatchInside::step(int steps) {
  for_blocks([&](std::size_t block) {
    use_bench(block, 0, [&](BatchBench& bench) {
      const LaneMask lanes = bench.lanes(worlds_);
      bench.step(lanes, steps);
      for_lanes(lanes, [&](int lane) { show(bench.first() + static_cast<std::size_t>(lane), bench.columns(lane)); });
    });
    for (std::size_t i = block * width_; i < std::min(size(), (block + 1) * width_); ++i) {
      for (int step = 0; worlds_[i].whole && step < steps; ++step) worlds_[i].whole->step();
    }
  });
}

void BatchInside::reset(std::uint64_t seed, std::span<const std::uint8_t> which) {
  for_blocks([&](std::size_t block) {
    LaneMask renewed = 0;
    for (std::size_t i = block * width_; i < std::min(size(), (block + 1) * width_); ++i) {
      if (!which.empty() && !which[i]) continue;
      renewed |= lane_bit(static_cast<int>(i - block * width_));
      worlds_[i].seed = seed + i;
      worlds_[i].has_targets = false;
      if (!worlds_[i].whole) continue;
      told([&] { worlds_[i].whole->scene.reset(seed + i); });
      random_.apply(worlds_[i].whole->entity(robot_), seed + i);
    }
    if (renewed == 0) return;
    use_bench(block, renewed, [&](BatchBench& bench) {
      for_lanes(bench.lanes(worlds_) & renewed, [&](int lane) {
        const std::size_t i = bench.first() + static_cast<std::size_t>(lane);
        bench.reset(lane, seed + i);
        random_.apply(bench.scene(lane).entity(robot_), seed + i);
        show(i, bench.columns(lane));
      });
    });
  });
}

void BatchInside::set_targets(std::span<const double> targets) {
  check_row(targets, rows_.target.size(), "joint_target of the batch");
  const auto check = [&](SceneInside& scene) {
    scene.check_targets_are_free(robot_);
    const Entity& robot = scene.entity(robot_);
    if (!robot.find(properties::joint_target))
      throw InputError(fmt::format("'{}' has no joint_target at {}", robot.name(), robot.level));
  };
  check(*template_);
  for (const BatchWorld& world : worlds_) {
    if (world.whole) check(*world.whole);
  }
  std::ranges::copy(targets, rows_.target.begin());
  for (std::size_t i = 0; i < size(); ++i) {
    if (worlds_[i].whole) {
      put_targets(i, columns_of_whole(i));
    } else {
      worlds_[i].has_targets = true;
    }
  }
}

void BatchInside::randomize(const std::vector<Randomized>& properties) {
  random_ = BatchRandom(template_->entity(robot_), template_->joints(robot_), properties);
}

void BatchInside::set_level(const std::string& level) {
  for (const auto& bench : benches_) bench->clear(worlds_);
  const std::string before = template_->entity(robot_).level;
  const std::vector<std::byte> state = template_->scene.save();
  try {
    begin_at(*template_, robot_, level, seed_);
  } catch (...) {
    begin_at(*template_, robot_, before, seed_);
    template_->scene.load(state);
    if (!benches_.empty()) benches_[0]->join_again();
    throw;
  }
  for (const auto& bench : benches_) {
    for (const auto& scene : bench->scenes()) begin_at(*scene, robot_, level, seed_);
    bench->join_again();
  }
  for (const BatchWorld& world : worlds_) {
    if (world.whole) begin_at(*world.whole, robot_, level, world.seed);
  }
  observations_ = {};  // the level may have other properties
  random_ = {};
  reset(seed_, {});
}

/// Never the scene of a bench.
std::shared_ptr<SceneInside> BatchInside::whole(std::size_t world) {
  if (worlds_[world].whole) return worlds_[world].whole;
  auto scene = another_scene(*template_, worlds_[world].seed);
  scene->begin();
  use_bench(world / width_, 0, [&](BatchBench& bench) {
    bench.store(worlds_);
    told([&] { StatePacker(scene->simulation()).load(worlds_[world].state); });
  });
  worlds_[world].state = {};
  return worlds_[world].whole = std::move(scene);
}

std::uint64_t BatchInside::state_hash(std::size_t world) {
  if (worlds_[world].whole) return worlds_[world].whole->simulation().state_hash();
  std::uint64_t hash = 0;
  use_bench(world / width_, 0,
            [&](BatchBench& bench) { hash = bench.scene(static_cast<int>(world % width_)).simulation().state_hash(); });
  return hash;
}

RobotColumns BatchInside::columns_of_whole(std::size_t world) { return columns_of(*worlds_[world].whole, robot_); }

auto BatchInside::show() -> Rows& {
  for (std::size_t i = 0; i < size(); ++i) {
    if (worlds_[i].whole) show(i, columns_of_whole(i));
  }
  return rows_;
}

void BatchInside::show(std::size_t world, const RobotColumns& robot) {
  const std::size_t each = robot.joints.size();
  const std::vector<double>& told = robot.target ? robot.target->values : robot.position;
  for (std::size_t k = 0; k < each; ++k) {
    const auto object = static_cast<std::size_t>(robot.joints[k]);
    rows_.position[world * each + k] = robot.position[object];
    rows_.velocity[world * each + k] = robot.velocity[object];
    rows_.target[world * each + k] = told[object];
  }
  double* const pose = rows_.pose.data() + 7 * world;
  put(robot.place[0], pose);
  const Rotation turned = rotation_of(robot.orientation[0]);
  pose[3] = turned.w;
  pose[4] = turned.x;
  pose[5] = turned.y;
  pose[6] = turned.z;
  double* const velocity = rows_.base_velocity.data() + 6 * world;
  put(robot.linear[0], velocity);
  put(robot.angular[0], velocity + 3);
  if (robot.ball_place) {
    put((*robot.ball_place)[0], &ball_rows_.position[3 * world]);
    put((*robot.ball_velocity)[0], &ball_rows_.velocity[3 * world]);
  }
  rows_.fallen[world] = robot.lying && robot.lying->values[0] == 1;
  observe(world, robot.robot);
}

auto BatchInside::show_ball() -> const BallRows& {
  if (ball_rows_.position.empty()) throw UnknownName("the scene of this batch has no ball");
  (void)show();
  return ball_rows_;
}

void BatchInside::push(std::size_t world, std::string_view object, const Vector3& force, double duration,
                       const Vector3& moment) {
  const auto push_robot = [&](SceneInside& scene) { scene.push(robot_, object, force, duration, moment); };
  if (worlds_[world].whole) return push_robot(*worlds_[world].whole);
  std::exception_ptr refused;  // which changes nothing: the others on the bench go on
  use_bench(world / width_, 0, [&](BatchBench& bench) {
    try {
      SceneInside& scene = bench.scene(static_cast<int>(world % width_));
      push_robot(scene);
      scene.simulation().command_queue().forget_history();  // it stays on the bench when the world leaves
    } catch (...) {
      refused = std::current_exception();
    }
  });
  if (refused) std::rethrow_exception(refused);
}

void BatchInside::observe(std::size_t world, const Entity& robot) {
  if (observations_.width() > 0) observations_.fill(robot, &observed_[world * observations_.width()]);
}

std::span<const float> BatchInside::observe(const std::vector<std::string>& names) {
  if (names != observations_.names()) {
    observations_ = BatchObservations(template_->entity(robot_), template_->joints(robot_), names);
    observed_.assign(size() * observations_.width(), 0);
    for_blocks([&](std::size_t block) {
      use_bench(block, 0, [&](BatchBench& bench) {
        for_lanes(bench.lanes(worlds_), [&](int lane) {
          observe(bench.first() + static_cast<std::size_t>(lane), bench.columns(lane).robot);
        });
      });
    });
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (worlds_[i].whole) observe(i, worlds_[i].whole->entity(robot_));
  }
  return observed_;
}

}  // namespace murosimf::api
