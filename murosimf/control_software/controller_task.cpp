#include "murosimf/control_software/controller_task.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {

namespace {

using WallClock = std::chrono::steady_clock;

std::string to_bytes(CallNote note) {
  std::vector<std::byte> bytes;
  StateArchive archive(bytes);
  archive(note);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

CallNote call_note(std::string_view bytes) {
  StateArchive archive(std::as_bytes(std::span(bytes)));
  CallNote note;
  archive(note);
  return note;
}

}  // namespace

ControllerTask::ControllerTask(Setup& setup, const SoftwareMaker& make, ControllerTaskOptions options)
    : options_(std::move(options)),
      robot_(&setup.entity()),
      port_(setup, options_.link, options_.seed),
      interface_(setup.write(software_interface)[0]) {
  MUROSIMF_ASSERT(setup.period() > Duration{});
  report_.software = options_.software;
  report_.rate_hz = 1 / seconds(setup.period());
  report_.budget = options_.budget;
  software_ = make(setup, port_, [this](const std::string& line) { report_.say(now_, line); });
  MUROSIMF_ASSERT(software_ != nullptr);
  port_.close();
  report_.keeps_state = software_->keeps_state();
  if (options_.memory && !software_->repeats_itself()) {
    memory_ = &options_.memory->channel("software:" + robot_->name());
  }
}

void ControllerTask::initialize() {
  interface_.report = &report_;
  now_ = {};
  port_.restart();
  port_.radio().refresh(now_);
  if (repeats()) {  // the entity enters again as it did in the recorded run
    (void)repeat_call(ExternalInput::began);
  } else {
    begin();
  }
  take_over_commands();
  port_.settle();
}

void ControllerTask::begin() {
  const SoftwareReport fresh{.software = report_.software,
                             .rate_hz = report_.rate_hz,
                             .budget = report_.budget,
                             .keeps_state = report_.keeps_state};
  report_ = fresh;
  over_ = false;
  const CallOutcome outcome = noted(ExternalInput::began, [&] { return software_->start(); });
  report_.note(outcome.changes, now_);
  if (!outcome) refuse(outcome);
  publish_news();
}

void ControllerTask::step(const Instant& instant) noexcept {
  now_ = instant.now;
  if (repeats()) {
    if (repeat_call(ExternalInput::sent)) take_over_commands();
    return;
  }
  if (over_) return;
  // after a jump in time the requests of the software are those of now, not those of the loaded state
  if (std::exchange(jumped_, false)) port_.renew_requests();
  port_.refresh(instant.now);
  const WallClock::time_point begin = WallClock::now();
  const CallOutcome outcome = noted(ExternalInput::sent, [&] { return software_->step(now_); });
  report_.count(WallClock::now() - begin, now_);
  count_messages();
  report_.note(outcome.changes, now_);
  if (!outcome) return end(outcome);
  take_over_commands();
  publish_news();
}

/// Makes a call of the software, and records its effects if a history is kept.
template <class Call>
CallOutcome ControllerTask::noted(ExternalInput::Kind kind, const Call& call) {
  const bool notes = memory_ && memory_->keeps();
  if (notes) port_.listen();
  CallOutcome outcome = call();
  report_.keeps_state = software_->keeps_state();
  if (!notes) return outcome;
  CallNote note = port_.told();
  note.good = static_cast<bool>(outcome);
  note.written = software_->written();
  memory_->write(kind, to_bytes(std::move(note)));
  return outcome;
}

/// Software whose memory is part of the state computes the same again; software that has ended cannot.
bool ControllerTask::repeats() const { return memory_ && memory_->repeats() && (report_.keeps_state || over_); }

/// Applies the recorded effects of a call. False: it was not called at that time, or did not return.
bool ControllerTask::repeat_call(ExternalInput::Kind kind) {
  MUROSIMF_ASSERT(memory_ != nullptr);
  const ExternalInput* const note = memory_->next();
  if (!note || note->kind != kind) return false;
  const CallNote done = call_note(note->bytes);
  memory_->pass();
  if (kind == ExternalInput::sent) port_.refresh(now_);
  port_.repeat(done);
  software_->write(done.written);
  return done.good;
}

/// Updates the report: software that has disconnected counts as ended until other software connects.
void ControllerTask::publish_news() {
  if (const std::string news = software_->news(); !news.empty()) report_.say(now_, news);
  const std::string absence = software_->absence();
  if (absence.empty()) return report_.ended.clear();
  if (report_.ended.empty()) report_.ended = fmt::format("at {:.3f} s: {}", seconds(now_), absence);
}

void ControllerTask::end(const CallOutcome& outcome) {
  over_ = true;
  report_.ended = fmt::format("at {:.3f} s: {}", seconds(now_), outcome.text);
  if (outcome.kind == CallOutcome::crashed && options_.crashes) {
    options_.crashes->write(fmt::format("{}: at {:.3f} s: {}", robot_->name(), seconds(now_), outcome.text));
  }
}

/// Called when the software cannot start.
void ControllerTask::refuse(const CallOutcome& outcome) {
  if (outcome.kind != CallOutcome::crashed) throw SetupError(outcome.text);
  end(outcome);
  throw SoftwareCrash(outcome.text);
}

/// Refused numbers are counted; the first refusal is kept, since the others mostly repeat it.
void ControllerTask::take_over_commands() {
  const std::size_t refused = port_.accept(now_);
  count_link();
  if (refused == 0) return;
  if (report_.refused == 0) report_.first_refusal = fmt::format("at {:.3f} s: {}", seconds(now_), port_.refusal());
  report_.refused += refused;
}

void ControllerTask::count_messages() {
  report_.messages = port_.radio().counts();
  if (!port_.radio().refusal().empty() && report_.first_refused_message.empty()) {
    report_.first_refused_message = fmt::format("at {:.3f} s: {}", seconds(now_), port_.radio().refusal());
  }
}

void ControllerTask::count_link() {
  const DelayedRows *signals = port_.signal_link(), *commands = port_.command_link();
  if (!signals && !commands) return;
  report_.link.emplace();
  if (signals) report_.link->signals = signals->counts();
  if (commands) report_.link->commands = commands->counts();
}

void ControllerTask::state(StateArchive& archive) {
  port_.state(archive);
  software_->state(archive);
  jumped_ = jumped_ || archive.loads();
}

const SoftwareReport* software_report(const Entity& entity) {
  const Column<SoftwareInterface>* column = entity.find(software_interface);
  return column ? column->values[0].report : nullptr;
}

}  // namespace murosimf::control_software
