#include "murosimf/session/session.h"

#include <algorithm>
#include <utility>

#include "murosimf/session/session_inside.h"

namespace murosimf::session {
namespace {

constexpr Duration never = Duration::max();

}  // namespace

Session::Session(scene::Scene& scene, const SessionOptions& options)
    : inside_(std::make_unique<Inside>(scene, options)) {
  inside_->simulation.initialize();
  inside_->timeline.begin(inside_->simulation.now(), scene.save());
  inside_->noted = inside_->simulation.commands().size();
  inside_->publish(options.paused);
}

Session::~Session() = default;

void Session::pause() {
  inside_->wish([](Inside::Wishes& wishes) { wishes.paused = true, wishes.steps = 0; });
}

void Session::go_on() {
  const Duration now = status().time;
  inside_->wish([now](Inside::Wishes& wishes) {
    wishes.paused = false, wishes.steps = 0;
    if (wishes.end <= now) wishes.end = never;
  });
}

void Session::step(std::int64_t steps) {
  inside_->wish(
      [steps](Inside::Wishes& wishes) { wishes.paused = true, wishes.steps += std::max<std::int64_t>(0, steps); });
}

void Session::set_speed(std::optional<double> speed) {
  (void)Clock(speed);  // throws
  inside_->wish([speed](Inside::Wishes& wishes) { wishes.speed = speed, wishes.new_speed = true; });
}

void Session::run_until(Duration end) {
  inside_->wish([end](Inside::Wishes& wishes) { wishes.end = end; });
}

void Session::finish() {
  inside_->wish([](Inside::Wishes& wishes) { wishes.finished = true; });
}

std::future<void> Session::change(std::string text) {
  return inside_->ask([inside = inside_.get(), text = std::move(text)] {
    std::future<void> done = inside->scene.post(text);
    inside->simulation.carry_out_commands();
    inside->note_commands();
    done.get();
  });
}

std::future<void> Session::reset(std::optional<std::uint64_t> seed) {
  return inside_->ask([inside = inside_.get(), seed] { inside->reset(seed); });
}

std::future<void> Session::seek(Duration time, std::optional<int> branch) {
  const std::uint64_t number = ++inside_->seeks;
  return inside_->ask([inside = inside_.get(), time, branch, number] { inside->seek(time, branch, number); });
}

std::future<void> Session::visit(std::function<void(scene::Scene&)> call) {
  return inside_->ask([inside = inside_.get(), call = std::move(call)] { call(inside->scene); });
}

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
  inside_->run(progress);
}

}  // namespace murosimf::session
