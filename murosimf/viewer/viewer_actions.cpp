// What each action has a viewer do.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/scene/scene_viewpoints.h"
#include "murosimf/viewer/viewer.h"

namespace murosimf::viewer {
namespace {

constexpr double slowest = 1.0 / 64, fastest = 64;

/// The name behind `now` in a registry, the first one behind the last.
template <class Entries>
std::string next_name(const Entries& entries, const std::string& now) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  const auto found = std::ranges::find(names, now);
  if (found == names.end() || found + 1 == names.end()) return names.front();
  return *(found + 1);
}

// ---- Time ----

std::string speed_text(std::optional<double> speed) {
  return speed ? fmt::format("speed {:g}", *speed) : std::string("as fast as possible");
}

void set_speed(Viewer& viewer, std::optional<double> speed) {
  viewer.session().set_speed(speed);
  viewer.tell(speed_text(speed));
}

/// Without a speed it is as fast as possible, which is faster than any.
void change_speed(Viewer& viewer, double factor) {
  std::optional<double> speed = viewer.status().speed;
  if (!speed) {
    if (factor < 1) speed = fastest;
  } else {
    speed = std::max(slowest, *speed * factor);
    if (*speed > fastest) speed.reset();
  }
  set_speed(viewer, speed);
}

void step_back(Viewer& viewer) {
  viewer.session().pause();
  const Duration tick = viewer.running().scene().simulation().tick();
  viewer.steering.seek(seconds(std::max(viewer.status().first, viewer.status().time - tick)));
}

bool perform_time(Viewer& viewer, Action action) {
  session::Session& session = viewer.session();
  switch (action) {
    case Action::run_or_pause: viewer.status().paused ? session.go_on() : session.pause(); return true;
    case Action::step: session.step(); return true;
    case Action::step_back: step_back(viewer); return true;
    case Action::slower: change_speed(viewer, 0.5); return true;
    case Action::faster: change_speed(viewer, 2); return true;
    case Action::real_time: set_speed(viewer, 1.0); return true;
    case Action::reset: viewer.steering.reset(); return true;
    case Action::reload: viewer.reload(); return true;
    case Action::record: viewer.steering.record(); return true;
    default: return false;
  }
}

// ---- The scene ----

void place_ball(Viewer& viewer) {
  const int ball = viewer.outline().ball();
  if (ball < 0) return viewer.tell("this scene has no ball", true);
  if (!viewer.pointed_at) return viewer.tell("point to a place on the ground first", true);
  const auto now = viewer.poses().place_of({ball, 0});
  const std::string& object = viewer.outline().of(ball).model->objects()[0].name;
  SceneSteering& steering = viewer.steering;
  steering.move(ball, {viewer.pointed_at->x, viewer.pointed_at->y, now ? std::max(now->z, 0.01) : 0.1});
  steering.change(fmt::format("ball.{}.linear_velocity = [0, 0, 0]", object), true);
  steering.change(fmt::format("ball.{}.angular_velocity = [0, 0, 0]", object), true);
}

void next_level(Viewer& viewer) {
  const int entity = viewer.selected_entity();
  if (entity < 0 || !viewer.outline().of(entity).is_robot) return viewer.tell("select a robot first (1 to 9)", true);
  const EntityState& now = viewer.seen().entities[static_cast<std::size_t>(entity)];
  viewer.steering.switch_level(entity, next_name(catalog::levels(), now.level));
}

void next_contact(Viewer& viewer) {
  const int entity = viewer.selected_entity();
  if (entity < 0) return viewer.tell("select a robot, a body or the ball first", true);
  const EntityState& now = viewer.seen().entities[static_cast<std::size_t>(entity)];
  viewer.steering.switch_contact(entity, next_name(catalog::contacts(), now.contact));
}

bool perform_scene(Viewer& viewer, Action action) {
  switch (action) {
    case Action::place_ball: place_ball(viewer); return true;
    case Action::next_level: next_level(viewer); return true;
    case Action::next_contact: next_contact(viewer); return true;
    default: return false;
  }
}

// ---- The selection ----

void select_robot(Viewer& viewer, int number) {
  const int entity = viewer.outline().robot(number);
  if (entity < 0) return viewer.tell(fmt::format("there is no robot number {}", number + 1), true);
  viewer.select(ObjectPath{entity, 0});
}

void select_parent(Viewer& viewer) {
  if (!viewer.selected()) return;
  const auto [entity, object] = *viewer.selected();
  const int parent = viewer.outline().of(entity).model->objects()[static_cast<std::size_t>(object)].parent;
  viewer.select(ObjectPath{entity, std::max(0, parent)});
}

bool perform_selection(Viewer& viewer, Action action) {
  if (action >= Action::select_1 && action <= Action::select_9) {
    select_robot(viewer, static_cast<int>(action) - static_cast<int>(Action::select_1));
    return true;
  }
  switch (action) {
    case Action::select_ball:
      if (viewer.outline().ball() >= 0) viewer.select(ObjectPath{viewer.outline().ball(), 0});
      return true;
    case Action::select_parent: select_parent(viewer); return true;
    case Action::deselect: viewer.select(std::nullopt); return true;
    default: return false;
  }
}

// ---- The camera ----

void look_from(Viewer& viewer, const std::string& viewpoint) {
  viewer.rig.set_mode(CameraRig::Mode::free);
  viewer.rig.orbit.take_over(scene::viewpoint_perspective(viewer.running().scene(), viewpoint, 1280, 720));
}

void next_view(Viewer& viewer) {
  std::vector<std::string> names = scene::viewpoint_names(viewer.running().scene());
  std::erase_if(names, [&](const std::string& name) { return viewer.outline().entity_named(name) >= 0; });
  const std::string& name = names[viewer.rig.next_viewpoint(names.size())];
  look_from(viewer, name);
  viewer.tell("view: " + name);
}

void follow(Viewer& viewer) {
  CameraRig& rig = viewer.rig;
  const auto& selected = viewer.selected();
  rig.follows = !rig.follows;
  rig.set_mode(CameraRig::Mode::free);
  if (const auto place = selected ? viewer.poses().place_of({selected->entity, 0}) : std::nullopt;
      rig.follows && place) {
    rig.orbit.target = *place;
  }
  viewer.tell(!rig.follows ? "follows no entity"
              : selected   ? "follows what is selected"
                           : "follows the selected entity: select one");
}

bool perform_camera(Viewer& viewer, Action action) {
  CameraRig& rig = viewer.rig;
  const auto mode = [&](CameraRig::Mode wanted) {
    rig.set_mode(rig.mode() == wanted ? CameraRig::Mode::free : wanted);
    return true;
  };
  switch (action) {
    case Action::next_camera: next_view(viewer); return true;
    case Action::orbit_camera: rig.set_mode(CameraRig::Mode::free); return true;
    case Action::follow: follow(viewer); return true;
    case Action::robot_camera:
      if (!viewer.selected()) viewer.tell("through whose eyes? select a robot (1 to 9)", true);
      return mode(CameraRig::Mode::robot);
    case Action::tv_camera: return mode(CameraRig::Mode::tv);
    case Action::align_camera: look_from(viewer, "overview"); return true;
    default: return false;
  }
}

// ---- What is drawn, and the window ----

/// The switch that an action turns; null: it turns none.
bool* switch_of(Viewer& viewer, Action action) {
  OverlayOptions& overlay = viewer.overlay;
  WindowState& window = viewer.window;
  switch (action) {
    case Action::contacts: return &overlay.contacts;
    case Action::forces: return &overlay.forces;
    case Action::centers_of_mass: return &overlay.centers_of_mass;
    case Action::frames: return &overlay.frames;
    case Action::bounding_volumes: return &overlay.bounding_volumes;
    case Action::names: return &overlay.names;
    case Action::levels: return &overlay.levels;
    case Action::standing_feet: return &overlay.standing_feet;
    case Action::support_polygons: return &overlay.support_polygons;
    case Action::zero_moment_points: return &overlay.zero_moment_points;
    case Action::joint_loads: return &overlay.joint_loads;
    case Action::beliefs: return &overlay.beliefs;
    case Action::drawings: return &overlay.drawings;
    case Action::field_map: return &window.field_map;
    case Action::left_panel: return &window.left_panel;
    case Action::right_panel: return &window.right_panel;
    case Action::help: return &window.help;
    case Action::full_screen: return &window.full_screen;
    default: return nullptr;
  }
}

void perform_window(Viewer& viewer, Action action) {
  if (bool* const flag = switch_of(viewer, action)) *flag = !*flag;
  if (action == Action::screenshot) viewer.window.wants_screenshot = true;
  if (action == Action::quit) viewer.window.wants_end = true;
}

}  // namespace

void Viewer::perform(Action action) {
  if (perform_time(*this, action) || perform_scene(*this, action) || perform_selection(*this, action)) return;
  if (!perform_camera(*this, action)) perform_window(*this, action);
}

}  // namespace murosimf::viewer
