// What keys, mouse and panels have a viewer do.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/model/error.h"
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

std::string speed_text(std::optional<double> speed) {
  return speed ? fmt::format("speed {:g}", *speed) : std::string("as fast as possible");
}

}  // namespace

void Viewer::perform(Action action) {
  if (perform_session(action) || perform_selection(action) || perform_camera(action) || perform_overlay(action)) return;
  perform_window(action);
}

bool Viewer::perform_session(Action action) {
  switch (action) {
    case Action::run_or_pause: status_.paused ? session().go_on() : session().pause(); return true;
    case Action::step: session().step(); return true;
    case Action::step_back: step_back(); return true;
    case Action::slower: change_speed(0.5); return true;
    case Action::faster: change_speed(2); return true;
    case Action::real_time:
      session().set_speed(1.0);
      tell(speed_text(1.0));
      return true;
    case Action::reset: reset(); return true;
    case Action::reload: reload(); return true;
    case Action::record: record(); return true;
    case Action::place_ball: place_ball(); return true;
    case Action::next_level: next_level(); return true;
    case Action::next_contact: next_contact(); return true;
    default: return false;
  }
}

bool Viewer::perform_selection(Action action) {
  if (action >= Action::select_1 && action <= Action::select_9) {
    select_robot(static_cast<int>(action) - static_cast<int>(Action::select_1));
    return true;
  }
  switch (action) {
    case Action::select_ball:
      if (ball_ >= 0) select(ObjectPath{ball_, 0});
      return true;
    case Action::select_parent:
      if (selected_) {
        const auto& objects = outline_[static_cast<std::size_t>(selected_->entity)].model->objects();
        const int parent = objects[static_cast<std::size_t>(selected_->object)].parent;
        select(ObjectPath{selected_->entity, std::max(0, parent)});
      }
      return true;
    case Action::deselect: select(std::nullopt); return true;
    default: return false;
  }
}

bool Viewer::perform_camera(Action action) {
  const auto mode = [&](CameraRig::Mode wanted) {
    rig.set_mode(rig.mode() == wanted ? CameraRig::Mode::free : wanted);
    return true;
  };
  switch (action) {
    case Action::next_camera: next_view(); return true;
    case Action::orbit_camera: rig.set_mode(CameraRig::Mode::free); return true;
    case Action::follow:
      rig.follows = !rig.follows;
      rig.set_mode(CameraRig::Mode::free);
      if (const auto place = selected_ ? place_of({selected_->entity, 0}) : std::nullopt; rig.follows && place) {
        rig.orbit.target = *place;
      }
      tell(!rig.follows ? "follows nobody"
           : selected_  ? "follows what is selected"
                        : "follows whoever is selected: select somebody");
      return true;
    case Action::robot_camera:
      if (!selected_) tell("through whose eyes? select a robot (1 to 9)", true);
      return mode(CameraRig::Mode::robot);
    case Action::tv_camera: return mode(CameraRig::Mode::tv);
    case Action::align_camera:
      rig.set_mode(CameraRig::Mode::free);
      rig.orbit.take_over(scene::viewpoint_perspective(running_->scene(), "overview", 1280, 720));
      return true;
    default: return false;
  }
}

bool Viewer::perform_overlay(Action action) {
  const auto toggle = [](bool& flag) {
    flag = !flag;
    return true;
  };
  switch (action) {
    case Action::contacts: return toggle(overlay.contacts);
    case Action::forces: return toggle(overlay.forces);
    case Action::centers_of_mass: return toggle(overlay.centers_of_mass);
    case Action::frames: return toggle(overlay.frames);
    case Action::bounding_volumes: return toggle(overlay.bounding_volumes);
    case Action::names: return toggle(overlay.names);
    case Action::levels: return toggle(overlay.levels);
    case Action::standing_feet: return toggle(overlay.standing_feet);
    case Action::support_polygons: return toggle(overlay.support_polygons);
    case Action::zero_moment_points: return toggle(overlay.zero_moment_points);
    case Action::joint_loads: return toggle(overlay.joint_loads);
    case Action::beliefs: return toggle(overlay.beliefs);
    case Action::drawings: return toggle(overlay.drawings);
    case Action::field_map: return toggle(window.field_map);
    case Action::left_panel: return toggle(window.left_panel);
    case Action::right_panel: return toggle(window.right_panel);
    case Action::help: return toggle(window.help);
    case Action::full_screen: return toggle(window.full_screen);
    default: return false;
  }
}

void Viewer::perform_window(Action action) {
  if (action == Action::screenshot) window.wants_screenshot = true;
  if (action == Action::quit) window.wants_end = true;
}

