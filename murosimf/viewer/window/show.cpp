// The window's loop: inputs, their effects, a picture.
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/render/image_png.h"
#include "murosimf/viewer/window.h"
#include "murosimf/viewer/window/panels.h"
#include "murosimf/viewer/window/script_player.h"

namespace murosimf::viewer {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr double most_pictures = 60;        // [Hz] pictures
constexpr double calm_wait = 0.05;          // [s] waiting time of a paused window without input
constexpr double double_click_time = 0.35;  // [s]
constexpr double flying = 2;                // [m/s]
constexpr double fluent = 30;               // [Hz] pictures: below this, shadows are switched off
constexpr int judged_pictures = 60;         // before that decision
// [px] of a window at scale 1 in which all parts have their place; a smaller one has smaller letters, down to a scale of
constexpr double least_width = 1000, least_height = 560, least_scale = 1;

double seconds_since(WallClock::time_point then) {
  return std::chrono::duration<double>(WallClock::now() - then).count();
}

/// Settings that determine the picture of the scene.
struct Drawn {
  const PoseFrame* frame = nullptr;
  std::int64_t tick = -1;
  std::uint64_t jumps = 0;
  sensors::Perspective view;
  PictureQuality quality;
  bool feet = false;
  int changes = 0, generation = 0;
  [[nodiscard]] bool equals(const Drawn& other) const {
    const auto same = [](const Vec3d& a, const Vec3d& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    return frame == other.frame && tick == other.tick && jumps == other.jumps && same(view.eye, other.view.eye) &&
           same(view.axes.x, other.view.axes.x) && same(view.axes.z, other.view.axes.z) &&
           view.right == other.view.right && view.width == other.view.width && view.height == other.view.height &&
           view.without == other.view.without && quality == other.quality && feet == other.feet &&
           changes == other.changes && generation == other.generation;
  }
};

class Show {
 public:
  Show(Viewer& viewer, const WindowOptions& options)
      : viewer_(viewer),
        options_(options),
        window_(options.title, options.width, options.height),
        gui_(window_.scale()),
        mouse_(viewer) {
    if (options.script) player_.emplace(*options.script);
    window_.make_nobody_current();
    picture_.emplace(viewer);
    state_.quality = {options.samples.value_or(picture_->software() ? 1 : 4), options.shadows.value_or(true)};
    may_drop_shadows_ = picture_->software() && !options.shadows && !player_ && options.screenshot.empty();
    state_.drawn_by = report_.drawn_by = picture_->drawn_by();
    pick_ = [this](const Pixel& pixel) { return picture_->pick(view_, pixel); };
  }

  ~Show() {
    picture_.reset();
    window_.make_current();  // following calls belong to it
  }
  Show(const Show&) = delete;
  Show& operator=(const Show&) = delete;

  WindowReport run() {
    begin_ = last_ = WallClock::now();
    while (!ends()) make_picture();
    report_.wall = seconds_since(begin_);
    if (report_.pictures > 0) report_.scene_ms /= static_cast<double>(std::max<std::int64_t>(1, scenes_drawn_));
    return std::move(report_);
  }

 private:
  [[nodiscard]] bool ends() const {
    if (viewer_.window.wants_end || window_.wants_to_close() || (options_.stop && options_.stop())) return true;
    if (options_.after && after_taken_) return true;
    return player_ && player_->ended();
  }

  /// While nothing moves, the window waits for input and leaves the processor alone.
  void make_picture() {
    const bool calm = viewer_.status().paused && !player_ && !viewer_.busy() && queue_.empty();
    queue_.add(window_.inputs(calm ? calm_wait : 0));
    const double wall = seconds_since(last_);
    last_ = WallClock::now();
    arrange();
    viewer_.refresh(wall);
    fly(wall);
    view_ = viewer_.rig.view(viewer_.rig_view(), static_cast<int>(scene_.width), static_cast<int>(scene_.height));
    for (const Input& input : queue_.next()) take(input);
    if (player_) {
      for (const Input& input : player_->next({viewer_, gui_, state_, view_, scene_, pick_})) take(input);
    }
    view_ = viewer_.rig.view(viewer_.rig_view(), static_cast<int>(scene_.width), static_cast<int>(scene_.height));
    point();
    draw_scene();
    draw_cameras();
    window_.make_current();
    draw_window(wall);
    take_screenshots();
    window_.swap();
    window_.make_nobody_current();
    window_.set_full_screen(viewer_.window.full_screen);
    ++report_.pictures;
    if (is_new_ && may_drop_shadows_) judge_speed(seconds_since(last_));
    state_.frames_per_second += 0.05 * (1 / std::max(1e-3, wall) - state_.frames_per_second);
    const double left = 1 / most_pictures - seconds_since(last_);
    if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
  }

