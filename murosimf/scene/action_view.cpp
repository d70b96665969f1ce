#include "murosimf/scene/action_view.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene_viewpoints.h"

namespace murosimf::scene {
namespace {

constexpr double elevation = 20 * pi / 180;  // [rad]
constexpr double margin = 0.2;               // [m] origins of bodies lie within them
constexpr double margin_of_ball = 0.8;       // [m] alone: where it rolls shall be seen
constexpr double ball_nearby = 1.5;          // [m]
constexpr double time_constant = 0.35;       // [s]

Vec3d smaller(const Vec3d& a, const Vec3d& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3d larger(const Vec3d& a, const Vec3d& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

}  // namespace

void ActionView::follow(const std::vector<std::string>& names, bool at_once) {
  followed_.clear();
  std::vector<std::string_view> known;
  for (const Entity* entity : scene_.moving_entities()) known.push_back(entity->name());
  for (const std::string& name : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) throw SetupError(unknown_name("entity", name, known));
    followed_.push_back(scene_.moving_entities()[static_cast<std::size_t>(found - known.begin())]);
  }
  add_ball();
  if (at_once) box_.reset();
}

void ActionView::add_ball() {
  const Entity* ball = scene_.parts().ball;
  if (!ball || followed_.empty() || std::ranges::find(followed_, ball) != followed_.end()) return;
  take_poses();
  const auto at = places_of(*ball), first = places_of(*followed_.front());
  if (at.empty() || first.empty() || norm(at.front() - first.front()) >= ball_nearby) return;
  followed_.push_back(ball);
}

/// Columns of a running scene need not have the poses of all objects.
void ActionView::take_poses() {
  Simulation& simulation = scene_.simulation();
  simulation.poses().take(simulation.world(), simulation.now(), 0, poses_);
}

std::span<const Vec3d> ActionView::places_of(const Entity& entity) const {
  const auto& entities = scene_.simulation().world().entities();
  const auto found = std::ranges::find(entities, &entity, [](const auto& one) { return one.get(); });
  const auto index = static_cast<std::size_t>(found - entities.begin());
  MUROSIMF_ASSERT(index + 1 < poses_.first.size());
  if (!poses_.present[index]) return {};
  return std::span(poses_.position).subspan(poses_.first[index], poses_.first[index + 1] - poses_.first[index]);
}

std::optional<ActionView::Box> ActionView::box_now() {
  take_poses();
  std::optional<Box> box;
  for (const Entity* entity : followed_) {
    for (const Vec3d& place : places_of(*entity)) {
      if (!box) box = Box{place, place};
      *box = {smaller(box->low, place), larger(box->high, place)};
    }
  }
  return box;
}

sensors::Perspective ActionView::look(int width, int height) {
  const std::optional<Box> now = box_now();
  if (!now) return viewpoint_perspective(scene_, "overview", width, height);
  const Duration time = scene_.simulation().now();
  if (!box_ || time < seen_) {
    box_ = now;
  } else {
    const double share = 1 - std::exp(-seconds(time - seen_) / time_constant);
    MUROSIMF_ASSERT(share >= 0 && share <= 1);
    box_->low += share * (now->low - box_->low);
    box_->high += share * (now->high - box_->high);
  }
  seen_ = time;
  const bool only_ball = followed_.size() == 1 && followed_.front() == scene_.parts().ball;
  const double space = only_ball ? margin_of_ball : margin;
  std::vector<Vec3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({(i & 1) != 0 ? box_->high.x + space : box_->low.x - space,
                       (i & 2) != 0 ? box_->high.y + space : box_->low.y - space,
                       (i & 4) != 0 ? box_->high.z + space : box_->low.z - space});
  }
  return perspective_around(scene_, corners, elevation, width, height);
}

}  // namespace murosimf::scene
