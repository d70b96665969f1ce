#include "murosimf/runtime/simulation.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/floating_point.h"
#include "murosimf/model/error.h"

namespace murosimf {
namespace {

using WallClock = std::chrono::steady_clock;

}  // namespace

Simulation::Simulation(int threads) : scheduler_(world_, tasks_, threads) {}

void Simulation::initialize() {
  if (registry_.started()) return;
  const StandardFloatingPoint modes;
  scheduler_.plan();
  registry_.keep_start();
  log_.keep_start();
  start();
}

Entity& Simulation::add(std::string name, ModelPtr model, const EntityOptions& options,
                        const std::function<void(Entity&)>& furnish, const std::function<void(Entity&)>& prepare) {
  Entity& entity = registry_.add(std::move(name), std::move(model), options, furnish, prepare);
  for (const auto& call : after_addition_) call(entity);
  return entity;
}

/// What the first start and every reset have in common.
void Simulation::start() {
  const StandardFloatingPoint modes;
  for (const auto& call : before_start_) call();
  modes.again();
  registry_.initialize_all();
  for (const auto& call : after_start_) call();
  modes.again();
  scheduler_.restart_checks();
  poses_.publish(world_, now(), scheduler_.ticks());
}

void Simulation::reset() {
  if (!registry_.started()) return initialize();
  registry_.go_back_to_start();
  timed_calls_.go_back_to_start();
  log_.go_back_to_start();
  commands_.forget_history();
  scheduler_.jump_to({});
  start();
}

void Simulation::run(Duration duration, Pacer& pacer, const std::function<void(Duration)>& progress) {
  if (duration < Duration{}) throw SetupError(fmt::format("duration {} s is negative", seconds(duration)));
  initialize();
  pacer.start(now());
  auto next_report = WallClock::now();
  for (const Duration end = now() + duration; now() < end && !stopped();) {
    pacer.before_step(now(), stop_);
    if (stopped()) return;
    step();
    pacer.after_step(now(), stop_);
    const bool at_end = now() >= end;
    if (progress && (scheduler_.ticks() % 64 == 0 || at_end) && (WallClock::now() >= next_report || at_end)) {
      progress(now());
      next_report = WallClock::now() + std::chrono::milliseconds(100);
    }
  }
}

void Simulation::run(Duration duration) {
  Pacer as_fast_as_possible;
  run(duration, as_fast_as_possible);
}

void Simulation::step() {
  const StandardFloatingPoint modes;
  initialize();
  make_timed_calls();
  commands_.carry_out(now());
  registry_.take_over_frozen();
  scheduler_.run_tick();
  registry_.take_over_frozen();
  poses_.publish(world_, now(), scheduler_.ticks());
}

void Simulation::at(Duration time, std::function<void()> call) {
  registry_.started() ? timed_calls_.add_later(time, std::move(call)) : timed_calls_.schedule(time, std::move(call));
}

void Simulation::make_timed_calls() {
  timed_calls_.make_due([this] { return now(); }, [this](const std::function<void()>& call) { make(call); });
}

void Simulation::make(const std::function<void()>& call) {
  const KeptFloatingPoint modes;  // the call is the user's
  try {
    call();
  } catch (const SetupError& error) {
    log_.warn(fmt::format("at {:.3f} s: {}", seconds(now()), error.what()));
  }
}

void Simulation::carry_out_commands() {
  initialize();
  make_timed_calls();
  if (commands_.carry_out(now())) publish_poses();
}

void Simulation::agenda_was(Agenda agenda) {
  commands_.forget_from(agenda.commands);
  timed_calls_.set_later(std::move(agenda.calls));
}

void Simulation::leave(Entity& entity) {
  initialize();
  registry_.leave(entity);
}

void Simulation::enter(Entity& entity, const std::function<void(Entity&)>& prepare) {
  initialize();
  registry_.enter(entity, prepare);
}

void Simulation::show_past(Duration time, std::span<const Event> events, std::span<const std::string> warnings) {
  initialize();
  scheduler_.look_at(time);
  log_.assign(events, warnings);
  poses_.publish(world_, now(), scheduler_.ticks());
}

std::vector<PlannedAlgorithm> Simulation::order_of_tick() {
  initialize();
  return scheduler_.order_of_tick();
}

}  // namespace murosimf
