// The selection: its properties, sensors and cameras; algorithms; contents of the picture.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

void object_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  if (!viewer.selected()) return text("Nothing is selected: click on something.", faint);
  const ObjectPath path = *viewer.selected();
  viewer.open_objects[path] = true;
  text(viewer.outline().path_text(path));
  ImGui::SameLine();
  if (panels.gui.button("carried by")) viewer.perform(Action::select_parent);
  properties_of(panels, path);
}

void camera_view(const CameraState& camera, const imaging::ColorImage& picture, Texture& texture) {
  texture.fill(picture);
  if (texture.name() == 0) return;
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::Image((ImTextureID) static_cast<std::intptr_t>(texture.name()),
               vec2(width, width * texture.height() / std::max(1, texture.width())));
  const auto& spec = camera.info->lens.spec();
  text(fmt::format("{}: {}x{} px, {}", camera.info->name, spec.width, spec.height,
                   camera.picture.empty() ? "not read by software: shown as a pinhole camera sees it"
                                          : fmt::format("picture of {:.3f} s", camera.time)),
       faint);
}

/// The outputs of a sensor follow each other in one row of numbers.
void sensor_rows(Panels& panels, const SensorState& sensor) {
  std::size_t first = 0;
  for (const sensors::Output& output : sensor.info->outputs) {
    const std::string name = sensor.info->name + "." + output.name;
    ImGui::PushID(name.c_str());
    if (panels.gui.button("plot"))
      panels.viewer.plots.add(panels.viewer.outline(), {panels.viewer.selected_entity(), 0}, name, true);
    panels.gui.remember("plot " + name);
    ImGui::SameLine();
    std::string line = fmt::format("{} [{}] ", output.name, output.unit);
    for (std::size_t i = 0; i < output.size() && i < 6; ++i) line += " " + number_text(sensor.values[first + i]);
    if (output.size() > 6) line += fmt::format(" ... ({})", output.size());
    text(line);
    first += output.size();
    ImGui::PopID();
  }
}

/// Long rows like laser fans as a curve over their indices.
void row_picture(const SensorState& sensor) {
  std::size_t first = 0;
  for (const sensors::Output& output : sensor.info->outputs) {
    if (output.size() > 12) {
      Plot plot{output.name, output.unit, {Curve(output.size() + 1)}};
      for (std::size_t i = 0; i < output.size(); ++i)
        plot.curves[0].add(static_cast<double>(i), sensor.values[first + i]);
      draw_plot(plot, static_cast<double>(output.size()), static_cast<double>(output.size()),
                ImGui::GetContentRegionAvail().x, scaled(90));
    }
    first += output.size();
  }
}

/// The place of the tab is remembered, so that scripts find it by name.
void tab(Panels& panels, const char* name, bool& open, const auto& draw) {
  open = ImGui::BeginTabItem(name);
  panels.gui.remember(name);
  if (!open) return;
  ImGui::BeginChild(name);
  draw();
  ImGui::EndChild();
  ImGui::EndTabItem();
}

/// Groups of drawings, each with a switch.
void drawing_boxes(Panels& panels) {
  Viewer& viewer = panels.viewer;
  if (!viewer.overlay.drawings) return;
  for (const std::string& group : viewer.drawing_groups()) {
    bool shown = !viewer.drawings.hidden.contains(group);
    if (!panels.gui.checkbox(group, shown)) continue;
    if (shown) {
      viewer.drawings.hidden.erase(group);
    } else {
      viewer.drawings.hidden.insert(group);
    }
  }
}

}  // namespace

/// Joints can be moved while the run is paused only: the controller would move them back.
void joints_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  const std::vector<MovableJoint> joints = viewer.joints();
  if (joints.empty()) return text("Select a robot: its joints are shown here.", faint);
  const bool movable = viewer.status().paused && !viewer.recorded();
  text(movable ? "rad, of wheels and sliders m" : "Pause (Space) to move joints.", faint);
  ImGui::BeginDisabled(!movable);
  for (const MovableJoint& joint : joints) {
    auto position = static_cast<float>(joint.position);
    ImGui::SetNextItemWidth(0.55F * ImGui::GetContentRegionAvail().x);
    if (ImGui::SliderFloat(joint.name.c_str(), &position, static_cast<float>(joint.lowest),
                           static_cast<float>(joint.highest), "%.3f")) {
      viewer.steering.move_joint(joint.path, position);
    }
    panels.gui.remember("joint " + joint.name);
  }
  ImGui::EndDisabled();
}

void sensors_tab(Panels& panels, std::vector<std::unique_ptr<Texture>>& camera_pictures) {
  const Viewer& viewer = panels.viewer;
  if (viewer.selected_entity() < 0) return text("Select a robot: its sensors and cameras are shown here.", faint);
  if (viewer.recorded()) return text("Of recordings, 'murosimf plot' shows sensors.", faint);
  const Inspection& seen = viewer.seen();
  if (seen.sensors_of != viewer.selected_entity()) return text("...", faint);
  if (seen.sensors.empty()) text("It has no sensors.", faint);
  for (std::size_t i = 0; i < seen.cameras.size(); ++i) {
    while (camera_pictures.size() <= i) camera_pictures.push_back(std::make_unique<Texture>());
    if (i < panels.state.camera_pictures.size())
      camera_view(seen.cameras[i], panels.state.camera_pictures[i], *camera_pictures[i]);
  }
  for (const SensorState& sensor : seen.sensors) {
    const std::string title = fmt::format("{} ({})###{}", sensor.info->name, sensor.info->type, sensor.info->name);
    const bool open = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    panels.gui.remember(sensor.info->name);
    if (!open) continue;
    text(fmt::format("sample {} of {:.3f} s", sensor.samples, sensor.time), faint);
    ImGui::PushID(sensor.info->name.c_str());
    sensor_rows(panels, sensor);
    row_picture(sensor);
    ImGui::PopID();
  }
}

