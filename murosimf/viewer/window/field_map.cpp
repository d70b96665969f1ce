// The field from above in a corner of the picture: all robots with number and heading, the ball; click to select.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/model/properties.h"
#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

/// From the field to the window: x to the right, y upwards.
struct Map {
  double x, y, pixels;  // [px] of the middle, per meter
  [[nodiscard]] ImVec2 at(const Vec3d& place) const { return vec2(x + pixels * place.x, y - pixels * place.y); }
};

const Markings* markings_of(const Viewer& viewer) {
  for (const EntityOutline& outline : viewer.outline()) {
    for (const int i : outline.model->having(properties::markings)) return outline.model->find(properties::markings, i);
  }
  return nullptr;
}

void draw_robot(ImDrawList& list, const Map& map, const Vec3d& place, double turn, const EntityOutline& outline,
                bool selected) {
  const double size = std::max(scaled(5), 0.16 * map.pixels);
  const ImVec2 middle = map.at(place);
  const auto around = [&](double angle, double radius) {
    return vec2(middle.x + radius * std::cos(turn + angle), middle.y - radius * std::sin(turn + angle));
  };
  list.AddTriangleFilled(around(0, 2.2 * size), around(1.2, size), around(-1.2, size), packed(outline.color));
  list.AddCircleFilled(middle, static_cast<float>(size), packed(outline.color));
  list.AddCircle(middle, static_cast<float>(size + 1), selected ? IM_COL32_WHITE : IM_COL32(0, 0, 0, 160), 0,
                 selected ? 2.5F : 1);
  const std::string number = fmt::format("{}", appearance::jersey_number(outline.name));
  const ImVec2 extent = ImGui::CalcTextSize(number.c_str());
  if (extent.y < 2.6 * size)
    list.AddText(vec2(middle.x - 0.5 * extent.x, middle.y - 0.5 * extent.y), IM_COL32_WHITE, number.c_str());
}

}  // namespace

void field_map(Panels& panels, const Area& area) {
  Viewer& viewer = panels.viewer;
  const Markings* markings = markings_of(viewer);
  const PoseFrame* frame = viewer.poses().frame();
  if (!markings || !frame || markings->half_length <= 0) return;
  const double width = std::min(scaled(260), 0.4 * area.width),
               height = width * markings->half_width / markings->half_length;
  const Area place{area.x + area.width - width - 10, area.y + 10, width, height};
  ImGui::SetNextWindowPos(vec2(place.x, place.y));
  ImGui::SetNextWindowSize(vec2(place.width, place.height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec2(0, 0));
  ImGui::Begin("map", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Map map{place.x + 0.5 * width, place.y + 0.5 * height, 0.5 * width / markings->half_length};
  list.AddRectFilled(vec2(place.x, place.y), vec2(place.x + width, place.y + height), IM_COL32(38, 92, 46, 215), 4);
  for (const Stroke& stroke : markings->strokes) {
    std::vector<ImVec2> points;
    for (const Vec3d& point : stroke.points) points.push_back(map.at(point));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), IM_COL32(255, 255, 255, 150), 0, 1);
  }
  ImGui::InvisibleButton("field", vec2(width, height));
  const bool clicked = ImGui::IsItemClicked();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::size_t count = std::min(viewer.outline().size(), frame->present.size());
  double nearest = scaled(14);  // [px]
  for (std::size_t i = 0; i < count; ++i) {
    const EntityOutline& outline = viewer.outline()[i];
    if (!outline.moves || !frame->present[i]) continue;
    const Vec3d& r = frame->position[frame->first[i]];
    const bool selected = viewer.selected_entity() == static_cast<int>(i);
    if (outline.is_robot) {
      draw_robot(list, map, r, heading(frame->orientation[frame->first[i]]), outline, selected);
    } else {
      list.AddCircleFilled(map.at(r), static_cast<float>(std::max(scaled(3), 0.08 * map.pixels)),
                           packed(outline.color));
      list.AddCircle(map.at(r), static_cast<float>(std::max(scaled(4), 0.08 * map.pixels + 1)),
                     selected ? IM_COL32_WHITE : IM_COL32(0, 0, 0, 160));
    }
    const ImVec2 at = map.at(r);
    if (clicked && std::hypot(at.x - mouse.x, at.y - mouse.y) < nearest) {
      nearest = std::hypot(at.x - mouse.x, at.y - mouse.y);
      viewer.select(ObjectPath{static_cast<int>(i), 0});
    }
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace murosimf::viewer
