/// batch_inside.h - what stands behind the handle of a batch: the states of its worlds, the benches where they are stepped, and rows of
/// what they show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/api/batch_bench.h"
#include "murosimf/api/batch_observations.h"
#include "murosimf/api/batch_random.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf::api {

class BatchInside {
 public:
  BatchInside(const std::string& scene, std::size_t worlds, const SceneOptions& options, int threads);

  [[nodiscard]] std::size_t size() const { return worlds_.size(); }
  [[nodiscard]] std::size_t joints() { return template_->joints(robot_).objects.size(); }
  [[nodiscard]] double step_length() { return seconds(template_->simulation().tick()); }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

  void step(int steps);
  /// Of a world: that of the batch plus its number.
  void reset(std::uint64_t seed, std::span<const std::uint8_t> which);
  void randomize(const std::vector<Randomized>& properties);
  void set_targets(std::span<const double> targets);
  /// Of the robot of all worlds, which begin anew. Throws InputError, and changes nothing.
  void set_level(const std::string& level);

  /// From now on a scene of its own.
  [[nodiscard]] std::shared_ptr<SceneInside> whole(std::size_t world);
  [[nodiscard]] std::uint64_t state_hash(std::size_t world);

  /// Rows of what worlds show now; those of whole scenes, which others may have changed, are renewed by show().
  struct Rows {
    std::vector<double> position, velocity;   ///< (worlds, joints)
    std::vector<double> target;               ///< likewise; of worlds with `has_targets`: what they are to get
    std::vector<double> pose, base_velocity;  ///< (worlds, 7), (worlds, 6)
    std::vector<std::uint8_t> fallen;         ///< (worlds)
  };
  [[nodiscard]] Rows& show();
  /// (worlds, 3) each, as Batch::ball_position, ball_velocity.
  struct BallRows {
    std::vector<double> position, velocity;
  };
  [[nodiscard]] const BallRows& show_ball();
  void push(std::size_t world, std::string_view object, const Vector3& force, double duration, const Vector3& moment);
  /// (worlds, numbers of these names), renewed as the rows are.
  [[nodiscard]] std::span<const float> observe(const std::vector<std::string>& names);

 private:
  template <class Use>
  void for_blocks(const Use& use);
  template <class Use>
  void use_bench(std::size_t block, LaneMask renewed, const Use& use);
  [[nodiscard]] BatchBench& take_bench(std::size_t block);
  void give_back(BatchBench& bench);
  void make_benches(int threads);
  void take_targets(BatchBench& bench);
  void put_targets(std::size_t world, const RobotColumns& robot) const;
  void show(std::size_t world, const RobotColumns& robot);
  void observe(std::size_t world, const Entity& robot);
  [[nodiscard]] RobotColumns columns_of_whole(std::size_t world);

  std::shared_ptr<SceneInside> template_;
  std::uint64_t seed_;
  int robot_ = 0;
  std::vector<BatchWorld> worlds_;
  std::size_t width_ = 1;  // worlds of a block: what a bench holds
  ThreadPool pool_;
  std::mutex choosing_;
  std::vector<std::unique_ptr<BatchBench>> benches_;
  bool benches_change_ = false;    // they are fewer than blocks
  std::vector<BatchBench*> free_;  // of those that change
  Rows rows_;
  BallRows ball_rows_;  // empty if there is no ball
  BatchObservations observations_;
  std::vector<float> observed_;
  BatchRandom random_;
};

}  // namespace murosimf::api