void Viewer::select(std::optional<ObjectPath> path) {
  if (selected_ && path && path->entity != selected_->entity)
    std::erase_if(plots, [](const PlotRequest& request) { return request.sensor; });
  selected_ = path;
}

void Viewer::select_robot(int number) {
  const int entity = robot(number);
  if (entity < 0) return tell(fmt::format("there is no robot number {}", number + 1), true);
  select(ObjectPath{entity, 0});
}

void Viewer::next_level() {
  const int entity = selected_entity();
  if (entity < 0 || !outline_[static_cast<std::size_t>(entity)].is_robot)
    return tell("select a robot first (1 to 9)", true);
  switch_level(entity, next_name(catalog::levels(), seen_.entities[static_cast<std::size_t>(entity)].level));
}

void Viewer::next_contact() {
  const int entity = selected_entity();
  if (entity < 0) return tell("select a robot, a body or the ball first", true);
  switch_contact(entity, next_name(catalog::contacts(), seen_.entities[static_cast<std::size_t>(entity)].contact));
}

void Viewer::next_view() {
  std::vector<std::string> names = scene::viewpoint_names(running_->scene());
  std::erase_if(names, [&](const std::string& name) { return entity_named(name) >= 0; });
  view_ = (view_ + 1) % names.size();
  rig.set_mode(CameraRig::Mode::free);
  rig.orbit.take_over(scene::viewpoint_perspective(running_->scene(), names[view_], 1280, 720));
  tell("view: " + names[view_]);
}

/// Without a speed it is as fast as possible, which is faster than any.
void Viewer::change_speed(double factor) {
  std::optional<double> speed = status_.speed;
  if (!speed) {
    if (factor < 1) speed = fastest;
  } else {
    speed = std::max(slowest, *speed * factor);
    if (*speed > fastest) speed.reset();
  }
  session().set_speed(speed);
  tell(speed_text(speed));
}

void Viewer::step_back() {
  session().pause();
  const Duration tick = running_->scene().simulation().tick();
  seek(seconds(std::max(status_.first, status_.time - tick)));
}

void Viewer::place_ball() {
  if (ball_ < 0) return tell("this scene has no ball", true);
  if (!pointed_at) return tell("point to a place on the ground first", true);
  const auto now = place_of({ball_, 0});
  const std::string& object = outline_[static_cast<std::size_t>(ball_)].model->objects()[0].name;
  move(ball_, {pointed_at->x, pointed_at->y, now ? std::max(now->z, 0.01) : 0.1});
  ask("stop", session().change(fmt::format("ball.{}.linear_velocity = [0, 0, 0]", object)), true);
  ask("stop", session().change(fmt::format("ball.{}.angular_velocity = [0, 0, 0]", object)), true);
}

void Viewer::change(const std::string& text) { ask(text, session().change(text)); }

void Viewer::set_property(const ObjectPath& path, const PropertyValue& property) {
  const std::string numbers = fmt::format("{}", fmt::join(property.numbers, ", "));
  change(fmt::format("{}.{} = {}", path_text(path), property.name,
                     property.numbers.size() == 1 ? numbers : "[" + numbers + "]"));
}

void Viewer::move(int entity, const Vec3d& place) {
  moves_[path_text({entity, 0}) + ".position"] = fmt::format("[{}, {}, {}]", place.x, place.y, place.z);
  collect_answers();
}

void Viewer::move_joint(const ObjectPath& path, double position) {
  if (!status_.paused) return tell("pause first (Space), then move joints", true);
  moves_[path_text(path) + ".joint_position"] = fmt::format("{}", position);
  collect_answers();
}

void Viewer::push(const ObjectPath& path, const Vec3d& force) {
  change(fmt::format("{}.push = [{:.4g}, {:.4g}, {:.4g}, {:g}]", path_text(path), force.x, force.y, force.z,
                     push_seconds));
}

void Viewer::twist(const ObjectPath& path, const Vec3d& moment) {
  change(fmt::format("{}.push = [0, 0, 0, {:.4g}, {:.4g}, {:.4g}, {:g}]", path_text(path), moment.x, moment.y, moment.z,
                     push_seconds));
}

void Viewer::seek(double time, std::optional<int> branch) {
  ask(fmt::format("back to {:.3f} s", time), session().seek(from_seconds(time), branch), true);
}

void Viewer::reset() { ask("reset", session().reset()); }

void Viewer::record() {
  const bool on = !status_.recorded.value_or(false);
  ask(on ? "recording" : "no longer recording", session().record(on));
}

/// What cannot be read leaves the old scene running.
void Viewer::reload() {
  try {
    begin();
    tell("read again");
  } catch (const SetupError& error) {
    tell(error.what(), true);
  }
}

}  // namespace murosimf::viewer
