// The viewer: what is drawn for people who watch, and joints that they move.
#include <algorithm>
#include <iterator>
#include <numbers>

#include "murosimf/drawing/drawn.h"
#include "murosimf/model/properties.h"
#include "murosimf/viewer/viewer.h"

namespace murosimf::viewer {
namespace {

std::string group_text(const drawing::Drawn& drawn, const DrawnGroup& group) { return drawn.by + "/" + group.name; }

/// [rad] of joints without a range.
constexpr double without_range = std::numbers::pi;

}  // namespace

std::vector<drawing::Drawn> Viewer::all_drawn() const {
  std::vector<drawing::Drawn> all = drawn_;
  if (!options_.others) return all;
  std::vector<std::string> teams;
  for (const EntityOutline& whom : outline_) teams.push_back(whom.team);
  std::ranges::move(drawing::external_drawings(*options_.others->shown(), teams), std::back_inserter(all));
  return all;
}

std::vector<render::SeenShape> Viewer::drawings_in(const sensors::Perspective& view) const {
  std::vector<render::SeenShape> shapes;
  if (!overlay.drawings || !frame_) return shapes;
  for (const drawing::Drawn& drawn : all_drawn()) {
    const auto entity = static_cast<std::size_t>(drawn.entity);
    const bool is_there = drawn.entity >= 0 && entity + 1 < frame_->first.size() && frame_->present[entity];
    for (const DrawnGroup& group : drawn.groups) {
      if (hidden_groups.contains(group_text(drawn, group)) || (group.of_robot && !is_there)) continue;
      Transformd at;
      if (group.of_robot) at = {frame_->position[frame_->first[entity]], frame_->orientation[frame_->first[entity]]};
      for (const DrawnShape& shape : group.shapes) render::see(shape, at, view, shapes);
    }
  }
  return shapes;
}

std::vector<std::string> Viewer::drawing_groups() const {
  std::set<std::string> names(hidden_groups);
  for (const drawing::Drawn& drawn : all_drawn()) {
    for (const DrawnGroup& group : drawn.groups) names.insert(group_text(drawn, group));
  }
  return {names.begin(), names.end()};
}

std::vector<MovableJoint> Viewer::joints() const {
  std::vector<MovableJoint> all;
  if (!selected_ || !frame_) return all;
  const auto entity = static_cast<std::size_t>(selected_->entity);
  if (entity + 1 >= frame_->first.size()) return all;
  const Model& model = *outline_[entity].model;
  for (const int object : model.joints()) {
    const auto row = static_cast<std::size_t>(object);
    const Vec3d* range = model.find(properties::joint_range, object);
    MovableJoint joint{.path = {selected_->entity, object},
                       .name = model.objects()[row].name,
                       .lowest = range ? range->x : -without_range,
                       .highest = range ? range->y : without_range};
    joint.position = frame_->joint_position[frame_->first[entity] + row];
    all.push_back(std::move(joint));
  }
  return all;
}

}  // namespace murosimf::viewer
