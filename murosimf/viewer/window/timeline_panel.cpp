// The timeline with its branches and marks; past events as a list; the last message.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

constexpr double message_time = 8;  // [s] for which a message is shown

double row_height() { return std::round(scaled(13)); }  // [px] of a branch

Color color_of(TimeMark::Kind kind) {
  switch (kind) {
    case TimeMark::Kind::fall: return {1, 0.45, 0.3};
    case TimeMark::Kind::goal: return {1, 0.9, 0.3};
    case TimeMark::Kind::warning: return {1, 0.7, 0.3};
    case TimeMark::Kind::touch: return {0.6, 0.8, 1};
    case TimeMark::Kind::event: break;
  }
  return {0.75, 0.78, 0.8};
}

/// The last target, so that dragging within a pixel makes no further requests.
void scrub(Panels& panels, const TimelineLayout& layout, const Area& area) {
  PanelState& state = panels.state;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int row = layout.rows() - 1 - static_cast<int>(std::floor((mouse.y - area.y) / row_height()));
  const auto place = layout.place_at(mouse.x - area.x, row);
  const double time = std::round(place.time * 1000) / 1000;
  if (time == state.scrubbed_to && place.branch == state.scrubbed_branch) return;
  state.scrubbed_to = time;
  state.scrubbed_branch = place.branch;
  panels.viewer.steering.seek(std::min(time, place.time), place.branch);
}

/// Branches begin at their parent's bar, so that it is seen where they left it.
void draw_bars(const TimelineLayout& layout, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const BranchBar& bar : layout.bars()) {
    const double y = area.y + area.height - (bar.row + 1) * row_height() + scaled(2);
    const ImVec2 low = vec2(area.x + layout.x_of(bar.begin), y),
                 high = vec2(area.x + std::max(layout.x_of(bar.end), layout.x_of(bar.begin) + 2),
                             y + row_height() - scaled(4));
    const Color color = bar.row == 0 ? Color{0.3, 0.55, 0.85} : Color{0.38, 0.4, 0.44};
    list.AddRectFilled(low, high, packed(color), 2);
    if (bar.row > 0) list.AddLine(low, vec2(low.x, area.y + area.height - row_height()), packed(color), 1);
  }
}

/// Whether the mouse is over one of them and has clicked it.
void draw_marks(Panels& panels, const TimelineLayout& layout, const Area& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const TimeMark* near = nullptr;
  for (const TimeMark& mark : panels.viewer.events().marks()) {
    const double x = area.x + layout.x_of(mark.time),
                 y = area.y + area.height - (layout.row_at(mark.branch, mark.time) + 1) * row_height();
    const ImU32 color = packed(color_of(mark.kind));
    list.AddTriangleFilled(vec2(x, y + scaled(3)), vec2(x - scaled(4), y - scaled(4)),
                           vec2(x + scaled(4), y - scaled(4)), color);
    if (std::abs(mouse.x - x) < scaled(5) && std::abs(mouse.y - y) < scaled(8)) near = &mark;
  }
  if (!near) return;
  ImGui::BeginTooltip();
  text(fmt::format("{:.3f} s: {}", near->time, near->text));
  ImGui::EndTooltip();
}

void draw_scale(const TimelineLayout& layout, const Area& area, double now) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const double time : ticks(0, layout.end(), static_cast<int>(area.width / scaled(90)))) {
    const double x = area.x + layout.x_of(time);
    list.AddLine(vec2(x, area.y), vec2(x, area.y + area.height), IM_COL32(255, 255, 255, 24));
    // ticks are multiples, and the first one may be a negative zero
    const std::string label = std::abs(time) < 1e-9 ? std::string("0 s") : fmt::format("{:g} s", time);
    list.AddText(vec2(x + scaled(3), area.y + area.height + 1), packed(faint), label.c_str());
  }
  const double x = area.x + layout.x_of(now);
  list.AddLine(vec2(x, area.y - 2), vec2(x, area.y + area.height + 2), IM_COL32(255, 255, 255, 255), 2);
}

void message_line(const Viewer& viewer) {
  if (viewer.messages().empty()) return text("F1: keys and mouse", faint);
  const Message& last = viewer.messages().back();
  const double age = std::chrono::duration<double>(std::chrono::steady_clock::now() - last.when).count();
  text(last.text, last.error ? Color{1, 0.6, 0.4} : age < message_time ? Color{0.85, 0.9, 0.95} : faint);
}

}  // namespace

void timeline_panel(Panels& panels, const Area& area) {
  begin_part("timeline", area);
  Viewer& viewer = panels.viewer;
  message_line(viewer);
  const auto& status = viewer.status();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const double width = ImGui::GetContentRegionAvail().x;
  const double margin = scaled(40);  // right of the strip, for the last time
  const TimelineLayout layout(viewer.branches(), status.branch, seconds(std::max(status.time, status.last)),
                              width - margin);
  const int most_rows = std::max(1, static_cast<int>((area.height - scaled(56)) / row_height()));
  const int rows = std::min(layout.rows(), most_rows);
  const Area strip{corner.x, corner.y + 2 + (most_rows - rows) * row_height(), width - margin, rows * row_height()};
  panels.state.timeline = strip;
  panels.state.timeline_end = layout.end();
  ImGui::InvisibleButton("times", vec2(width, most_rows * row_height() + 4));
  const bool over = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated()) {
    viewer.session().pause();
    panels.state.scrubs = true;
    panels.state.scrubbed_to = -1;
  }
  if (!ImGui::IsItemActive()) panels.state.scrubs = false;
  if (panels.state.scrubs) scrub(panels, layout, strip);
  draw_bars(layout, strip);
  draw_scale(layout, strip, seconds(status.time));
  draw_marks(panels, layout, strip);
  if (over && !panels.state.scrubs) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImGui::GetWindowDrawList()->AddLine(vec2(mouse.x, strip.y), vec2(mouse.x, strip.y + strip.height),
                                        IM_COL32(255, 255, 255, 70));
  }
  ImGui::End();
}

void events_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  text("Events: click to go there", faint);
  if (viewer.events().marks().empty()) text("none yet", faint);
  for (const TimeMark& mark : viewer.events().marks()) {
    const std::string line = fmt::format("{:8.3f} s  {}", mark.time, mark.text);
    ImGui::PushID(&mark);
    ImGui::PushStyleColor(ImGuiCol_Text, vec4(color_of(mark.kind)));
    if (panels.gui.selectable(line, false)) {
      viewer.session().pause();
      viewer.steering.seek(mark.time, mark.branch);
    }
    panels.gui.remember(mark.text);
    ImGui::PopStyleColor();
    tip(line);
    ImGui::PopID();
  }
  ImGui::Separator();
  text(fmt::format("Warnings: {}", viewer.events().warnings().size()), faint);
  ImGui::PushTextWrapPos();
  for (const std::string& warning : viewer.events().warnings()) text(warning, {1, 0.75, 0.45});
  ImGui::Separator();
  text("Messages", faint);
  for (auto message = viewer.messages().rbegin(); message != viewer.messages().rend(); ++message) {
    text(message->text, message->error ? Color{1, 0.6, 0.4} : Color{0.8, 0.85, 0.9});
  }
  ImGui::PopTextWrapPos();
}

}  // namespace murosimf::viewer