  /// `took`: [s] for a picture with a new scene. A choice of shadows by the user has precedence.
  void judge_speed(double took) {
    drawing_ += took;
    if (++judged_ < judged_pictures) return;
    may_drop_shadows_ = false;
    if (!state_.quality.shadows || drawing_ * fluent < judged_) return;
    state_.quality.shadows = false;
    viewer_.tell(fmt::format(
        "shadows are off: the processor draws, and came to {:.0f} pictures per second; View switches them on",
        judged_ / drawing_));
  }

  /// The parts keep their proportions; a small window gets smaller letters.
  void arrange() {
    const auto [width, height] = window_.size();
    width_ = std::max(width, 200);
    height_ = std::max(height, 150);
    const double s = std::clamp(std::min(width_ / least_width, height_ / least_height), least_scale, window_.scale());
    gui_.set_scale(s);
    top_ = {0, 0, static_cast<double>(width_), 34 * s};
    bottom_ = {0, height_ - 100 * s, static_cast<double>(width_), 100 * s};
    const double between = bottom_.y - top_.height,
                 left = viewer_.window.left_panel ? std::min(300 * s, 0.35 * width_) : 0;
    const double right = viewer_.window.right_panel ? std::min(356 * s, 0.35 * width_) : 0;
    left_ = {0, top_.height, left, between};
    right_ = {width_ - right, top_.height, right, between};
    scene_ = {std::floor(left), top_.height, std::max(16.0, std::floor(width_ - left - right)),
              std::floor(std::max(16.0, between))};
  }

  [[nodiscard]] Pixel in_scene(const Pixel& pixel) const { return {pixel.x - scene_.x, pixel.y - scene_.y}; }

  /// The panels take the input first; the scene gets what they leave.
  void take(const Input& input) {
    gui_.feed(input);
    if (const auto* key = std::get_if<KeyInput>(&input)) take_key(*key);
    if (const auto* move = std::get_if<MoveInput>(&input)) {
      pointer_ = move->place;
      mouse_.move(in_scene(pointer_), view_);
    }
    if (const auto* button = std::get_if<ButtonInput>(&input)) take_button(*button);
    if (const auto* wheel = std::get_if<WheelInput>(&input); wheel && !gui_.wants_mouse()) mouse_.wheel(wheel->clicks);
  }

  /// Keys belong to text fields while one of them is active.
  void take_key(const KeyInput& key) {
    held_ = {key.chord.ctrl, key.chord.shift, key.chord.alt};
    KeyChord alone{.key = key.chord.key};
    if (!key.pressed) flown_.erase(alone.key);
    if (!key.pressed || gui_.wants_text()) return;
    const auto action = options_.keys.action_of(key.chord);
    const auto plain = options_.keys.action_of(alone);
    if (plain && *plain >= Action::fly_forward && *plain <= Action::fly_down && !key.chord.ctrl) {
      flown_[alone.key] = *plain;
    } else if (action && (!key.again || *action == Action::step || *action == Action::step_back)) {
      viewer_.perform(*action);
    }
  }

  void take_button(const ButtonInput& input) {
    const auto button = static_cast<MouseControl::Button>(input.button);
    const Pixel at = in_scene(pointer_);
    if (!input.pressed) return mouse_.drags() ? mouse_.release(at, view_, pick_) : void();
    if (gui_.wants_mouse() || !scene_.holds(pointer_)) return;
    const bool again = button == pressed_button_ && pressed_ && input.time - *pressed_ < double_click_time &&
                       std::hypot(at.x - pressed_at_.x, at.y - pressed_at_.y) < scaled(4);
    pressed_ = again ? std::nullopt : std::optional(input.time);
    pressed_at_ = at;
    pressed_button_ = button;
    if (again) return mouse_.double_click(button, held_, at, pick_);
    mouse_.press(button, held_, at, view_, pick_);
  }

  /// The way depends on the time since the last picture, not on the number of pictures.
  void fly(double wall) {
    const double way = (held_.shift ? 4 : 1) * flying * wall;
    for (const auto& [key, action] : flown_) {
      viewer_.rig.set_mode(CameraRig::Mode::free);
      const auto along = [&](Action plus, Action minus) { return action == plus ? way : action == minus ? -way : 0; };
      viewer_.rig.orbit.fly(along(Action::fly_forward, Action::fly_back), along(Action::fly_left, Action::fly_right),
                            along(Action::fly_up, Action::fly_down));
    }
  }

  /// The place on the ground under the mouse.
  void point() {
    const bool over = scene_.holds(pointer_) && !gui_.wants_mouse();
    viewer_.pointed_at = over ? on_plane(view_, in_scene(pointer_), {}, {0, 0, 1}) : std::nullopt;
  }

  /// Drawn again only if something has changed: pictures are the most expensive part of the window.
  void draw_scene() {
    Drawn now{.frame = viewer_.poses().frame(),
              .tick = viewer_.poses().frame() ? viewer_.poses().frame()->tick : -1,
              .jumps = viewer_.status().jumps,
              .view = view_,
              .quality = state_.quality,
              .feet = viewer_.overlay.standing_feet,
              .changes = viewer_.seen().changes_to_see,
              .generation = viewer_.generation()};
    is_new_ = !drawn_ || !drawn_->equals(now) || viewer_.overlay.standing_feet;
    if (!is_new_) return;
    const auto begin = WallClock::now();
    picture_->draw(view_, state_.quality, pixels_);
    report_.scene_ms += 1e3 * seconds_since(begin);
    ++scenes_drawn_;
    drawn_ = now;
  }

