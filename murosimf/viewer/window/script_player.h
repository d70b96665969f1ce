/// script_player.h - executes a script (script.h) by simulated input: its steps become inputs, picture by picture.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/viewer/script.h"
#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {

class ScriptPlayer {
 public:
  explicit ScriptPlayer(std::vector<ScriptStep> steps) : steps_(std::move(steps)) {}

  /// Present contents of the window.
  struct Stage {
    Viewer& viewer;
    const Gui& gui;
    const PanelState& panels;
    const sensors::Perspective& view;
    Area area;  ///< of the picture
    const MouseControl::Pick& pick;
  };
  /// Inputs for this picture; none while it waits, and at the end. Throws SetupError with the step's place if it fails.
  [[nodiscard]] std::vector<Input> next(const Stage& stage);
  /// File for the present picture; once.
  [[nodiscard]] std::optional<std::string> wanted_screenshot();
  [[nodiscard]] bool ended() const { return at_ >= steps_.size() && frames_.empty(); }

 private:
  using WallClock = std::chrono::steady_clock;
  /// Whether the step is complete; else it is called again with the next picture.
  bool begin(const ScriptStep& step, const Stage& stage);
  [[nodiscard]] Pixel where(const ScriptStep& step, const Stage& stage) const;
  bool press_item(const ScriptStep& step, const Stage& stage);
  void click(const Pixel& pixel, int times);
  void pull(const Pixel& from, const Pixel& to, const char* held, int button);
  void key(const KeyChord& chord);
  void frame(std::vector<Input> inputs) { frames_.push_back(std::move(inputs)); }
  void frames(int count) { frames_.resize(frames_.size() + static_cast<std::size_t>(count)); }
  void drag_thing(const ScriptStep& step, const Stage& stage);

  std::vector<ScriptStep> steps_;
  std::size_t at_ = 0;
  std::optional<WallClock::time_point> since_;  // start of waiting in the present step
  std::deque<std::vector<Input>> frames_;       // to come, one for each picture
  std::optional<std::string> screenshot_;
};

}  // namespace murosimf::viewer
