#include "murosimf/web/camera_subscriptions.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/render/software_renderer.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene/scene_parts.h"
#include "murosimf/sensors/camera_model.h"

namespace murosimf::web {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr auto between_pictures = 40ms;  // [wall]
constexpr auto keeps_renderer =
    30s;                         // [wall] after the last use: creating one delays the simulation by some milliseconds
constexpr auto patience = 20ms;  // [wall] polling period for the end of subscriptions

struct CameraPath {
  std::string robot, camera;
};

CameraPath path_of(const std::string& camera) {
  const std::size_t dot = std::min(camera.find('.'), camera.size());
  return {camera.substr(0, dot), camera.substr(std::min(dot + 1, camera.size()))};
}

/// Null: no camera of this name.
const sensors::CameraFrame* find_camera(const World& world, const std::string& path, int& entity) {
  const CameraPath name = path_of(path);
  for (entity = 0; entity < static_cast<int>(world.entities().size()); ++entity) {
    const Entity& one = *world.entities()[static_cast<std::size_t>(entity)];
    if (one.name() != name.robot) continue;
    for (const sensors::CameraFrame* frame : sensors::frames_of(one)) {
      if (frame->info->name == name.camera) return frame;
    }
  }
  return nullptr;
}

/// Removes effects that need the motion during the exposure.
sensors::CameraSpec of_one_moment(sensors::CameraSpec spec) {
  spec.exposure_time = spec.readout_time = 0;
  return spec;
}

}  // namespace

/// A camera found in a visit.
struct CameraSubscriptions::Found {
  std::string path;
  int entity = 0;
  std::shared_ptr<const sensors::CameraInfo> info;  // null: no such camera
  bool draws = false;
  std::shared_ptr<const sensors::CameraFrame> own;  // a new picture drawn by the camera itself
};

/// Data filled in by the simulation's thread, one visit at a time. Shared: a late visit still has a valid destination.
struct CameraSubscriptions::Visit {
  std::set<std::string> wanted;
  std::map<std::string, std::uint64_t> known;  // numbers of the cameras' own pictures

  std::vector<Found> found;
  PoseFrame frame;
  std::uint64_t seed = 0;
  std::unique_ptr<render::SoftwareRenderer> renderer;
  int changes = -1;  // shown by the renderer (SceneParts::changes_to_see)

  void make(scene::Scene& scene) {
    Simulation& simulation = scene.simulation();
    found.clear();
    bool is_to_draw = false;
    for (const std::string& path : wanted) {
      Found& one = found.emplace_back(Found{.path = path});
      const sensors::CameraFrame* shown = find_camera(simulation.world(), path, one.entity);
      if (!shown) continue;
      one.info = shown->info;
      one.draws = shown->draws;
      is_to_draw = is_to_draw || !one.draws;
      if (!one.draws || shown->number == 0 || known[path] == shown->number) continue;
      known[path] = shown->number;
      one.own = std::make_shared<const sensors::CameraFrame>(*shown);
    }
    if (!is_to_draw) return;
    seed = scene.spec().seed;
    simulation.poses().take(simulation.world(), simulation.now(), 0, frame);
    renew_renderer(scene);
  }

  /// Appearance and light can change during the run: the renderer is made anew then.
  void renew_renderer(scene::Scene& scene) {
    if (renderer && changes == scene.parts().changes_to_see) return;
    changes = scene.parts().changes_to_see;
    renderer = scene::make_camera_renderer(scene.parts(), scene.spec().light);
  }
};

/// A camera that is drawn here.
struct CameraSubscriptions::Eye {
  std::shared_ptr<const sensors::CameraSpec> spec;
  sensors::CameraModel eye;
  sensors::CameraPicture picture{};
};

struct CameraSubscriptions::Inside {
  explicit Inside(session::Session& of) : session(of) {}

  void work();
  [[nodiscard]] std::set<std::string> next_cameras(WallClock::time_point next);
  [[nodiscard]] bool visit(const std::set<std::string>& cameras);
  void show(const Found& found);
  void draw(const Found& found);
  [[nodiscard]] bool is_due(const Found& found);
  void tell(const std::string& path, const SeenPicture& picture);

