/// viewer.h - all that the window knows and does, without any window: what is selected, what is asked of the session, what came back.
///
/// The window calls refresh() before each picture, perform() for keys and the rest for mouse and panels. Columns of the running scene
/// are never read here: poses come as frames (runtime/pose_feed.h), everything else as copies (inspection.h).
#pragma once

#include <deque>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/render/seen_drawing.h"
#include "murosimf/viewer/actions.h"
#include "murosimf/viewer/camera_rig.h"
#include "murosimf/viewer/event_book.h"
#include "murosimf/viewer/inspection.h"
#include "murosimf/viewer/overlays.h"
#include "murosimf/viewer/plot_book.h"
#include "murosimf/viewer/running_scene.h"

namespace murosimf::viewer {

struct ViewerOptions {
  session::MakeCourse make_course;  ///< also for every reload
  session::SessionOptions session{};
  Duration end = Duration::max();  ///< where it pauses by itself
  double inspections = 20;         ///< [Hz] of wall time
  const drawing::DebugDrawSource* others =
      nullptr;  ///< what other programs draw; must outlive the viewer; null: they do not
};

/// What the viewer tells people.
struct Message {
  std::string text;
  bool error = false;
  std::chrono::steady_clock::time_point when = std::chrono::steady_clock::now();
};

/// A joint that people can move.
struct MovableJoint {
  ObjectPath path;
  std::string name;
  double lowest = 0, highest = 0, position = 0;  ///< [rad | m]
};

/// Parts of the window that can be switched off, and requests that only the window fulfils.
struct WindowState {
  bool left_panel = true, right_panel = true, field_map = true, help = false;
  bool full_screen = false, wants_screenshot = false, wants_end = false;
};

class Viewer {
 public:
  explicit Viewer(ViewerOptions options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Takes over what is new; `wall` [s] since the last call.
  void refresh(double wall);
  /// Waits until all that was asked for has been done, and takes over what came of it. Not longer than 60 s.
  void settle();

  // ---- What there is ----
  [[nodiscard]] session::Session& session() { return running_->session(); }
  [[nodiscard]] RunningScene& running() { return *running_; }
  [[nodiscard]] const PoseFrame* frame() const { return frame_; }
  [[nodiscard]] const session::SessionStatus& status() const { return status_; }
  [[nodiscard]] const std::vector<session::BranchView>& branches() const { return branches_; }
  [[nodiscard]] const std::vector<EntityOutline>& outline() const { return outline_; }
  [[nodiscard]] const Inspection& seen() const { return seen_; }
  [[nodiscard]] const EventBook& events() const { return events_; }
  [[nodiscard]] const std::deque<Message>& messages() const { return messages_; }
  /// What is shown is a recording: it can only be looked at.
  [[nodiscard]] bool recorded() const { return !running_->session().known_properties().empty(); }
  /// How often the scene was made: for who keeps something of it.
  [[nodiscard]] int generation() const { return generation_; }
  [[nodiscard]] bool busy() const { return !asked_.empty() || inspection_.valid(); }
  /// Numbers of its entities; -1: there is none.
  [[nodiscard]] int ball() const { return ball_; }
  [[nodiscard]] int robot(int number) const;
  [[nodiscard]] int entity_named(std::string_view name) const;
  /// [m] world, now. The base's for object 0.
  [[nodiscard]] std::optional<Vec3d> place_of(const ObjectPath& path) const;
  /// "blue1.head"
  [[nodiscard]] std::string path_text(const ObjectPath& path) const;
  /// Reads "blue1" and "blue1.head". Throws SetupError with the nearest name.
  [[nodiscard]] ObjectPath path_of(const std::string& text) const;
  [[nodiscard]] RigView rig_view() const;
  [[nodiscard]] Overlays overlays_now() const;
  /// What is drawn for people who watch, as it is seen in a picture.
  [[nodiscard]] std::vector<render::SeenShape> drawings_in(const sensors::Perspective& view) const;
  /// "blue1/ball": who draws, and the name of a group.
  [[nodiscard]] std::vector<std::string> drawing_groups() const;
  /// Joints of what is selected that can be moved, in the order of the model.
  [[nodiscard]] std::vector<MovableJoint> joints() const;

  // ---- What people do ----
  void perform(Action action);
  void select(std::optional<ObjectPath> path);
  [[nodiscard]] const std::optional<ObjectPath>& selected() const { return selected_; }
  [[nodiscard]] int selected_entity() const { return selected_ ? selected_->entity : -1; }
  /// PATH = VALUE, as for Session::change; what refuses it becomes a message.
  void change(const std::string& text);
  void set_property(const ObjectPath& path, const PropertyValue& property);
  void switch_level(int entity, const std::string& level) {
    change(outline_[static_cast<std::size_t>(entity)].name + ".level = " + level);
  }
  void switch_contact(int entity, const std::string& law) {
    change(outline_[static_cast<std::size_t>(entity)].name + ".contact = " + law);
  }
  /// [m] world: of its base. Only one move is on its way at a time; the last one wins.
  void move(int entity, const Vec3d& place);
  /// [rad | m] While it is paused; as move().
  void move_joint(const ObjectPath& path, double position);
  /// [N] world, for push_seconds.
  void push(const ObjectPath& path, const Vec3d& force);
  /// [N m] likewise.
  void twist(const ObjectPath& path, const Vec3d& moment);
  void seek(double time, std::optional<int> branch = {});
  void reset();
  void reload();
  void record();  ///< from now on, or no longer
  void tell(std::string text, bool error = false);

  // ---- What panels set ----
  CameraRig rig;
  OverlayOptions overlay;
  WindowState window;
  double push_seconds = 0.1, newtons_per_meter = 200, newton_meters_per_meter = 20;
  std::set<std::string> hidden_groups;      ///< of drawing_groups()
  std::optional<Vec3d> pointed_at;          ///< [m] on the ground, below the mouse
  std::map<ObjectPath, bool> open_objects;  ///< whose properties are looked at
  bool wants_sensors = false, wants_pictures = false, wants_algorithms = false;
  struct PlotRequest {
    ObjectPath path;       ///< of a property
    std::string property;  ///< or "imu.gyroscope" of a sensor
    bool sensor = false;
    Plot plot;
  };
  std::vector<PlotRequest> plots;
  void add_plot(const ObjectPath& path, const std::string& property, bool sensor);

 private:
  struct Asked {
    std::string what;
    std::future<void> done;
    bool silent = false;
  };
  void begin();
  void ask(std::string what, std::future<void> done, bool silent = false);
  void collect_answers();
  [[nodiscard]] std::vector<drawing::Drawn> all_drawn() const;
  void take_status();
  void take_frame();
  void take_inspection();
  void ask_for_inspection();
  void record_plots();
  void watch_goals();
  void select_robot(int number);
  void next_level();
  void next_contact();
  void next_view();
  void change_speed(double factor);
  void step_back();
  void place_ball();
  bool perform_session(Action action);
  bool perform_selection(Action action);
  bool perform_camera(Action action);
  bool perform_overlay(Action action);
  void perform_window(Action action);

  ViewerOptions options_;
  std::unique_ptr<RunningScene> running_;
  std::shared_ptr<PoseReader> reader_;
  const PoseFrame* frame_ = nullptr;
  session::SessionStatus status_;
  std::vector<session::BranchView> branches_;
  std::vector<EntityOutline> outline_;
  Inspection seen_;
  std::shared_ptr<Inspection> coming_;
  std::future<void> inspection_;
  std::uint64_t jumps_asked_ = 0, jumps_seen_ = 0;
  std::chrono::steady_clock::time_point next_inspection_;
  EventBook events_;
  std::deque<Message> messages_;
  std::vector<Asked> asked_;
  std::map<std::string, std::string> moves_;  // PATH = VALUE: that wait until the last one has been done
  std::vector<drawing::Drawn> drawn_;         // by robots
  std::uint64_t drawings_known_ = 0;
  bool moving_ = false;
  Duration asked_poses_at_ = Duration::min();
  std::optional<ObjectPath> selected_;
  int ball_ = -1, generation_ = 0;
  std::size_t view_ = 0;
  double half_length_ = 3, half_width_ = 2, goal_half_width_ = 0.8;
  bool in_goal_ = false;
};

}  // namespace murosimf::viewer
