#include "murosimf/session/live_source.h"

#include <span>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/session/own_state.h"

namespace murosimf::session {

LiveSource::LiveSource(scene::Scene& scene, const LiveOptions& options)
    : scene_(scene), simulation_(scene.simulation()), options_(options), timeline_(options.timeline) {}

LiveSource::LiveSource(std::unique_ptr<scene::Scene> scene, const LiveOptions& options)
    : own_(std::move(scene)),
      scene_(*own_),
      simulation_(scene_.simulation()),
      options_(options),
      timeline_(options.timeline) {}

void LiveSource::begin() {
  simulation_.initialize();
  if (options_.no_way_back.empty()) outside().keep();
  begin_branch();
  live_ = {timeline_.present(), simulation_.now()};
}

/// Starts a branch without a parent.
void LiveSource::begin_branch() {
  (void)outside().take();  // input of the previous run
  timeline_.begin(simulation_.now(), scene_.save());
  noted_ = simulation_.commands().size();
}

void LiveSource::step() {
  outside().at(simulation_.now());
  if (std::exchange(diagnostics_, false)) {
    timeline_.diagnostic(diagnostic_);
    simulation_.warn(diagnostic_);
  }
  simulation_.step();
  timeline_.advance(simulation_.now());
  note_commands();  // posted directly to the scene
  note_outside();
  live_ = {timeline_.present(), simulation_.now()};
  if (!timeline_.wants_state(simulation_.now())) return;
  timeline_.keep(simulation_.now(), scene_.save());
  new_state_ = true;
}

void LiveSource::note_commands() {
  const std::vector<Command>& all = simulation_.commands();
  MUROSIMF_ASSERT(all.size() >= noted_);
  if (all.size() == noted_) return;
  timeline_.note(std::span(all).subspan(noted_));
  noted_ = all.size();
}

void LiveSource::note_outside() { timeline_.note(outside().take()); }

void LiveSource::change(const std::vector<std::string>& changes) {
  outside().at(simulation_.now());
  try {
    scene_.change(changes);
  } catch (...) {
    (void)outside().take();
    note_commands();  // posted meanwhile by others
    throw;
  }
  note_commands();
  note_outside();
}

void LiveSource::reset(std::optional<std::uint64_t> seed) {
  if (!options_.no_way_back.empty()) throw SetupError("no reset: " + options_.no_way_back);
  // a scene may fail to start with another seed: then everything is restored
  const std::vector<std::byte> before = scene_.save();
  const std::vector<Command> commands = simulation_.commands();
  outside().at(Duration{});
  try {
    scene_.reset(seed);
  } catch (...) {
    scene_.load(before);
    simulation_.command_queue().set_history(commands);
    throw;
  }
  begin_branch();
  live_ = {timeline_.present(), simulation_.now()};
  diagnostic_.clear();
  diagnostics_ = false;
}

void LiveSource::seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) {
  if (!options_.no_way_back.empty()) throw SetupError("no way back in time: " + options_.no_way_back);
  const int to = branch.value_or(timeline_.present());
  const Timeline::Way way = timeline_.way_to(to, time);
  MUROSIMF_ASSERT(way.state != nullptr);
  scene_.load(*way.state);
  simulation_.command_queue().set_history(way.before);
  repeat(way, time, given_up);
  timeline_.go_back(to, simulation_.now());
  noted_ = simulation_.commands().size();
  // back at the instant reached live: external participants continue as if nothing had happened
  const bool is_live = live_ == Place{to, simulation_.now()};
  diagnostic_ = is_live ? "" : own_state_from(simulation_.world(), &outside(), simulation_.now());
  diagnostics_ = !diagnostic_.empty();
}

/// Repeats the run from the state to that time, with the recorded commands and inputs.
void LiveSource::repeat(const Timeline::Way& way, Duration time, const std::function<bool()>& given_up) {
  struct Repeats {
    ExternalInputHistory& memory;
    ~Repeats() { memory.live(); }
  } const repeats{outside()};
  outside().repeat(way.notes);
  auto diagnostic = way.diagnostics.begin();
  const auto step = [&] {
    for (; diagnostic != way.diagnostics.end() && diagnostic->time <= simulation_.now(); ++diagnostic)
      simulation_.warn(diagnostic->text);
    simulation_.step();
    outside().at(simulation_.now());
  };
  outside().at(simulation_.now());
  for (const Command& command : way.then) {
    while (simulation_.now() < command.time) step();
    (void)scene_.post(command.text);
    simulation_.carry_out_commands();
  }
  while (simulation_.now() < time && !given_up()) step();
}

/// The loaded state begins a new branch: it does not follow from what was stepped before.
void LiveSource::load(const std::function<void(scene::Scene&)>& load) {
  if (!options_.no_way_back.empty()) throw SetupError("no state of somewhere else: " + options_.no_way_back);
  load(scene_);
  simulation_.command_queue().set_history({});
  begin_branch();
  diagnostic_ = own_state_from(simulation_.world(), &outside(), simulation_.now());
  diagnostics_ = !diagnostic_.empty();
}

/// States of before do not fit the scene any more.
void LiveSource::extend(const std::function<void(scene::Scene&)>& add) {
  add(scene_);
  begin_branch();
  live_ = {timeline_.present(), simulation_.now()};
}

bool LiveSource::has_grown() {
  const bool other = std::exchange(told_branch_, timeline_.present()) != timeline_.present();
  return std::exchange(new_state_, false) || other;
}

}  // namespace murosimf::session
