#include "murosimf/viewer/viewer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene_viewpoints.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::viewer {
namespace {

using namespace std::chrono_literals;

constexpr Duration pose_period = 10ms;  // simulated: finer than screens show at real time
constexpr std::size_t most_messages = 200;
constexpr auto settle_time = 60s;  // of settle()

bool is_ready(const std::future<void>& done) { return done.wait_for(0s) == std::future_status::ready; }

}  // namespace

Viewer::Viewer(ViewerOptions options) : options_(std::move(options)) { begin(); }

Viewer::~Viewer() = default;

/// Makes the scene, and learns what it is made of before it runs.
void Viewer::begin() {
  auto next = std::make_unique<RunningScene>(options_.make_course, options_.session, options_.end);
  frame_ = nullptr;
  running_ = std::move(next);
  inspection_ = {};  // what the scene before was asked does not matter any more
  asked_.clear();
  moves_.clear();
  moving_ = false;
  asked_poses_at_ = Duration::min();
  ++generation_;
  reader_ = running_->scene().simulation().poses().subscribe({.period = pose_period, .contacts = true});
  session()
      .visit([this](scene::Scene& scene) {
        outline_ = outline_of(scene);
        seen_ = inspect(scene, {});
        const scene_file::FieldSize& size = scene_file::field_size(scene.spec().field.size);
        half_length_ = 0.5 * size.length;
        half_width_ = 0.5 * size.width;
        goal_half_width_ = scene.spec().field.goals ? 0.5 * size.goal_width : 0;
        scene.simulation().publish_poses();
      })
      .get();
  ball_ = -1;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    if (outline_[i].is_ball) ball_ = static_cast<int>(i);
  }
  events_ = {};
  drawn_.clear();
  drawings_known_ = 0;
  jumps_seen_ = 0;
  in_goal_ = false;
  if (selected_ && selected_->entity >= static_cast<int>(outline_.size())) selected_.reset();
  if (generation_ == 1) rig.orbit.take_over(scene::viewpoint_perspective(running_->scene(), "overview", 1280, 720));
  take_frame();
  branches_ = session().branches();
  status_ = session().status();
}

void Viewer::take_status() {
  const bool is_known = !status_.diagnostic.empty();  // it changes while somebody goes through time
  status_ = session().status();
  if (!is_known && !status_.diagnostic.empty()) tell(status_.diagnostic, true);
}

void Viewer::refresh(double wall) {
  take_status();
  branches_ = session().branches();
  collect_answers();
  take_frame();
  take_inspection();
  if (std::chrono::steady_clock::now() >= next_inspection_) ask_for_inspection();
  rig.advance(rig_view(), wall);
  if (running_->ended()) window.wants_end = true;
}

void Viewer::settle() {
  const auto until = std::chrono::steady_clock::now() + settle_time;
  const auto wait = [&](const auto& ready) {
    while (!ready() && !running_->ended() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(1ms);
      take_status();
      collect_answers();
      take_frame();
    }
  };
  wait([&] { return asked_.empty() && moves_.empty(); });
  // one that was asked for after all that
  wait([&] { return !inspection_.valid() || is_ready(inspection_); });
  take_inspection();
  ask_for_inspection();
  wait([&] { return !inspection_.valid() || is_ready(inspection_); });
  take_inspection();
  take_status();  // also where nothing had to be waited for
  branches_ = session().branches();
  take_frame();
}

void Viewer::take_frame() {
  if (const PoseFrame* newer = reader_->latest()) {
    frame_ = newer;
    watch_goals();
  }
  // frames come at intervals; one who stands still is shown where it stands
  const bool late = status_.paused && (!frame_ || frame_->time != status_.time);
  if (!late) asked_poses_at_ = Duration::min();  // where it stands next may be the same instant
  if (!late || asked_poses_at_ == status_.time) return;
  asked_poses_at_ = status_.time;
  ask("poses", session().visit([](scene::Scene& scene) { scene.simulation().publish_poses(); }), true);
}

void Viewer::watch_goals() {
  if (ball_ < 0 || goal_half_width_ == 0 || static_cast<std::size_t>(ball_) >= frame_->present.size()) return;
  const Vec3d r = frame_->position[frame_->first[static_cast<std::size_t>(ball_)]];
  const bool inside =
      std::abs(r.x) > half_length_ && std::abs(r.y) < goal_half_width_ && std::abs(r.x) < half_length_ + 1;
  if (inside && !in_goal_) {
    events_.goal(seconds(frame_->time), status_.branch, r.x > 0 ? "goal on the right" : "goal on the left");
  }
  in_goal_ = inside;
}

void Viewer::ask_for_inspection() {
  if (inspection_.valid()) return;
  next_inspection_ = std::chrono::steady_clock::now() +
                     std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / options_.inspections));
  InspectionRequest request{.properties = session().known_properties()};
  for (const auto& [path, open] : open_objects) {
    if (open) request.objects.push_back(path);
  }
  for (const PlotRequest& plot : plots) {
    if (!plot.sensor && std::ranges::find(request.objects, plot.path) == request.objects.end()) {
      request.objects.push_back(plot.path);
    }
  }
  if (selected_ && !recorded()) request.sensors_of = selected_->entity;
  for (const PlotRequest& plot : plots) {
    if (plot.sensor && !request.sensors_of) request.sensors_of = plot.path.entity;
  }
  request.pictures = wants_pictures;
  request.algorithms = wants_algorithms;
  request.loads = overlay.joint_loads;
  request.drawings_known = drawings_known_;
  jumps_asked_ = status_.jumps;
  if (jumps_asked_ == jumps_seen_) request.events_known = events_.events_known();
  request.warnings_known = jumps_asked_ == jumps_seen_ ? events_.warnings_known() : 0;
  coming_ = std::make_shared<Inspection>();
  inspection_ = session().visit(
      [coming = coming_, request = std::move(request)](scene::Scene& scene) { *coming = inspect(scene, request); });
}

