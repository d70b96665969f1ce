/// gui.h - Dear ImGui, fed with the window's events, and the places of its items by their labels, so that a script can
/// press them.
///
/// Works with Dear ImGui 1.86 (Debian 12) and later. Only for the .cpp files of this folder: it includes ImGui.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "murosimf/model/shape.h"
#include "murosimf/viewer/window/glfw_window.h"

namespace murosimf::viewer {

inline constexpr double usual_letters = 15;  ///< [px] size of text where the scale is 1

class Gui {
 public:
  /// `scale`: of letters and everything else, 1 for 15 px.
  explicit Gui(double scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  void feed(const Input& input);
  /// From the next picture on; letters are rasterized for the initial scale, and stretched.
  void set_scale(double scale);
  /// Begins a picture of `width` x `height` [px], `wall` [s] after the last one.
  void begin(int width, int height, double wall);
  /// Draws it into the current context.
  void end();
  [[nodiscard]] bool wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
  [[nodiscard]] bool wants_text() const { return ImGui::GetIO().WantTextInput; }

  /// Registers the last item, if visible, under its label, or another name.
  void remember(const std::string& name);
  void remember(const std::string& name, const Pixel& place) { places_[name] = place; }
  [[nodiscard]] std::optional<Pixel> place_of(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const;

  // Items whose places are remembered.
  bool button(const std::string& name);
  bool checkbox(const std::string& name, bool& value);
  bool selectable(const std::string& name, bool selected);
  /// A drop-down list; returns the index of the choice.
  std::optional<std::size_t> choice(const std::string& name, const std::string& now,
                                    const std::vector<std::string>& names);

 private:
  void feed_pointer();

  double letters_scale_, scale_;
  std::map<std::string, Pixel> places_, last_places_;
  Pixel mouse_{-1, -1};
  std::vector<bool> buttons_{false, false, false};
  double wheel_ = 0;
};

[[nodiscard]] inline ImVec4 vec4(const Color& color, double alpha = 1) {
  return {static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue),
          static_cast<float>(alpha)};
}
[[nodiscard]] inline ImU32 packed(const Color& color, double alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32(vec4(color, alpha));
}
/// [px] of a length [px] at letters of default size: lengths scale with the letters.
[[nodiscard]] inline double scaled(double length) {
  return length * static_cast<double>(ImGui::GetFontSize()) / usual_letters;
}
[[nodiscard]] inline ImVec2 vec2(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
[[nodiscard]] inline ImVec2 vec2(const Pixel& pixel) { return vec2(pixel.x, pixel.y); }
/// Text without format specifiers.
inline void text(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }
inline void text(const std::string& line, const Color& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, vec4(color));
  text(line);
  ImGui::PopStyleColor();
}
/// A tooltip for the last item, while the mouse is over it.
inline void tip(const std::string& line) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  text(line);
  ImGui::EndTooltip();
}

}  // namespace murosimf::viewer