  session::Session& session;
  std::mutex mutex;  // of these
  std::condition_variable changed;
  std::set<std::string> wanted, newly_wanted;
  bool stops = false;
  std::map<std::string, SeenPicture> pictures;
  std::atomic<std::uint64_t> drawn = 0;
  // accessed by the thread only
  std::shared_ptr<Visit> now;
  std::map<std::string, Eye> eyes;
  std::map<std::string, std::pair<Duration, std::int64_t>> last;  // time and number of the last picture
  std::thread thread;
};

/// Returns whether the visit was completed before all subscriptions ended.
bool CameraSubscriptions::Inside::visit(const std::set<std::string>& cameras) {
  if (!now) now = std::make_shared<Visit>();
  now->wanted = cameras;
  std::future<void> done = session.visit([visit = now](scene::Scene& scene) { visit->make(scene); });
  while (done.wait_for(patience) != std::future_status::ready) {
    const std::lock_guard lock(mutex);
    if (!stops && !wanted.empty()) continue;
    now = nullptr;  // the visit may still be executed
    return false;
  }
  try {
    done.get();
  } catch (const std::exception&) {  // the run has ended: the last pictures stay
    return false;
  }
  return true;
}

void CameraSubscriptions::Inside::tell(const std::string& path, const SeenPicture& picture) {
  const std::lock_guard lock(mutex);
  if (!wanted.contains(path)) return;
  SeenPicture& known = pictures[path];
  if (!picture.frame && known.trouble == picture.trouble) return;  // already reported
  const std::uint64_t number = known.number + 1;
  known = picture;
  known.number = number;
}

/// At most as often as the camera itself would draw while time advances; while time stands still, once for its present value.
bool CameraSubscriptions::Inside::is_due(const Found& found) {
  const auto known = last.find(found.path);
  if (known == last.end()) return true;
  const auto [time, number] = known->second;
  if (now->frame.time == time) return false;
  const Duration period = std::max(found.info->period, Duration(1));
  return now->frame.time / period != number || session.status().paused;
}

/// At most as often as the camera itself, whatever the number of pages.
void CameraSubscriptions::Inside::draw(const Found& found) {
  const sensors::CameraInfo& info = *found.info;
  const auto entity = static_cast<std::size_t>(found.entity);
  if (!info.spec || entity + 1 >= now->frame.first.size() || !is_due(found)) return;
  auto eye = eyes.find(found.path);
  if (eye == eyes.end() || eye->second.spec != info.spec) {
    eyes.erase(found.path);
    const CameraPath name = path_of(found.path);
    eye = eyes.emplace(found.path,
                       Eye{info.spec,
                           {of_one_moment(*info.spec), sensors::pixel_stream(now->seed, name.robot, name.camera)}})
              .first;
    eye->second.eye.open();
  }
  MUROSIMF_ASSERT(now->renderer != nullptr);
  const std::size_t row = now->frame.first[entity] + static_cast<std::size_t>(info.link);
  MUROSIMF_ASSERT(row < now->frame.position.size() && row < now->frame.orientation.size());
  const Vec3d& r = now->frame.position[row];
  const Mat3d& R = now->frame.orientation[row];
  const sensors::CameraMotion motion{.position = r + R * info.position,
                                     .orientation = R * info.orientation * transpose(sensors::optical_axes),
                                     .velocity = {},
                                     .angular_velocity = {}};
  const std::int64_t number = now->frame.time / std::max(info.period, Duration(1));
  const render::ShownMoment moment{.frame = &now->frame, .standing_feet = {}};
  now->renderer->show(&moment);
  sensors::CameraPicture& picture = eye->second.picture;
  eye->second.eye.take(*now->renderer, motion, static_cast<std::uint64_t>(number), picture);
  now->renderer->show(nullptr);
  last[found.path] = {now->frame.time, number};
  ++drawn;
  auto frame = std::make_shared<sensors::CameraFrame>();
  frame->time = now->frame.time;
  frame->number = static_cast<std::uint64_t>(number) + 1;
  frame->info = found.info;
  if (!eye->second.eye.has_mosaic()) frame->color = picture.view.color;
  frame->mosaic = picture.mosaic;
  frame->depth = picture.view.depth;
  frame->labels = picture.view.labels;
  tell(found.path, {
                       .frame = std::move(frame),
                   });
}

