#include "murosimf/session/live_course.h"

#include <future>
#include <span>
#include <utility>

#include "murosimf/model/error.h"

namespace murosimf::session {

LiveCourse::LiveCourse(scene::Scene& scene, const LiveOptions& options)
    : scene_(scene), simulation_(scene.simulation()), options_(options), timeline_(options.timeline) {}

LiveCourse::LiveCourse(std::unique_ptr<scene::Scene> scene, const LiveOptions& options)
    : own_(std::move(scene)),
      scene_(*own_),
      simulation_(scene_.simulation()),
      options_(options),
      timeline_(options.timeline) {}

void LiveCourse::begin() {
  simulation_.initialize();
  timeline_.begin(simulation_.now(), scene_.save());
  noted_ = simulation_.commands().size();
}

void LiveCourse::step() {
  simulation_.step();
  timeline_.advance(simulation_.now());
  note_commands();  // of who posts to the scene itself
  if (!timeline_.wants_state(simulation_.now())) return;
  timeline_.keep(simulation_.now(), scene_.save());
  new_state_ = true;
}

void LiveCourse::note_commands() {
  const std::vector<Command>& all = simulation_.commands();
  if (all.size() == noted_) return;
  timeline_.note(std::span(all).subspan(noted_));
  noted_ = all.size();
}

void LiveCourse::change(const std::string& text) {
  std::future<void> done = scene_.post(text);
  simulation_.carry_out_commands();
  note_commands();
  done.get();
}

void LiveCourse::reset(std::optional<std::uint64_t> seed) {
  if (!options_.no_way_back.empty()) throw SetupError("no reset: " + options_.no_way_back);
  scene_.reset(seed);
  timeline_.begin(simulation_.now(), scene_.save());
  noted_ = simulation_.commands().size();
}

void LiveCourse::seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) {
  if (!options_.no_way_back.empty()) throw SetupError("no way back in time: " + options_.no_way_back);
  const int to = branch.value_or(timeline_.present());
  const Timeline::Way way = timeline_.way_to(to, time);
  scene_.load(*way.state);
  simulation_.commands_were(way.before);
  for (const Command& command : way.then) {
    while (simulation_.now() < command.time) simulation_.step();
    (void)scene_.post(command.text);
    simulation_.carry_out_commands();
  }
  while (simulation_.now() < time && !given_up()) simulation_.step();
  timeline_.go_back(to, simulation_.now());
  noted_ = simulation_.commands().size();
}

void LiveCourse::load(const std::function<void(scene::Scene&)>& load) {
  if (!options_.no_way_back.empty()) throw SetupError("no state of somewhere else: " + options_.no_way_back);
  load(scene_);
  simulation_.commands_were({});
  timeline_.begin(simulation_.now(), scene_.save());
  noted_ = simulation_.commands().size();
}

bool LiveCourse::has_grown() {
  const bool other = std::exchange(told_branch_, timeline_.present()) != timeline_.present();
  return std::exchange(new_state_, false) || other;
}

}  // namespace murosimf::session
