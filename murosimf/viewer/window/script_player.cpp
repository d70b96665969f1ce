#include "murosimf/viewer/window/script_player.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::viewer {
namespace {

using Kind = ScriptStep::Kind;

constexpr double longest_run = 300;  // [s] of wall time limit of `until`
constexpr double longest_pause = 5;  // [s] limit of waiting while time stands still
constexpr double longest_look = 3;   // [s] limit of the search for an item of a panel
constexpr int moves = 6;             // pictures per drag
constexpr int left_button = 0, right_button = 1;

double since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

Pixel in_window(const Pixel& pixel, const Area& area) { return {area.x + pixel.x, area.y + pixel.y}; }

}  // namespace

/// Steps become inputs of several frames, as those of a hand.
std::vector<Input> ScriptPlayer::next(const Stage& stage) {
  while (frames_.empty() && at_ < steps_.size()) {
    const ScriptStep& step = steps_[at_];
    if (!since_) since_ = WallClock::now();
    if (!with_context(step.where, [&] { return begin(step, stage); })) return {};
    since_.reset();
    ++at_;
  }
  if (frames_.empty()) return {};
  std::vector<Input> inputs = std::move(frames_.front());
  for (Input& input : inputs) {
    if (auto* button = std::get_if<ButtonInput>(&input)) button->time = input_clock();
  }
  frames_.pop_front();
  return inputs;
}

std::optional<std::string> ScriptPlayer::wanted_screenshot() {
  return frames_.empty() ? std::exchange(screenshot_, std::nullopt) : std::nullopt;
}

bool ScriptPlayer::begin(const ScriptStep& step, const Stage& stage) {
  Viewer& viewer = stage.viewer;
  switch (step.kind) {
    case Kind::wait: return since(*since_) >= step.numbers[0];
    case Kind::until:
      if (since(*since_) > longest_run) throw SetupError(fmt::format("it did not come to {:g} s", step.numbers[0]));
      if (seconds(viewer.status().time) >= step.numbers[0]) return true;
      if (viewer.status().paused && since(*since_) > longest_pause) {
        throw SetupError(fmt::format("it is paused at {:g} s", seconds(viewer.status().time)));
      }
      return false;
    case Kind::settle:
      viewer.settle();
      frames(2);
      return true;
    case Kind::key: key(read_chord(step.text)); return true;
    case Kind::click: click(where(step, stage), 1); return true;
    case Kind::double_click: click(where(step, stage), 2); return true;
    case Kind::press: return press_item(step, stage);
    case Kind::drag:
    case Kind::push:
    case Kind::twist: drag_thing(step, stage); return true;
    case Kind::type:
      for (const char letter : step.text) frame({TextInput{static_cast<unsigned char>(letter)}});
      key({.key = "Enter"});
      return true;
    case Kind::scrub: {
      const Area& line = stage.panels.timeline;
      if (line.width <= 0) return false;  // not drawn yet
      const Pixel to{line.x + step.numbers[0] / stage.panels.timeline_end * line.width, line.y + line.height - 4};
      pull({to.x + 1, to.y}, to, nullptr, left_button);
      return true;
    }
    case Kind::look:
      viewer.rig.set_mode(CameraRig::Mode::free);
      viewer.rig.orbit.azimuth = step.numbers[0] * pi / 180;
      viewer.rig.orbit.elevation = step.numbers[1] * pi / 180;
      viewer.rig.orbit.distance = step.numbers[2];
      if (viewer.selected()) viewer.rig.orbit.target = viewer.poses().place_of(*viewer.selected()).value_or(Vec3d{});
      frames(2);
      return true;
    case Kind::screenshot:
      screenshot_ = step.text;
      frames(3);
      return true;
    case Kind::say: viewer.tell(step.text); return true;
  }
  return true;
}

/// In coordinates of the window.
Pixel ScriptPlayer::where(const ScriptStep& step, const Stage& stage) const {
  if (step.text.empty()) return {step.numbers[0], step.numbers[1]};
  const auto place = stage.viewer.poses().place_of(stage.viewer.outline().path_of(step.text));
  const auto pixel = place ? pixel_of(stage.view, *place) : std::nullopt;
  if (!pixel || !stage.area.holds(in_window(*pixel, stage.area)))
    throw SetupError(fmt::format("'{}' is not in the picture", step.text));
  return in_window(*pixel, stage.area);
}

/// Items may appear some frames later: they are waited for, but not without end.
bool ScriptPlayer::press_item(const ScriptStep& step, const Stage& stage) {
  if (const auto place = stage.gui.place_of(step.text)) {
    click(*place, 1);
    frames(2);
    return true;
  }
  if (since(*since_) < longest_look) return false;
  const std::vector<std::string> names = stage.gui.names();
  throw SetupError(unknown_name("item of the window", step.text, {names.begin(), names.end()}));
}

void ScriptPlayer::key(const KeyChord& chord) {
  frame({KeyInput{chord, true, false}});
  frame({KeyInput{chord, false, false}, KeyInput{{.key = "Ctrl"}, false, false}});
  frames(1);
}

/// The pointer rests for a frame before and after the click: ImGui needs both.
void ScriptPlayer::click(const Pixel& pixel, int times) {
  frame({MoveInput{pixel}});
  frames(1);
  for (int i = 0; i < times; ++i) {
    frame({ButtonInput{0, true}});
    frame({ButtonInput{0, false}});
  }
  frames(1);
}

void ScriptPlayer::pull(const Pixel& from, const Pixel& to, const char* held, int button) {
  frame({MoveInput{from}});
  KeyChord chord{.key = held ? held : "Ctrl"};
  chord.ctrl = held && chord.key == "Ctrl";
  chord.shift = held && chord.key == "Shift";
  frame({KeyInput{chord, held != nullptr, false}});
  frame({ButtonInput{button, true}});
  for (int i = 1; i <= moves; ++i) {
    const double share = static_cast<double>(i) / moves;
    frame({MoveInput{{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}}});
  }
  frames(2);
  frame({ButtonInput{button, false}});
  frame({KeyInput{{.key = chord.key}, false, false}});
}

void ScriptPlayer::drag_thing(const ScriptStep& step, const Stage& stage) {
  const ObjectPath path = stage.viewer.outline().path_of(step.text);
  const Pixel from = where(step, stage);
  const auto hit = stage.pick({from.x - stage.area.x, from.y - stage.area.y});
  if (!hit || !hit->path || hit->path->entity != path.entity)
    throw SetupError(fmt::format("something hides '{}'", step.text));
  Vec3d way{step.numbers[0], step.numbers[1], 0};
  if (step.kind != Kind::drag) {
    way.z = step.numbers[2];
  } else {
    const Vec3d now = stage.viewer.poses().place_of({path.entity, 0}).value_or(hit->point);
    way = {way.x - now.x, way.y - now.y, 0};
  }
  const auto to = pixel_of(stage.view, hit->point + way);
  if (!to) throw SetupError("that place is behind the eye");
  pull(from, in_window(*to, stage.area), step.kind == Kind::drag ? "Shift" : "Ctrl",
       step.kind == Kind::push ? right_button : left_button);
}

}  // namespace murosimf::viewer
