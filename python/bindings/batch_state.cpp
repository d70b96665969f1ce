#include "batch_state.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "python_controller.h"
#include "signals.h"

namespace murosimf::python {

BatchState::BatchState(Batch opened, bool threads) : batch(std::move(opened)), threads_(threads) {}

BatchState::~BatchState() {
  worlds_.clear();
  if (threads_ && born_ != forks()) (void)new Batch(std::move(batch));  // its threads are the parent's
}

std::shared_ptr<SceneState> BatchState::world(std::size_t number) {
  const auto found = worlds_.find(number);
  if (found != worlds_.end()) return found->second;
  return worlds_.try_emplace(number, std::make_shared<SceneState>(batch.world(number), threads_)).first->second;
}

std::span<const double> BatchState::rows(BatchRows which) {
  const std::span<const double> rows = all_rows(which);
  shown_[static_cast<std::size_t>(which)] = true;
  return rows;
}

std::span<const double> BatchState::all_rows(BatchRows which) {
  switch (which) {
    case BatchRows::joint_position: return batch.joint_position();
    case BatchRows::joint_velocity: return batch.joint_velocity();
    case BatchRows::base_pose: return batch.base_pose();
    case BatchRows::base_velocity: return batch.base_velocity();
    case BatchRows::ball_position: return batch.ball_position();
    case BatchRows::ball_velocity: break;
  }
  return batch.ball_velocity();
}

std::span<const std::uint8_t> BatchState::fallen() {
  fallen_shown_ = true;
  return batch.fallen();
}

void BatchState::renew() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (shown_[i]) (void)rows(static_cast<BatchRows>(i));
  }
  if (fallen_shown_) (void)batch.fallen();
  renew_targets();
}

std::vector<double>& BatchState::targets() {
  if (targets_.empty()) {
    const std::span<const double> now = batch.joint_target();
    targets_.assign(now.begin(), now.end());
    given_ = targets_;
  }
  renew_targets();
  return targets_;
}

void BatchState::renew_targets() {
  if (targets_.empty()) return;
  const std::span<const double> now = batch.joint_target();
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (targets_[k] == given_[k]) targets_[k] = now[k];
    given_[k] = now[k];
  }
}

void BatchState::targets_begin_again(std::span<const std::uint8_t> which) {
  if (targets_.empty()) return;
  const std::span<const double> now = batch.joint_target();
  const std::size_t joints = batch.joints();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!which.empty() && !which[i]) continue;
    for (std::size_t k = i * joints; k < (i + 1) * joints; ++k) given_[k] = targets_[k] = now[k];
  }
}

void BatchState::give_targets() {
  if (targets_ == given_) return;
  try {
    batch.set_joint_target(targets_);
  } catch (...) {
    targets_ = given_;
    throw;
  }
  given_ = targets_;
}

void BatchState::step(std::int64_t steps) {
  if (steps < 0) throw InputError(std::to_string(steps) + " steps");
  using Clock = std::chrono::steady_clock;
  constexpr double slice = 0.05;  // [s] in which Ctrl-C waits; few steps at once cost more for each
  try {
    const BatchUse use(*this, BatchUse::Kind::changes);
    const nanobind::gil_scoped_release unlocked;
    give_targets();
    Signals signals;
    while (steps > 0) {
      const double fitting = seconds_per_step_ > 0 ? slice / seconds_per_step_ : 1;
      const auto now =
          static_cast<int>(std::clamp(fitting, 1.0, static_cast<double>(std::min<std::int64_t>(steps, 1 << 20))));
      const auto begin = Clock::now();
      batch.step(now);
      seconds_per_step_ = std::chrono::duration<double>(Clock::now() - begin).count() / now;
      steps -= now;
      signals.check();
    }
  } catch (const SimulationError&) {
    for (auto& [number, world] : worlds_) raise_what_controllers_raised(*world);
    throw;
  }
}

BatchUse::BatchUse(BatchState& state, Kind kind) : state_(state), kind_(kind) {
  if (state.threads_) check_not_forked(state.born_, "this batch");
  if (state.in_use_.exchange(true, std::memory_order_acquire)) throw Error("this batch is in use in another thread");
  try {
    for (auto& [number, world] : state.worlds_) worlds_.emplace_back(*world);
  } catch (...) {
    worlds_.clear();
    state.in_use_.store(false, std::memory_order_release);
    throw;
  }
}

BatchUse::~BatchUse() {
  if (kind_ == Kind::changes) state_.renew();
  worlds_.clear();
  state_.in_use_.store(false, std::memory_order_release);
}

}  // namespace murosimf::python