void algorithms_tab(Panels& panels) {
  const auto& algorithms = panels.viewer.seen().algorithms;
  if (!ImGui::BeginTable("algorithms", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("algorithm", ImGuiTableColumnFlags_WidthStretch);
  for (const char* column : {"Hz", "calls", "us each"}) ImGui::TableSetupColumn(column);
  ImGui::TableHeadersRow();
  double all = 0;
  for (const AlgorithmStatistics& one : algorithms) {
    ImGui::TableNextRow();
    for (const std::string& cell : {one.name, fmt::format("{:g}", one.rate_hz), fmt::format("{}", one.calls),
                                    fmt::format("{:.2f}", one.us_per_call)}) {
      ImGui::TableNextColumn();
      text(cell);
    }
    all += static_cast<double>(one.calls) * one.us_per_call * 1e-6;
  }
  ImGui::EndTable();
  text(fmt::format("{:.2f} s of processor time in all", all), faint);
}

void view_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  const auto box = [&](Action action, bool& value) {
    panels.gui.checkbox(std::string(info_of(action).meaning), value);
    tip(panels.keys.keys_of(action));
  };
  text("Over the picture", faint);
  OverlayOptions& overlay = viewer.overlay;
  for (const auto& [action, value] :
       std::initializer_list<std::pair<Action, bool*>>{{Action::contacts, &overlay.contacts},
                                                       {Action::forces, &overlay.forces},
                                                       {Action::centers_of_mass, &overlay.centers_of_mass},
                                                       {Action::support_polygons, &overlay.support_polygons},
                                                       {Action::zero_moment_points, &overlay.zero_moment_points},
                                                       {Action::joint_loads, &overlay.joint_loads},
                                                       {Action::beliefs, &overlay.beliefs},
                                                       {Action::standing_feet, &overlay.standing_feet},
                                                       {Action::levels, &overlay.levels},
                                                       {Action::names, &overlay.names},
                                                       {Action::frames, &overlay.frames},
                                                       {Action::bounding_volumes, &overlay.bounding_volumes},
                                                       {Action::field_map, &viewer.window.field_map},
                                                       {Action::drawings, &overlay.drawings}}) {
    box(action, *value);
  }
  drawing_boxes(panels);
  auto scale = static_cast<float>(1000 * overlay.force_scale);
  if (ImGui::SliderFloat("mm per N", &scale, 0.1F, 100, "%.1f", ImGuiSliderFlags_Logarithmic))
    overlay.force_scale = 1e-3 * scale;
  text("Pushes (Ctrl and right drag; left turns)", faint);
  auto gain = static_cast<float>(viewer.newtons_per_meter), time = static_cast<float>(viewer.steering.push_seconds),
       turning = static_cast<float>(viewer.newton_meters_per_meter);
  if (ImGui::SliderFloat("N per m", &gain, 1, 5000, "%.0f", ImGuiSliderFlags_Logarithmic))
    viewer.newtons_per_meter = gain;
  if (ImGui::SliderFloat("N m per m", &turning, 0.1F, 1000, "%.1f", ImGuiSliderFlags_Logarithmic))
    viewer.newton_meters_per_meter = turning;
  if (ImGui::SliderFloat("s", &time, 0.01F, 2, "%.2f", ImGuiSliderFlags_Logarithmic))
    viewer.steering.push_seconds = time;
  text("Picture", faint);
  bool smooth = panels.state.quality.samples > 1;
  if (panels.gui.checkbox("smooth edges", smooth)) panels.state.quality.samples = smooth ? 4 : 1;
  panels.gui.checkbox("shadows", panels.state.quality.shadows);
  ImGui::PushTextWrapPos();
  text("drawn by " + panels.state.drawn_by, faint);
  ImGui::PopTextWrapPos();
}

void right_panel(Panels& panels, const Area& area, std::vector<std::unique_ptr<Texture>>& camera_pictures) {
  begin_part("right", area);
  Viewer& viewer = panels.viewer;
  bool open = false;
  if (ImGui::BeginTabBar("right tabs", ImGuiTabBarFlags_FittingPolicyResizeDown)) {
    tab(panels, "Object", open, [&] { object_tab(panels); });
    tab(panels, "Joints", open, [&] { joints_tab(panels); });
    tab(panels, "Sensors", open, [&] { sensors_tab(panels, camera_pictures); });
    viewer.wants_pictures = open;
    tab(panels, "Plots", open, [&] { plots_tab(panels); });
    tab(panels, "Cost", open, [&] { algorithms_tab(panels); });
    viewer.wants_algorithms = open;
    tab(panels, "Events", open, [&] { events_tab(panels); });
    tab(panels, "View", open, [&] { view_tab(panels); });
    ImGui::EndTabBar();
  }
  ImGui::End();
}

}  // namespace murosimf::viewer
