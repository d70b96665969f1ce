#include "murosimf/drawing/sketch_pad.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/world/setup.h"

namespace murosimf::drawing {
namespace {

bool is_finite(const DrawnShape& shape) {
  const auto finite = [](const Vec3d& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  const auto share = [](double x) { return x >= 0 && x <= 1; };
  return std::ranges::all_of(shape.points, finite) && std::isfinite(shape.size) && shape.size >= 0 &&
         share(shape.color.red) && share(shape.color.green) && share(shape.color.blue) && share(shape.opacity);
}

}  // namespace

SketchPad::SketchPad(Setup& setup) : drawings_(&setup.write(properties::drawings)[0]) {}

std::string SketchPad::why_not(const DrawnGroup& group) const {
  const auto is_new = [&] {
    return std::ranges::find(drawings_->groups, group.name, &DrawnGroup::name) == drawings_->groups.end();
  };
  if (group.name.size() > longest_text) return "a group's name is too long";
  if (group.shapes.size() > most_shapes) {
    return fmt::format("a group has {} shapes; {} are allowed", group.shapes.size(), most_shapes);
  }
  std::size_t points = 0;
  for (const DrawnShape& shape : group.shapes) {
    points += shape.points.size();
    if (shape.points.empty() || shape.kind >= DrawnShape::kinds)
      return "a shape has no points, or is of an unknown kind";
    if (!is_finite(shape)) return "a shape has numbers that are not finite, or colors that are not from 0 to 1";
    if (shape.words.size() > longest_text) return "a text is too long";
  }
  if (points > most_points) return fmt::format("a group has {} points; {} are allowed", points, most_points);
  // A group of a known name replaces the old one, and needs no new place.
  if (drawings_->groups.size() >= most_groups && is_new()) return fmt::format("more than {} groups", most_groups);
  return {};
}

bool SketchPad::draw(DrawnGroup group) {
  refusal_ = why_not(group);
  if (!refusal_.empty()) return false;
  auto& groups = drawings_->groups;
  // Sorted by name: reports and recordings have one order.
  const auto place = std::ranges::lower_bound(groups, group.name, {}, &DrawnGroup::name);
  const bool there = place != groups.end() && place->name == group.name;
  if (group.shapes.empty()) {
    if (there) groups.erase(place);
  } else if (there) {
    *place = std::move(group);
  } else {
    groups.insert(place, std::move(group));
  }
  ++drawings_->changes;
  return true;
}

void SketchPad::clear() {
  if (drawings_->groups.empty()) return;
  drawings_->groups.clear();
  ++drawings_->changes;
}

}  // namespace murosimf::drawing