  /// Pictures of the selected robot's cameras; if they are not drawn, a pinhole view instead.
  void draw_cameras() {
    state_.camera_pictures.clear();
    if (!viewer_.wants_pictures || viewer_.seen().sensors_of != viewer_.selected_entity() || !viewer_.selected())
      return;
    const RigView rig = viewer_.rig_view();
    const PoseFrame* frame = viewer_.poses().frame();
    for (const CameraState& camera : viewer_.seen().cameras) {
      if (!camera.picture.empty() || !frame) {
        state_.camera_pictures.push_back(camera.picture);
        continue;
      }
      const std::size_t row = frame->first[static_cast<std::size_t>(viewer_.selected_entity())] +
                              static_cast<std::size_t>(camera.info->link);
      const auto& lens = camera.info->lens.spec();
      constexpr int width = 320;
      auto view = pinhole_view(*camera.info, frame->position[row], frame->orientation[row], width,
                               std::max(16, width * lens.height / lens.width));
      view.without = rig.carrier;
      picture_->draw(view, state_.quality, camera_pixels_);
      state_.camera_pictures.push_back(camera_pixels_.color);
    }
  }

  void draw_window(double wall) {
    if (is_new_) texture_.fill(pixels_.color);
    gui_.begin(width_, height_, wall);
    if (texture_.name() != 0) {
      ImGui::GetBackgroundDrawList()->AddImage((ImTextureID) static_cast<std::intptr_t>(texture_.name()),
                                               vec2(scene_.x, scene_.y),
                                               vec2(scene_.x + scene_.width, scene_.y + scene_.height));
    }
    paint_overlays(viewer_.overlays_now(), view_, scene_);
    paint_drawings(viewer_.drawings_in(view_), scene_);
    paint_selection(viewer_, view_, scene_);
    if (const auto pull = mouse_.pull()) paint_pull(*pull, view_, scene_);
    Panels panels{gui_, viewer_, state_, options_.keys};
    toolbar(panels, top_);
    if (viewer_.window.left_panel) left_panel(panels, left_);
    if (viewer_.window.right_panel) right_panel(panels, right_, camera_textures_);
    timeline_panel(panels, bottom_);
    if (viewer_.window.field_map) field_map(panels, scene_);
    if (viewer_.window.help) help_window(panels, scene_);
    gui_.end();
  }

  /// After the window is drawn: pictures show it as the user sees it.
  void take_screenshots() {
    if (player_) {
      if (const auto file = player_->wanted_screenshot()) write(*file);
    }
    if (std::exchange(viewer_.window.wants_screenshot, false)) write(free_name());
    if (options_.after && !after_taken_ && seconds_since(begin_) >= *options_.after) {
      after_taken_ = true;
      if (!options_.screenshot.empty()) write(options_.screenshot);
    }
  }

  void write(const std::string& file) {
    try {
      files::write_file(file, render::image_png(read_window(width_, height_)));
      report_.files.push_back(file);
      viewer_.tell("wrote " + file);
    } catch (const SetupError& error) {
      if (player_ || options_.after) throw;
      viewer_.tell(error.what(), true);
    }
  }
  [[nodiscard]] static std::string free_name() {
    for (int i = 1;; ++i) {
      std::string name = fmt::format("murosimf_{:03}.png", i);
      if (!std::filesystem::exists(name)) return name;
    }
  }

  Viewer& viewer_;
  const WindowOptions& options_;
  GlfwWindow window_;
  Gui gui_;
  InputQueue queue_;
  MouseControl mouse_;
  PanelState state_;
  std::optional<ScenePicture> picture_;
  MouseControl::Pick pick_;
  std::optional<ScriptPlayer> player_;
  Texture texture_;
  std::vector<std::unique_ptr<Texture>> camera_textures_;
  sensors::View pixels_, camera_pixels_;
  std::optional<Drawn> drawn_;
  bool is_new_ = false, after_taken_ = false, may_drop_shadows_ = false;
  int judged_ = 0;
  double drawing_ = 0;  // [s]
  sensors::Perspective view_;
  Area top_, left_, right_, bottom_, scene_;
  int width_ = 1280, height_ = 720;
  MouseControl::Held held_;
  std::map<std::string, Action> flown_;
  Pixel pointer_{-1, -1}, pressed_at_;
  MouseControl::Button pressed_button_ = MouseControl::Button::left;
  std::optional<double> pressed_;  // [s] of the button's events
  WallClock::time_point begin_, last_;
  WindowReport report_;
  std::int64_t scenes_drawn_ = 0;
};

}  // namespace

WindowReport show(Viewer& viewer, const WindowOptions& options) { return Show(viewer, options).run(); }

}  // namespace murosimf::viewer