void CameraSubscriptions::Inside::show(const Found& found) {
  if (!found.info) return tell(found.path, {.trouble = fmt::format("there is no camera '{}'", found.path)});
  if (!found.draws) return draw(found);
  if (found.own) tell(found.path, {.frame = found.own, .own = true});
}

/// Waits for subscriptions and the time of the next pictures; empty: the thread ends.
std::set<std::string> CameraSubscriptions::Inside::next_cameras(WallClock::time_point next) {
  std::unique_lock lock(mutex);
  const auto is_called = [&] { return stops || !wanted.empty(); };
  if (wanted.empty()) {
    eyes.clear();
    if (!changed.wait_for(lock, keeps_renderer, is_called)) {
      now = nullptr;
      changed.wait(lock, is_called);
    }
  }
  changed.wait_until(lock, next, [&] { return stops; });
  if (stops) return {};
  std::erase_if(eyes, [&](const auto& one) { return !wanted.contains(one.first); });
  for (const std::string& camera : std::exchange(newly_wanted, {})) {
    last.erase(camera);
    if (now) now->known.erase(camera);
  }
  return wanted;
}

void CameraSubscriptions::Inside::work() {
  auto next = WallClock::now();
  while (true) {
    const std::set<std::string> cameras = next_cameras(next);
    const auto begin = WallClock::now();
    if (cameras.empty()) {
      const std::lock_guard lock(mutex);
      if (stops) return;
    } else if (visit(cameras)) {
      for (const Found& found : now->found) show(found);
    }
    // the processor may do the rendering: at most half of its time is used
    const auto took = WallClock::now() - begin;
    next = WallClock::now() + std::max<WallClock::duration>(took, between_pictures - took);
  }
}

CameraSubscriptions::CameraSubscriptions(session::Session& session) : inside_(std::make_unique<Inside>(session)) {}

/// The drawing thread ends before anything that it uses.
CameraSubscriptions::~CameraSubscriptions() {
  {
    const std::lock_guard lock(inside_->mutex);
    inside_->stops = true;
  }
  inside_->changed.notify_all();
  if (inside_->thread.joinable()) inside_->thread.join();
}

/// New cameras are drawn at once, also while the run is paused.
void CameraSubscriptions::want(const std::set<std::string>& cameras) {
  const std::lock_guard lock(inside_->mutex);
  if (cameras == inside_->wanted) return;
  for (const std::string& camera : cameras) {
    if (!inside_->wanted.contains(camera)) inside_->newly_wanted.insert(camera);
  }
  inside_->wanted = cameras;
  std::erase_if(inside_->pictures, [&](const auto& one) { return !cameras.contains(one.first); });
  if (!cameras.empty() && !inside_->thread.joinable()) inside_->thread = std::thread([this] { inside_->work(); });
  inside_->changed.notify_all();
}

std::optional<SeenPicture> CameraSubscriptions::seen(const std::string& camera) const {
  const std::lock_guard lock(inside_->mutex);
  const auto found = inside_->pictures.find(camera);
  return found == inside_->pictures.end() ? std::nullopt : std::optional(found->second);
}

std::uint64_t CameraSubscriptions::drawn() const { return inside_->drawn; }

void check_camera(const scene::Scene& scene, const std::string& camera) {
  int entity = 0;
  const World& world = scene.simulation().world();
  if (find_camera(world, camera, entity)) return;
  std::vector<std::string> names;
  for (const auto& one : world.entities()) {
    for (const sensors::CameraFrame* frame : sensors::frames_of(*one)) {
      names.push_back(one->name() + "." + frame->info->name);
    }
  }
  if (names.empty()) throw SetupError("no entity of this scene has a camera");
  throw SetupError(unknown_name("camera", camera, {names.begin(), names.end()}));
}

}  // namespace murosimf::web
