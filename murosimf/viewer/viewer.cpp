#include "murosimf/viewer/viewer.h"

#include <thread>
#include <utility>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene_viewpoints.h"

namespace murosimf::viewer {
namespace {

using namespace std::chrono_literals;

constexpr auto settle_time = 60s;  // of settle()

}  // namespace

Viewer::Viewer(ViewerOptions options) : drawings(options.others), options_(std::move(options)) { begin(); }

/// Makes the scene, and learns what it is made of before it runs.
void Viewer::begin() {
  auto next = std::make_unique<RunningScene>(options_.make_source, options_.session, options_.end);
  poses_ = {};
  running_ = std::move(next);
  steering.begin(session());  // what the scene before was asked does not matter any more
  drawings.forget();
  goals_ = {};
  ++generation_;
  poses_ = ShownPoses(running_->scene().simulation().poses());
  session()
      .visit([this](scene::Scene& scene) {
        outline_ = SceneOutline(scene);
        feed_ = InspectionFeed(inspect(scene, {}));
        scene.simulation().publish_poses();
      })
      .get();
  if (selected_ && selected_->entity >= static_cast<int>(outline_.size())) selected_.reset();
  if (generation_ == 1) rig.orbit.take_over(scene::viewpoint_perspective(running_->scene(), "overview", 1280, 720));
  take_frame();
  branches_ = session().branches();
  status_ = session().status();
}

void Viewer::take_status() {
  const bool is_known = !status_.diagnostic.empty();  // it changes during travel through time
  status_ = session().status();
  if (!is_known && !status_.diagnostic.empty()) tell(status_.diagnostic, true);
}

void Viewer::refresh(double wall) {
  take_status();
  branches_ = session().branches();
  steering.collect();
  take_frame();
  take_inspection();
  if (feed_.is_due()) ask_for_inspection();
  rig.advance(rig_view(), wall);
  if (running_->ended()) window.wants_end = true;
}

void Viewer::settle() {
  const auto until = std::chrono::steady_clock::now() + settle_time;
  const auto wait = [&](const auto& ready) {
    while (!ready() && !running_->ended() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(1ms);
      take_status();
      steering.collect();
      take_frame();
    }
  };
  const auto has_looked = [&] { return !feed_.is_asked() || feed_.has_answer(); };
  wait([&] { return steering.requests().settled(); });
  // one that was asked for after all that
  wait(has_looked);
  take_inspection();
  ask_for_inspection();
  wait(has_looked);
  take_inspection();
  take_status();  // also where nothing had to be waited for
  branches_ = session().branches();
  take_frame();
}

void Viewer::take_frame() {
  if (poses_.refresh()) {
    if (auto goal = goals_.look(*poses_.frame(), outline_)) {
      feed_.goal(seconds(poses_.frame()->time), status_.branch, *std::move(goal));
    }
  }
  if (poses_.must_ask(status_)) steering.publish_poses();
}

void Viewer::ask_for_inspection() {
  if (feed_.is_asked()) return;
  InspectionRequest request{.properties = session().known_properties()};
  for (const auto& [path, open] : open_objects) {
    if (open) request.objects.push_back(path);
  }
  if (selected_ && !recorded()) request.sensors_of = selected_->entity;
  plots.request(request);
  request.pictures = wants_pictures;
  request.algorithms = wants_algorithms;
  request.loads = overlay.joint_loads;
  request.drawings_known = drawings.known();
  const std::chrono::duration<double> period(1 / options_.inspections);
  feed_.ask(session(), status_, std::move(request), std::chrono::duration_cast<Duration>(period));
}

void Viewer::take_inspection() {
  if (!feed_.has_answer()) return;
  try {
    Inspection& seen = feed_.take(status_);
    drawings.take(seen);
    plots.take(seen);
  } catch (const SetupError& error) {
    tell(error.what(), true);
  }
}

void Viewer::reload() {
  try {
    begin();
    tell("read again");
  } catch (const SetupError& error) {
    tell(error.what(), true);
  }
}

/// Sensors are plotted of what is selected only.
void Viewer::select(std::optional<ObjectPath> path) {
  if (selected_ && path && path->entity != selected_->entity) plots.remove_sensors();
  selected_ = path;
}

RigView Viewer::rig_view() const {
  RigView view{.frame = poses_.frame(),
               .selected = selected_entity(),
               .ball = outline_.ball(),
               .half_length = outline_.half_length(),
               .half_width = outline_.half_width()};
  if (view.selected >= 0) {
    view.carrier = running_->scene().simulation().world().entities()[static_cast<std::size_t>(view.selected)].get();
    if (seen().sensors_of == view.selected && !seen().cameras.empty()) view.camera = seen().cameras[0].info.get();
  }
  return view;
}

Overlays Viewer::overlays_now() const {
  if (!poses_.frame()) return {};
  return overlays(*poses_.frame(), outline_.entities(), seen(), overlay, selected_entity());
}

std::vector<render::SeenShape> Viewer::drawings_in(const sensors::Perspective& view) const {
  if (!overlay.drawings) return {};
  return drawings.shapes_in(view, poses_, outline_);
}

}  // namespace murosimf::viewer
