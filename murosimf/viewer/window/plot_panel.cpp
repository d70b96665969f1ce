// Plots: numbers over simulated time.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

struct Frame {
  double x, y, width, height;    // [px]
  double begin, end, low, high;  // [s], values
  [[nodiscard]] ImVec2 at(double time, double value) const {
    return vec2(x + (time - begin) / (end - begin) * width, y + height - (value - low) / (high - low) * height);
  }
};

/// One scale for all curves of the plot.
Curve::Range range_of(const Plot& plot, double begin) {
  Curve::Range range{INFINITY, -INFINITY};
  for (const Curve& curve : plot.curves) {
    if (curve.times().empty()) continue;
    const Curve::Range own = curve.range(begin);
    range.low = std::min(range.low, own.low);
    range.high = std::max(range.high, own.high);
  }
  if (!(range.low <= range.high)) range = {};
  const double room =
      range.high > range.low ? 0.06 * (range.high - range.low) : std::max(1e-3, 0.1 * std::abs(range.high));
  return {range.low - room, range.high + room};
}

void draw_grid(ImDrawList& list, const Frame& frame) {
  const ImU32 line = IM_COL32(255, 255, 255, 28), letters = packed(faint);
  for (const double value : ticks(frame.low, frame.high, 4)) {
    const ImVec2 at = frame.at(frame.begin, value);
    list.AddLine(at, vec2(at.x + frame.width, at.y), line);
    const std::string number = number_text(std::abs(value) < 1e-12 ? 0 : value);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    list.AddText(vec2(at.x - size.x - scaled(4), at.y - 0.5 * size.y), letters, number.c_str());
  }
  for (const double time : ticks(frame.begin, frame.end, 4)) {
    const ImVec2 at = frame.at(time, frame.low);
    list.AddLine(at, vec2(at.x, at.y - frame.height), line);
    const std::string number = fmt::format("{:g} s", std::round(1000 * time) / 1000 + 0.0);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    if (at.x - 0.5 * size.x > frame.x && at.x + 0.5 * size.x < frame.x + frame.width + 8) {
      list.AddText(vec2(at.x - 0.5 * size.x, at.y + 2), letters, number.c_str());
    }
  }
}

/// A gap in the curve where a value is not finite.
void draw_curve(ImDrawList& list, const Frame& frame, const Curve& curve, ImU32 color) {
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < curve.times().size(); ++i) {
    if (curve.times()[i] < frame.begin || !std::isfinite(curve.values()[i])) continue;
    points.push_back(frame.at(curve.times()[i], curve.values()[i]));
  }
  if (points.size() > 1)
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, static_cast<float>(scaled(1.6)));
  if (points.size() == 1) list.AddCircleFilled(points[0], static_cast<float>(scaled(2)), color);
}

}  // namespace

std::string number_text(double number) { return fmt::format("{:.4g}", number); }

/// The newest instant is at the right; the grid moves with it.
void draw_plot(const Plot& plot, double now, double window, double width, double height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy(vec2(width, height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double letters = ImGui::GetFontSize(), left = 3.6 * letters;
  const double begin = std::max(0.0, now - window);
  const Curve::Range range = range_of(plot, begin);
  const Frame frame{corner.x + left,
                    corner.y + 2,
                    width - left - scaled(4),
                    height - letters - scaled(6),
                    begin,
                    std::max(now, begin + 1e-3),
                    range.low,
                    range.high};
  list.AddRectFilled(vec2(frame.x, frame.y), vec2(frame.x + frame.width, frame.y + frame.height),
                     IM_COL32(0, 0, 0, 90));
  draw_grid(list, frame);
  list.PushClipRect(vec2(frame.x, frame.y), vec2(frame.x + frame.width, frame.y + frame.height), true);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) draw_curve(list, frame, plot.curves[i], packed(curve_color(i)));
  list.PopClipRect();
}

void plots_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  auto seconds_shown = static_cast<float>(panels.state.plot_seconds);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##seconds", &seconds_shown, 1, 120, "last %.0f s", ImGuiSliderFlags_Logarithmic)) {
    panels.state.plot_seconds = seconds_shown;
  }
  if (viewer.plots.empty()) {
    ImGui::PushTextWrapPos();
    text("Nothing is plotted yet: press 'plot' beside a property (Object) or an output (Sensors).", faint);
    ImGui::PopTextWrapPos();
  }
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < viewer.plots.size(); ++i) {
    const PlotRequest& request = viewer.plots[i];
    ImGui::PushID(static_cast<int>(i));
    if (panels.gui.button("x")) removed = i;
    ImGui::SameLine();
    text(fmt::format("{} [{}]", request.plot.path, request.plot.unit));
    for (std::size_t n = 0; n < request.plot.curves.size() && n < 6; ++n) {
      const auto& values = request.plot.curves[n].values();
      if (n % 3 != 0) ImGui::SameLine();
      if (!values.empty()) text(number_text(values.back()), curve_color(n));
    }
    draw_plot(request.plot, seconds(viewer.status().time), panels.state.plot_seconds, ImGui::GetContentRegionAvail().x,
              scaled(150));
    ImGui::PopID();
  }
  if (removed) viewer.plots.remove(*removed);
}

}  // namespace murosimf::viewer
