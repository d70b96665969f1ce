#include "murosimf/session/session.h"

#include <algorithm>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/session/live_source.h"
#include "murosimf/session/session_inside.h"

namespace murosimf::session {
namespace {

constexpr Duration never = Duration::max();

}  // namespace

Session::Session(scene::Scene& scene, const SessionOptions& options)
    : Session(std::make_unique<LiveSource>(scene, LiveOptions{.timeline = options.timeline,
                                                              .no_way_back = options.no_way_back}),
              options) {}

Session::Session(std::unique_ptr<PlaybackSource> source, const SessionOptions& options)
    : inside_(std::make_unique<Inside>(std::move(source), options)) {
  MUROSIMF_ASSERT(inside_->source != nullptr);
  inside_->source->begin();
  inside_->publish(options.paused);
}

Session::~Session() = default;

void Session::pause() {
  inside_->request([](Inside::Requests& requests) { requests.paused = true, requests.steps = 0; });
}

void Session::go_on() {
  if (status().at_end) (void)reset();
  const Duration now = status().time;
  // paused, steps and end under one lock: the run must not see half of a request
  inside_->request([now](Inside::Requests& requests) {
    requests.paused = false, requests.steps = 0;
    if (requests.end <= now) requests.end = never;
  });
}

void Session::go_on_until(Duration end) {
  inside_->request(
      [end](Inside::Requests& requests) { requests.paused = false, requests.steps = 0, requests.end = end; });
}

void Session::step(std::int64_t steps) {
  inside_->request([steps](Inside::Requests& requests) {
    requests.paused = true, requests.steps += std::max<std::int64_t>(0, steps);
  });
}

void Session::set_speed(std::optional<double> speed) {
  (void)Clock(speed);  // throws
  inside_->request([speed](Inside::Requests& requests) { requests.speed = speed, requests.new_speed = true; });
}

void Session::run_until(Duration end) {
  inside_->request([end](Inside::Requests& requests) { requests.end = end; });
}

void Session::finish() {
  inside_->request([](Inside::Requests& requests) { requests.finished = true; });
}

std::future<void> Session::change(std::string text) { return change(std::vector{std::move(text)}); }

std::future<void> Session::change(std::vector<std::string> texts) {
  return inside_->ask([inside = inside_.get(), texts = std::move(texts)] { inside->source->change(texts); });
}

std::future<void> Session::extend(std::function<void(scene::Scene&)> add) {
  return inside_->ask([inside = inside_.get(), add = std::move(add)] { inside->source->extend(add); });
}

std::future<void> Session::reset(std::optional<std::uint64_t> seed) {
  return inside_->ask([inside = inside_.get(), seed] { inside->reset(seed); });
}

std::future<void> Session::seek(Duration time, std::optional<int> branch) {
  // the number identifies the newest seek: older ones give up when they see it
  const std::uint64_t number = ++inside_->seeks;
  return inside_->ask([inside = inside_.get(), time, branch, number] { inside->seek(time, branch, number); });
}

std::future<void> Session::load(std::function<void(scene::Scene&)> load) {
  return inside_->ask([inside = inside_.get(), load = std::move(load)] { inside->load(load); });
}

std::future<void> Session::visit(std::function<void(scene::Scene&)> call) {
  return inside_->ask([inside = inside_.get(), call = std::move(call)] { call(inside->scene); });
}

std::future<void> Session::record(bool on) {
  return inside_->ask([inside = inside_.get(), on] { inside->record(on); });
}

scene::Scene& Session::scene() { return inside_->scene; }

const std::vector<std::string>& Session::known_properties() const { return inside_->source->known_properties(); }

SessionStatus Session::status() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->status;
}

std::vector<BranchView> Session::branches() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->branches;
}

Lateness Session::lateness() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->lateness;
}

void Session::run(Duration end, const std::function<void(Duration)>& progress) {
  run_until(end);
  try {
    inside_->run(progress);
  } catch (...) {
    inside_->refuse_all();  // waiting futures get their error
    throw;
  }
}

}  // namespace murosimf::session
