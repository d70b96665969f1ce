// The strip at the top: run, pause, step, speed; and help.
#include <fmt/format.h>

#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

void speed_choice(Panels& panels) {
  const auto& status = panels.viewer.status();
  const std::vector<std::string> names{"1/10", "1/4", "1/2", "1", "2", "5", "10", "max"};
  const std::vector<std::optional<double>> speeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, std::nullopt};
  ImGui::SetNextItemWidth(5 * ImGui::GetFontSize());
  const std::string now = status.speed ? fmt::format("x {:g}", *status.speed) : "max";
  if (const auto chosen = panels.gui.choice("speed", now, names)) panels.viewer.session().set_speed(speeds[*chosen]);
  tip("wanted speed, in simulated seconds per second");
}

}  // namespace

void begin_part(const char* name, const Area& area) {
  ImGui::SetNextWindowPos(vec2(area.x, area.y));
  ImGui::SetNextWindowSize(vec2(area.width, area.height));
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
}

/// Every button shows its key, from the map that the user may have changed.
void toolbar(Panels& panels, const Area& area) {
  begin_part("toolbar", area);
  Viewer& viewer = panels.viewer;
  const auto& status = viewer.status();
  const auto does = [&](const char* name, Action action) {
    if (panels.gui.button(name)) viewer.perform(action);
    tip(fmt::format("{}: {}", panels.keys.keys_of(action), info_of(action).meaning));
    ImGui::SameLine();
  };
  does("Reset", Action::reset);
  does("Back", Action::step_back);
  does(status.paused ? "Run" : "Pause", Action::run_or_pause);
  does("Step", Action::step);
  if (status.recorded) does(*status.recorded ? "Record no more" : "Record", Action::record);
  speed_choice(panels);
  ImGui::SameLine();
  text(fmt::format("{:.3f} s", seconds(status.time)));
  ImGui::SameLine();
  text(status.paused ? "paused" : fmt::format("x {:.2f} measured", status.factor),
       status.paused ? Color{1, 0.8, 0.4} : Color{0.6, 0.9, 0.6});
  ImGui::SameLine();
  text(fmt::format("{:.0f} pictures/s", panels.state.frames_per_second), faint);
  const char* mode = viewer.rig.mode() == CameraRig::Mode::robot ? "through the robot's camera"
                     : viewer.rig.mode() == CameraRig::Mode::tv  ? "television"
                     : viewer.rig.follows && viewer.selected()   ? "follows what is selected"
                                                                 : "";
  ImGui::SameLine();
  text(mode, {0.6, 0.8, 1});
  const float right = static_cast<float>(area.width) - 11 * ImGui::GetFontSize();
  if (ImGui::GetCursorPosX() < right) {
    ImGui::SameLine(right);
    does("View next", Action::next_camera);
    does("TV", Action::tv_camera);
    does("Keys", Action::help);
  }
  ImGui::End();
}

void help_window(Panels& panels, const Area& area) {
  ImGui::SetNextWindowPos(vec2(area.x + 0.5 * area.width, area.y + 0.5 * area.height), ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSize(vec2(std::min(area.width - 10, scaled(760)), area.height - 20));
  ImGui::Begin("Keys and mouse", &panels.viewer.window.help,
               ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize);
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    const auto row = [](const std::string& key, std::string_view meaning) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      text(key, {1, 0.85, 0.5});
      ImGui::TableNextColumn();
      text(std::string(meaning));
    };
    row("click, double click", "select; select and look at it");
    row("drag left, right; wheel", "turn about the middle, move; nearer and farther");
    row("Ctrl and right drag", "push what is there, along the plane of the picture");
    row("Ctrl and left drag", "turn what is there, as if its front were pulled");
    row("Shift and drag", "move a robot, the ball or a body, while it is paused");
    row("right double click", "look at that place; with Ctrl: follow it");
    for (const ActionInfo& info : actions()) {
      if (info.action > Action::select_1 && info.action <= Action::select_9) continue;
      const bool first = info.action == Action::select_1;
      row(panels.keys.keys_of(info.action) + (first ? " to " + panels.keys.keys_of(Action::select_9) : std::string()),
          first ? "select a robot, by its place in the scene" : info.meaning);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace murosimf::viewer
