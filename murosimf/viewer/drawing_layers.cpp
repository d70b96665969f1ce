#include "murosimf/viewer/drawing_layers.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace murosimf::viewer {
namespace {

std::string group_text(const drawing::Drawn& drawn, const DrawnGroup& group) { return drawn.by + "/" + group.name; }

}  // namespace

void DrawingLayers::take(Inspection& seen) {
  if (seen.drawn) drawn_ = std::move(*seen.drawn);
  known_ = seen.drawings;
}

void DrawingLayers::forget() {
  drawn_.clear();
  known_ = 0;
}

std::vector<drawing::Drawn> DrawingLayers::all(const SceneOutline& outline) const {
  std::vector<drawing::Drawn> all = drawn_;
  if (!others_) return all;
  std::vector<std::string> teams;
  for (const EntityOutline& whom : outline) teams.push_back(whom.team);
  std::ranges::move(drawing::external_drawings(*others_->shown(), teams), std::back_inserter(all));
  return all;
}

std::vector<std::string> DrawingLayers::groups(const SceneOutline& outline) const {
  std::set<std::string> names(hidden);
  for (const drawing::Drawn& drawn : all(outline)) {
    for (const DrawnGroup& group : drawn.groups) names.insert(group_text(drawn, group));
  }
  return {names.begin(), names.end()};
}

std::vector<render::SeenShape> DrawingLayers::shapes_in(const sensors::Perspective& view, const ShownPoses& poses,
                                                        const SceneOutline& outline) const {
  std::vector<render::SeenShape> shapes;
  const PoseFrame* const frame = poses.frame();
  if (!frame) return shapes;
  for (const drawing::Drawn& drawn : all(outline)) {
    const bool is_there = poses.has(drawn.entity);
    for (const DrawnGroup& group : drawn.groups) {
      if (hidden.contains(group_text(drawn, group)) || (group.of_robot && !is_there)) continue;
      Transformd at;
      if (group.of_robot) {
        const std::size_t base = frame->first[static_cast<std::size_t>(drawn.entity)];
        at = {frame->position[base], frame->orientation[base]};
      }
      for (const DrawnShape& shape : group.shapes) render::see(shape, at, view, shapes);
    }
  }
  return shapes;
}

}  // namespace murosimf::viewer
