#include "murosimf/viewer/shown_poses.h"

#include <cmath>
#include <utility>

namespace murosimf::viewer {
namespace {

constexpr Duration pose_period = std::chrono::milliseconds(10);  // simulated: finer than screens show at real time
constexpr double deepest = 1;                                    // [m] of a goal

}  // namespace

ShownPoses::ShownPoses(PoseFeed& feed) : reader_(feed.subscribe({.period = pose_period, .contacts = true})) {}

bool ShownPoses::refresh() noexcept {
  const PoseFrame* const newer = reader_->latest();
  if (newer) frame_ = newer;
  return newer != nullptr;
}

bool ShownPoses::must_ask(const session::SessionStatus& status) noexcept {
  const bool late = status.paused && (!frame_ || frame_->time != status.time);
  if (!late) asked_at_ = Duration::min();  // where it stands next may be the same instant
  if (!late || asked_at_ == status.time) return false;
  asked_at_ = status.time;
  return true;
}

bool ShownPoses::has(int entity) const noexcept {
  const auto number = static_cast<std::size_t>(entity);
  return frame_ && entity >= 0 && number + 1 < frame_->first.size() && frame_->present[number];
}

std::optional<Vec3d> ShownPoses::place_of(const ObjectPath& path) const noexcept {
  if (!has(path.entity)) return std::nullopt;
  const std::size_t row = frame_->first[static_cast<std::size_t>(path.entity)] + static_cast<std::size_t>(path.object);
  MUROSIMF_ASSERT(row < frame_->first[static_cast<std::size_t>(path.entity) + 1]);
  return frame_->position[row];
}

std::optional<std::string> GoalWatch::look(const PoseFrame& frame, const SceneOutline& outline) {
  const auto ball = static_cast<std::size_t>(outline.ball());
  if (outline.ball() < 0 || outline.goal_half_width() == 0 || ball >= frame.present.size()) return std::nullopt;
  const Vec3d r = frame.position[frame.first[ball]];
  const double half_length = outline.half_length();
  const bool inside =
      std::abs(r.x) > half_length && std::abs(r.y) < outline.goal_half_width() && std::abs(r.x) < half_length + deepest;
  if (!std::exchange(in_goal_, inside) && inside) return r.x > 0 ? "goal on the right" : "goal on the left";
  return std::nullopt;
}

}  // namespace murosimf::viewer
