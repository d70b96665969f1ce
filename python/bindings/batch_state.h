/// batch_state.h - what stands behind the batches of Python: the worlds, and their numbers as arrays.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "forks.h"
#include "murosimf/batch.h"
#include "scene_state.h"

namespace murosimf::python {

enum class BatchRows { joint_position, joint_velocity, base_pose, base_velocity, ball_position, ball_velocity };

class BatchState {
 public:
  BatchState(Batch opened, bool threads);
  ~BatchState();
  BatchState(const BatchState&) = delete;
  BatchState& operator=(const BatchState&) = delete;

  // While a BatchUse is held.
  [[nodiscard]] std::shared_ptr<SceneState> world(std::size_t number);
  /// As they are now, and from then on renewed by each call that steps or resets.
  [[nodiscard]] std::span<const double> rows(BatchRows which);
  [[nodiscard]] std::span<const std::uint8_t> fallen();
  /// (worlds, joints) of the robots, as they are now; given to them before the next step if one was written, which is kept until then.
  [[nodiscard]] std::vector<double>& targets();
  /// Of these worlds, or of all: as they are now, whatever was written.
  void targets_begin_again(std::span<const std::uint8_t> which);

  /// Without the lock of the interpreter, but for signals and controllers. Raises what these raise.
  void step(std::int64_t steps);

  Batch batch;

 private:
  friend class BatchUse;
  [[nodiscard]] std::span<const double> all_rows(BatchRows which);
  void give_targets();
  void renew_targets();
  void renew();

  const bool threads_;
  const unsigned born_ = forks();
  std::atomic<bool> in_use_ = false;
  std::map<std::size_t, std::shared_ptr<SceneState>> worlds_;  ///< that were asked for
  std::array<bool, 6> shown_{};
  bool fallen_shown_ = false;
  std::vector<double> targets_, given_;
  double seconds_per_step_ = 0;  ///< as measured; 0: not yet
};

/// As Use: of the batch, and of its worlds that are scenes of Python, too. One that changes the worlds renews what is shown.
class BatchUse {
 public:
  enum class Kind { reads, changes };
  explicit BatchUse(BatchState& state, Kind kind = Kind::reads);
  ~BatchUse();
  BatchUse(const BatchUse&) = delete;
  BatchUse& operator=(const BatchUse&) = delete;

 private:
  BatchState& state_;
  const Kind kind_;
  std::deque<Use> worlds_;
};

}  // namespace murosimf::python
