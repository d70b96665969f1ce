#include "murosimf/supervise/requests.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <supervision.pb.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/network/socket.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/supervise/supervision.h"
#include "murosimf/world/object_access.h"

namespace murosimf::supervise {
namespace {

using namespace std::chrono_literals;
using wire::FromSupervisor;

constexpr auto look_again = 200us;             // whether it has come to where it is to pause
constexpr std::size_t most_patterns = 100;     // that are remembered
constexpr std::size_t most_numbers = 100'000;  // of one answer
constexpr std::uint64_t most_events = 10'000;  // likewise
constexpr std::uint32_t most_steps = 1'000'000'000;

/// [s] in ns, for answers.
std::int64_t ns(Duration time) { return time.count(); }

Duration checked(std::int64_t time, const char* what) {
  if (time >= 0 && seconds(Duration(time)) <= scene_file::longest_duration) return Duration(time);
  throw SetupError(fmt::format("{} is {} s; it must be from 0, and not longer than simulated time can count", what,
                               seconds(Duration(time))));
}

double value_of(const logging::LoggedNumber& number) {
  if (number.sensor.empty())
    return ObjectAccess(*number.entity, number.object).get(number.property).numbers[number.index];
  return sensors::find_reading(*number.entity, number.sensor)->values[number.index];
}

void write(const std::vector<Command>& commands, wire::BranchOfRun& branch) {
  for (const Command& command : commands) {
    wire::TimedText& told = *branch.add_commands();
    told.set_time(ns(command.time));
    told.set_text(command.text);
  }
}

const scene_file::RobotSpec* spec_of(const scene::Scene& scene, const std::string& name) {
  const auto& robots = scene.spec().robots;
  const auto found = std::ranges::find(robots, name, &scene_file::RobotSpec::name);
  return found == robots.end() ? nullptr : &*found;
}

void write(const scene::Scene& scene, const Entity& entity, wire::SceneEntity& told) {
  told.set_name(entity.name());
  told.set_model(entity.model().name());
  told.set_level(entity.level);
  told.set_contact(entity.contact);
  if (const scene_file::RobotSpec* robot = spec_of(scene, entity.name())) told.set_controller(robot->controller);
  told.set_team(entity.options().team);
  told.set_present(entity.present());
  for (const std::string_view object : entity.model().object_names()) told.add_objects(std::string(object));
}

}  // namespace

void Requests::visit(const std::function<void(scene::Scene&)>& look) {
  MUROSIMF_ASSERT(session_ != nullptr);
  session_->visit(look).get();
}

void Requests::write_status(wire::Status& told) const {
  const session::SessionStatus status = session_->status();
  told.set_time(ns(status.time));
  told.set_end(ns(status.end));
  told.set_paused(status.paused);
  told.set_speed(status.speed.value_or(0));
  told.set_factor(status.factor);
  told.set_jumps(status.jumps);
  told.set_branch(status.branch);
  told.set_first(ns(status.first));
  told.set_last(ns(status.last));
  told.set_events(status.events);
  told.set_warnings(status.warnings);
  if (status.recorded) told.set_recorded(*status.recorded);
  told.set_diagnostic(status.diagnostic);
}

/// Of the session with that number, or a later one.
void Requests::welcome(wire::ToSupervisor& answer, int session) {
  const SessionSlot::Lease lease(*slot_, session);
  session_ = &lease.session();
  publish_scene(answer);
}

void Requests::publish_scene(wire::ToSupervisor& answer) {
  wire::SupervisorWelcome& welcome = *answer.mutable_welcome();
  visit([&](scene::Scene& scene) {
    welcome.set_scene(scene.spec().name);
    welcome.set_seed(scene.spec().seed);
    welcome.set_tick(ns(scene.simulation().tick()));
  });
  write_status(*welcome.mutable_status());
}

/// The lease keeps the session from being exchanged while the request is answered.
void Requests::answer(const FromSupervisor& request, wire::ToSupervisor& answer) {
  answer.Clear();
  int present = 0;
  {
    const SessionSlot::Lease lease(*slot_);
    present = slot_->number();
    session_ = &lease.session();
    if (!request.has_load_scene()) return answer_of_session(request, answer);
    exchange(request);
  }
  welcome(answer, present + 1);
}

/// The present run ends then; the next one has the wanted scene.
void Requests::exchange(const FromSupervisor& request) {
  if (!options_->exchange) throw SetupError("this run keeps its scene");
  const wire::SceneRequest& asked = request.load_scene();
  const SceneRequest wanted{.scene = asked.scene(),
                            .overrides = {asked.overrides().begin(), asked.overrides().end()},
                            .seed = asked.has_seed() ? std::optional(asked.seed()) : std::nullopt,
                            .paused = asked.paused()};
  visit([&](scene::Scene&) { options_->exchange(wanted); });
  session_->finish();
}

void Requests::answer_of_session(const FromSupervisor& request, wire::ToSupervisor& answer) {
  switch (request.kind_case()) {
    case FromSupervisor::kStatus: break;
    case FromSupervisor::kPause: session_->pause(); break;
    case FromSupervisor::kGoOn: session_->go_on(); break;
    case FromSupervisor::kStep: session_->step(std::min(request.step().count(), most_steps)); break;
    case FromSupervisor::kSpeed: {
      const double factor = request.speed().factor();
      session_->set_speed(factor == 0 ? std::nullopt : std::optional(factor));
      break;
    }
    case FromSupervisor::kRunUntil: session_->run_until(checked(request.run_until().end(), "the end")); break;
    case FromSupervisor::kAdvance: advance(checked(request.advance().duration(), "the duration")); break;
    case FromSupervisor::kChange: change(request); break;
    case FromSupervisor::kRead:
      return read({request.read().patterns().begin(), request.read().patterns().end()}, answer);
    case FromSupervisor::kDescribe: return describe(answer);
    case FromSupervisor::kEvents: return publish_events(request.events().first(), answer);
    case FromSupervisor::kReset:
      session_->reset(request.reset().has_seed() ? std::optional(request.reset().seed()) : std::nullopt).get();
      break;
    case FromSupervisor::kSeek: seek(request); break;
    case FromSupervisor::kLoad: load(request); break;
    case FromSupervisor::kRecord: session_->record(request.record().on()).get(); break;
    case FromSupervisor::kBranches: return publish_branches(answer);
    case FromSupervisor::kSave: return save(answer);
    case FromSupervisor::kFinish: session_->finish(); break;
    default: throw network::NetworkError("sends what is no request of this protocol");
  }
  settle();
  write_status(*answer.mutable_status());
}

/// Returns when the time is reached, or another supervisor has paused the run or moved it in time.
void Requests::advance(Duration duration) {
  session_->pause();
  settle();
  const session::SessionStatus before = session_->status();
  if (duration == Duration{}) return;
  const Duration end = before.time + duration;
  session_->go_on_until(end);
  settle();
  session::SessionStatus now = session_->status();
  while (now.time < end && !now.paused && now.jumps == before.jumps && !given_up_()) {
    std::this_thread::sleep_for(look_again);
    now = session_->status();
  }
  session_->pause();
  session_->run_until(before.end);
}

/// Two visits: after the second one the status includes all requests made before the first.
void Requests::settle() {
  for (int i = 0; i < 2; ++i) visit([](scene::Scene&) {});
}

void Requests::change(const FromSupervisor& request) {
  found_.clear();  // other levels have other properties
  const auto& changes = request.change().changes();
  session_->change(std::vector<std::string>(changes.begin(), changes.end())).get();
}

void Requests::seek(const FromSupervisor& request) {
  const wire::Seek& seek = request.seek();
  session_->seek(checked(seek.time(), "the time"), seek.has_branch() ? std::optional(seek.branch()) : std::nullopt)
      .get();
}

/// All numbers at the same instant.
void Requests::read(const Patterns& patterns, wire::ToSupervisor& answer) {
  const int session = slot_->number();
  if (std::exchange(found_in_, session) != session) found_.clear();
  wire::Numbers& numbers = *answer.mutable_numbers();
  visit([&](scene::Scene& scene) {
    if (found_.size() >= most_patterns) found_.clear();
    const auto known = found_.find(patterns);
    const auto& all = known != found_.end()
                          ? known->second
                          : (found_[patterns] = logging::find_logged(scene.simulation().world(), patterns));
    if (all.size() > most_numbers) {
      throw SetupError(fmt::format("these are {} numbers; at most {} at a time", all.size(), most_numbers));
    }
    numbers.set_time(ns(scene.simulation().now()));
    for (const logging::LoggedNumber& number : all) {
      numbers.add_names(number.name());
      numbers.add_values(value_of(number));
    }
  });
}

void Requests::describe(wire::ToSupervisor& answer) {
  wire::SceneDescription& description = *answer.mutable_description();
  visit([&](scene::Scene& scene) {
    for (const auto& entity : scene.simulation().world().entities()) write(scene, *entity, *description.add_entities());
  });
}

/// A part of the events at a time: an answer has a largest size.
void Requests::publish_events(std::uint64_t first, wire::ToSupervisor& answer) {
  wire::Events& told = *answer.mutable_events();
  visit([&](scene::Scene& scene) {
    const std::vector<Event>& events = scene.simulation().events();
    const std::uint64_t end = std::min<std::uint64_t>(events.size(), first + std::min(most_events, ~first));
    for (std::uint64_t i = first; i < end; ++i) {
      wire::TimedText& event = *told.add_events();
      event.set_time(ns(events[i].time));
      event.set_text(events[i].text);
    }
    for (const std::string& warning : scene.simulation().warnings()) told.add_warnings(warning);
  });
}

/// A visit first: the branches are then those after the last finished step.
void Requests::publish_branches(wire::ToSupervisor& answer) {
  visit([](scene::Scene&) {});
  for (const session::BranchView& branch : session_->branches()) {
    wire::BranchOfRun& told = *answer.mutable_branches()->add_branches();
    told.set_number(branch.number);
    if (branch.parent) told.set_parent(*branch.parent);
    told.set_begin(ns(branch.begin));
    told.set_end(ns(branch.end));
    write(branch.commands, told);
  }
}

void Requests::load(const FromSupervisor& request) {
  const wire::StatePart& part = request.load();
  if (state_.size() + part.content().size() > longest_state) {
    state_ = {};
    throw SetupError(fmt::format("a state of more than {} bytes", longest_state));
  }
  state_ += part.content();
  if (!part.last()) return;
  found_.clear();  // entities may be at other levels
  const std::string bytes = std::exchange(state_, {});
  session_
      ->load([&](scene::Scene& scene) {
        if (options_->load) return options_->load(scene, bytes);
        scene.load(std::as_bytes(std::span(bytes)));
      })
      .get();
}

/// The same bytes as `--save-state` would write.
void Requests::save(wire::ToSupervisor& answer) {
  wire::SavedState& state = *answer.mutable_state();
  visit([&](scene::Scene& scene) {
    state.set_time(ns(scene.simulation().now()));
    if (options_->save) return state.set_content(options_->save(scene));
    const std::vector<std::byte> bytes = scene.save();
    state.set_content(bytes.data(), bytes.size());
  });
}

}  // namespace murosimf::supervise
