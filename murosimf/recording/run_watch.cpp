#include "murosimf/recording/run_watch.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::recording {

const std::vector<std::string>& watchable() {
  static const std::vector<std::string> names = {"fall", "goal", "freeze", "asked"};
  return names;
}

int goal_with_ball(const scene::Scene& scene) {
  const Entity* ball = scene.parts().ball;
  if (!ball || !ball->present() || !scene.spec().ball) return 0;
  const Column<Vec3d>* position = ball->find(properties::position);
  if (!position) return 0;
  const scene_file::FieldSize& field = scene_file::field_size(scene.spec().field.size);
  const Vec3d r = position->values[0];
  const bool inside = std::abs(r.x) > field.length / 2 + scene.spec().ball->radius &&
                      std::abs(r.y) < field.goal_width / 2 && r.z < field.goal_height;
  return inside ? (r.x > 0 ? 1 : -1) : 0;
}

RunWatch::RunWatch(const scene::Scene& scene, std::set<std::string> what) : scene_(scene), what_(std::move(what)) {}

std::vector<std::string> RunWatch::look() {
  std::vector<std::string> happened;
  const auto& all = scene_.moving_entities();
  for (std::size_t i = entities_.size(); i < all.size(); ++i) entities_.push_back({.entity = all[i]});
  for (Watched& one : entities_) {
    const Column<double>* column = one.entity->find(properties::falls);
    // the first call only takes the present values: falls before it are no events
    const double falls = column ? column->values[0] : 0;
    const bool frozen = one.entity->frozen();
    if (begun_ && falls > one.falls && what_.contains("fall")) happened.push_back(one.entity->name() + " fell");
    if (begun_ && frozen && !one.frozen && what_.contains("freeze")) happened.push_back(one.entity->name() + " froze");
    one.falls = falls;
    one.frozen = frozen;
  }
  const bool in_goal = what_.contains("goal") && goal_with_ball(scene_) != 0;
  if (begun_ && in_goal && !in_goal_) happened.emplace_back("goal");
  in_goal_ = in_goal;
  begun_ = true;
  return happened;
}

}  // namespace murosimf::recording
