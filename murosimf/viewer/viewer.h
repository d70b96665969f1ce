/// viewer.h - all that the window knows and does, without any window: what is selected, what is asked of the session, what came back.
///
/// The window calls refresh() before each picture, perform() for keys and the rest for mouse and panels. Columns of the running scene
/// are never read here: poses come as frames (runtime/pose_feed.h), everything else as copies (inspection.h).
///
/// It is put together from parts that own one thing each: the scene's outline, the poses that are shown, what is asked of the session
/// (scene_steering.h), what came back (inspection_feed.h), the camera, plots, and drawings.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/viewer/actions.h"
#include "murosimf/viewer/camera_rig.h"
#include "murosimf/viewer/drawing_layers.h"
#include "murosimf/viewer/inspection_feed.h"
#include "murosimf/viewer/movable_joints.h"
#include "murosimf/viewer/overlays.h"
#include "murosimf/viewer/plot_list.h"
#include "murosimf/viewer/running_scene.h"
#include "murosimf/viewer/scene_outline.h"
#include "murosimf/viewer/scene_steering.h"
#include "murosimf/viewer/shown_poses.h"

namespace murosimf::viewer {

struct ViewerOptions {
  session::MakeSource make_source;  ///< also for every reload
  session::SessionOptions session{};
  Duration end = Duration::max();  ///< where it pauses by itself
  double inspections = 20;         ///< [Hz] of wall time
  const drawing::DebugDrawSource* others =
      nullptr;  ///< what other programs draw; must outlive the viewer; null: they do not
};

/// Parts of the window that can be switched off, and requests that only the window fulfils.
struct WindowState {
  bool left_panel = true, right_panel = true, field_map = true, help = false;
  bool full_screen = false, wants_screenshot = false, wants_end = false;
};

class Viewer {
 public:
  explicit Viewer(ViewerOptions options);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Takes over what is new; `wall` [s] since the last call.
  void refresh(double wall);
  /// Waits until all that was asked for has been done, and takes over what came of it. Not longer than 60 s.
  void settle();
  /// Makes the scene anew. What cannot be read leaves the old one running.
  void reload();
  void perform(Action action);

  // ---- What there is ----
  [[nodiscard]] session::Session& session() { return running_->session(); }
  [[nodiscard]] RunningScene& running() { return *running_; }
  /// How often the scene was made: for callers that keep something of it.
  [[nodiscard]] int generation() const noexcept { return generation_; }
  [[nodiscard]] const session::SessionStatus& status() const noexcept { return status_; }
  [[nodiscard]] const std::vector<session::BranchView>& branches() const noexcept { return branches_; }
  /// What is shown is a recording: it can only be looked at.
  [[nodiscard]] bool recorded() const { return !running_->session().known_properties().empty(); }
  [[nodiscard]] const SceneOutline& outline() const noexcept { return outline_; }
  [[nodiscard]] const ShownPoses& poses() const noexcept { return poses_; }
  [[nodiscard]] const Inspection& seen() const noexcept { return feed_.seen(); }
  [[nodiscard]] const EventBook& events() const noexcept { return feed_.events(); }
  [[nodiscard]] const std::deque<Message>& messages() const noexcept { return messages_.all(); }
  void tell(std::string text, bool error = false) { messages_.tell(std::move(text), error); }
  /// Answers are on their way.
  [[nodiscard]] bool busy() const noexcept { return steering.requests().waits() || feed_.is_asked(); }

  // ---- What is selected ----
  void select(std::optional<ObjectPath> path);
  [[nodiscard]] const std::optional<ObjectPath>& selected() const noexcept { return selected_; }
  [[nodiscard]] int selected_entity() const noexcept { return selected_ ? selected_->entity : -1; }
  /// Joints of it that can be moved, in the order of the model.
  [[nodiscard]] std::vector<MovableJoint> joints() const { return movable_joints(outline_, poses_, selected_entity()); }

  // ---- What is shown ----
  [[nodiscard]] RigView rig_view() const;
  [[nodiscard]] Overlays overlays_now() const;
  /// What is drawn for people who watch, as it is seen in a picture.
  [[nodiscard]] std::vector<render::SeenShape> drawings_in(const sensors::Perspective& view) const;
  [[nodiscard]] std::vector<std::string> drawing_groups() const { return drawings.groups(outline_); }

  // ---- What panels, keys and mouse set ----
  SceneSteering steering{messages_, status_, outline_};
  CameraRig rig;
  OverlayOptions overlay;
  DrawingLayers drawings;
  PlotList plots;
  WindowState window;
  double newtons_per_meter = 200, newton_meters_per_meter = 20;  ///< of the mouse, when it pushes and twists
  std::optional<Vec3d> pointed_at;                               ///< [m] on the ground, below the mouse
  std::map<ObjectPath, bool> open_objects;                       ///< whose properties are looked at
  bool wants_pictures = false, wants_algorithms = false;

 private:
  void begin();
  void take_status();
  void take_frame();
  void take_inspection();
  void ask_for_inspection();

  ViewerOptions options_;
  std::unique_ptr<RunningScene> running_;
  session::SessionStatus status_;
  std::vector<session::BranchView> branches_;
  SceneOutline outline_;
  ShownPoses poses_;
  GoalWatch goals_;
  InspectionFeed feed_;
  MessageLog messages_;
  std::optional<ObjectPath> selected_;
  int generation_ = 0;
};

}  // namespace murosimf::viewer