void Viewer::take_inspection() {
  if (!inspection_.valid() || !is_ready(inspection_)) return;
  try {
    inspection_.get();
  } catch (const SetupError& error) {
    return tell(error.what(), true);
  }
  const bool jumped = jumps_asked_ != jumps_seen_ || status_.jumps != jumps_asked_;
  jumps_seen_ = jumps_asked_;
  seen_ = std::move(*coming_);
  events_.take(seen_, status_.branch, jumped);
  if (seen_.drawn) drawn_ = std::move(*seen_.drawn);
  drawings_known_ = seen_.drawings;
  record_plots();
}

void Viewer::record_plots() {
  for (PlotRequest& request : plots) {
    if (!request.sensor) {
      const auto object = std::ranges::find(seen_.objects, request.path, &ObjectValues::path);
      if (object == seen_.objects.end()) continue;
      const auto value = std::ranges::find(object->properties, request.property, &PropertyValue::name);
      if (value == object->properties.end()) continue;
      request.plot.unit = value->unit;
      request.plot.add(seconds(seen_.time), value->numbers);
      continue;
    }
    if (seen_.sensors_of != request.path.entity) continue;
    for (const SensorState& sensor : seen_.sensors) {
      std::size_t first = 0;
      for (const sensors::Output& output : sensor.info->outputs) {
        if (sensor.samples > 0 && request.property == sensor.info->name + "." + output.name) {
          request.plot.unit = output.unit;
          request.plot.add(sensor.time, {sensor.values.begin() + static_cast<std::ptrdiff_t>(first),
                                         sensor.values.begin() + static_cast<std::ptrdiff_t>(first + output.size())});
        }
        first += output.size();
      }
    }
  }
}

void Viewer::add_plot(const ObjectPath& path, const std::string& property, bool sensor) {
  for (const PlotRequest& request : plots) {
    if (request.path == path && request.property == property && request.sensor == sensor) return;
  }
  const std::string whom = sensor ? outline_[static_cast<std::size_t>(path.entity)].name : path_text(path);
  plots.push_back({path, property, sensor, {whom + "." + property, {}, {}}});
}

void Viewer::ask(std::string what, std::future<void> done, bool silent) {
  asked_.push_back({std::move(what), std::move(done), silent});
}

void Viewer::collect_answers() {
  for (Asked& asked : asked_) {
    if (!is_ready(asked.done)) continue;
    if (asked.what == "move") moving_ = false;
    try {
      asked.done.get();
      if (!asked.silent) tell(asked.what);
    } catch (const SetupError& error) {
      tell(error.what(), true);
    }
  }
  std::erase_if(asked_, [](const Asked& asked) { return !asked.done.valid(); });
  if (moving_ || moves_.empty()) return;
  const auto [path, value] = *moves_.begin();
  moves_.erase(moves_.begin());
  moving_ = true;
  ask("move", session().change(fmt::format("{} = {}", path, value)), true);
}

void Viewer::tell(std::string text, bool error) {
  messages_.push_back({std::move(text), error});
  if (messages_.size() > most_messages) messages_.pop_front();
}

int Viewer::robot(int number) const {
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    if (outline_[i].label == number) return static_cast<int>(i);
  }
  return -1;
}

int Viewer::entity_named(std::string_view name) const {
  const auto found = std::ranges::find(outline_, name, &EntityOutline::name);
  return found == outline_.end() ? -1 : static_cast<int>(found - outline_.begin());
}

std::optional<Vec3d> Viewer::place_of(const ObjectPath& path) const {
  const auto entity = static_cast<std::size_t>(path.entity);
  if (!frame_ || path.entity < 0 || entity + 1 >= frame_->first.size() || !frame_->present[entity]) return std::nullopt;
  return frame_->position[frame_->first[entity] + static_cast<std::size_t>(path.object)];
}

std::string Viewer::path_text(const ObjectPath& path) const {
  const EntityOutline& whom = outline_[static_cast<std::size_t>(path.entity)];
  return fmt::format("{}.{}", whom.name, whom.model->objects()[static_cast<std::size_t>(path.object)].name);
}

ObjectPath Viewer::path_of(const std::string& text) const {
  const auto dot = text.find('.');
  const int entity = entity_named(text.substr(0, dot));
  if (entity < 0) {
    std::vector<std::string_view> names;
    for (const EntityOutline& whom : outline_) names.push_back(whom.name);
    throw SetupError(unknown_name("entity", text.substr(0, dot), names));
  }
  if (dot == std::string::npos) return {entity, 0};
  return {entity, outline_[static_cast<std::size_t>(entity)].model->object_index(text.substr(dot + 1))};
}

RigView Viewer::rig_view() const {
  RigView view{.frame = frame_,
               .selected = selected_entity(),
               .ball = ball_,
               .half_length = half_length_,
               .half_width = half_width_};
  if (view.selected >= 0) {
    view.carrier = running_->scene().simulation().world().entities()[static_cast<std::size_t>(view.selected)].get();
    if (seen_.sensors_of == view.selected && !seen_.cameras.empty()) view.camera = seen_.cameras[0].info.get();
  }
  return view;
}

Overlays Viewer::overlays_now() const {
  return frame_ ? overlays(*frame_, outline_, seen_, overlay, selected_entity()) : Overlays{};
}

}  // namespace murosimf::viewer
