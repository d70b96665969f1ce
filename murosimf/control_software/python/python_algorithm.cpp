#include "murosimf/control_software/python/python_algorithm.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::control_software {

PythonAlgorithm::PythonAlgorithm(Setup& setup, PythonClass made, Entity& common, const std::vector<Entity*>& others,
                                 PythonAlgorithmOptions options)
    : options_(std::move(options)),
      phase_(made.phase()),
      entity_(&setup.entity() == &common ? nullptr : &setup.entity()),
      reading_(made.outputs().empty() ? nullptr
                                      : std::make_unique<PythonReading>(setup, made.outputs(), options_.sensor)) {
  report_.software = made.name();
  report_.rate_hz = reading_ ? options_.sensor.rate : 1 / seconds(setup.period());
  report_.budget = options_.budget;
  python_in_turns(setup, common);
  software_ = std::make_unique<PythonSoftware>(
      setup, nullptr, [this](const std::string& line) { report_.say(now_, line); }, std::move(made), others,
      reading_ ? &reading_->written() : nullptr);
  report_.keeps_state = software_->keeps_state();
}

void PythonAlgorithm::initialize() {
  const SoftwareReport fresh{.software = report_.software,
                             .rate_hz = report_.rate_hz,
                             .budget = report_.budget,
                             .keeps_state = report_.keeps_state};
  report_ = fresh;
  now_ = {};
  begin_anew();
  end_of_run_.clear();
  if (reading_) reading_->initialize();
  const CallOutcome outcome = software_->start();
  report_.note(outcome.changes, now_);
  if (outcome) return take_end();
  if (outcome.kind != CallOutcome::crashed) throw SetupError(outcome.text);
  fail(outcome);
  throw SoftwareCrash(outcome.text);
}

void PythonAlgorithm::step(const Instant& instant) noexcept {
  if (over_) return;
  if (reading_ && !reading_->is_due(instant.now)) return reading_->step(instant);
  if (!call(instant.now)) return;
  if (reading_) reading_->step(instant);
  take_end();
}

bool PythonAlgorithm::call(Duration now) noexcept {
  now_ = now;
  const auto begin = std::chrono::steady_clock::now();
  const CallOutcome outcome = software_->step(now_);
  report_.count(std::chrono::steady_clock::now() - begin, now_);
  report_.note(outcome.changes, now_);
  if (!outcome) fail(outcome);
  return static_cast<bool>(outcome);
}

/// A run without its referee would be another run: it does not go on.
void PythonAlgorithm::fail(const CallOutcome& outcome) {
  over_ = true;
  report_.ended = fmt::format("at {:.3f} s: {}", seconds(now_), outcome.text);
  const bool crashed = outcome.kind == CallOutcome::crashed;
  if (entity_ && !crashed) return entity_->freeze(outcome.text);
  const std::string note = fmt::format("{}: {}", name(), report_.ended);
  options_.notes->write(note);
  if (!crashed) note_ = note;
}

void PythonAlgorithm::begin_anew() {
  over_ = false;
  report_.ended.clear();
  options_.notes->take_back(std::exchange(note_, {}));
}

void PythonAlgorithm::take_end() {
  if (software_->end_of_run().empty()) return;
  over_ = true;
  end_of_run_ = software_->end_of_run();
  report_.ended = fmt::format("at {:.3f} s: it has ended the run: {}", seconds(now_), end_of_run_);
}

void PythonAlgorithm::reseed(std::uint64_t seed) {
  software_->reseed(seed);
  if (reading_) reading_->reseed(seed);
}

void PythonAlgorithm::state(StateArchive& archive) {
  software_->state(archive);
  if (reading_) reading_->state(archive);
  archive(over_, end_of_run_);
  if (archive.loads() && !over_) begin_anew();
}

}  // namespace murosimf::control_software
