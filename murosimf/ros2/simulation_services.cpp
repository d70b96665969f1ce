#include "murosimf/ros2/simulation_services.h"

#include <algorithm>
#include <cctype>
#include <chrono>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::ros2 {

using namespace std::chrono_literals;

namespace {

constexpr std::chrono::milliseconds look_again = 100ms, look_at_steps = 2ms, answer_arrives = 100ms;
constexpr auto step_done = 200us;
constexpr std::uint64_t most_steps = 1'000'000'000;  // as of a supervisor

/// "GetEntities" is "/get_entities".
std::string service_name(const std::string& type) {
  std::string name;
  for (const char c : type) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0) name += name.empty() ? '/' : '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

}  // namespace

SimulationServices::SimulationServices(session::Session& session, int domain, SimulationServicesOptions options)
    : session_(session),
      options_(std::move(options)),
      spawned_(options_.models_from, options_.say),
      participant_(domain),
      steps_(session, participant_, inbox_),
      tick_(session.scene().simulation().tick()) {
  const session::SessionStatus status = session.status();
  stopped_ = status.paused && status.time == Duration{};
  note_starts(session.scene());
  offer_all();
  thread_ = std::thread([this] { serve(); });
}

SimulationServices::~SimulationServices() {
  ends_ = true;
  thread_.join();
}

void SimulationServices::offer(const std::string& type, Handler handle) {
  const char mark = static_cast<char>('A' + offers_.size());
  auto service = std::make_unique<dds::ros2::Service>(participant_, service_name(type),
                                                      "simulation_interfaces/srv/" + type, inbox_, mark);
  offers_.emplace(mark, Offer{handle, std::move(service)});
}

void SimulationServices::offer_all() {
  using Self = SimulationServices;
  offer("GetSimulatorFeatures", &Self::get_features);
  offer("GetEntities", &Self::get_entities);
  offer("GetEntitiesStates", &Self::get_entities_states);
  offer("GetEntityState", &Self::get_entity_state);
  offer("SetEntityState", &Self::set_entity_state);
  offer("GetEntityInfo", &Self::get_entity_info);
  offer("SetEntityInfo", &Self::set_entity_info);
  offer("GetEntityBounds", &Self::get_entity_bounds);
  offer("GetSpawnables", &Self::get_spawnables);
  offer("SpawnEntity", &Self::spawn_entity);
  offer("SpawnEntities", &Self::spawn_entities);
  offer("DeleteEntity", &Self::delete_entity);
  offer("ResetSimulation", &Self::reset_simulation);
  offer("StepSimulation", &Self::step_simulation);
  offer("GetSimulationState", &Self::get_simulation_state);
  offer("SetSimulationState", &Self::set_simulation_state);
  offer("GetCurrentWorld", &Self::get_current_world);
  offer("GetAvailableWorlds", &Self::get_available_worlds);
  offer("LoadWorld", &Self::load_world);
  offer("UnloadWorld", &Self::refuse);
  offer("GetNamedPoses", &Self::get_named_poses);
  offer("GetNamedPoseBounds", &Self::get_named_pose_bounds);
}

void SimulationServices::serve() noexcept {
  while (!ends_) {
    inbox_.wait(steps_.is_busy() ? look_at_steps : look_again);
    steps_.advance();
    for (const dds::Arrival& arrival : inbox_.take()) {
      if (!ends_) answer(arrival);
    }
  }
}

/// A damaged request has no answer: its client would wait for one of another form.
void SimulationServices::answer(const dds::Arrival& arrival) {
  dds::ros2::ServiceCall call;
  const bool opened = dds::ros2::open_call(arrival.message, arrival.from, call);
  if (opened && StepAction::is_own(arrival.topic)) {
    if (steps_.take(arrival.topic, call)) return;
  } else if (opened) {
    const auto offered = offers_.find(arrival.topic);
    MUROSIMF_ASSERT(offered != offers_.end());
    dds::CdrReader in(call.request);
    Answer out;
    (this->*offered->second.handle)(in, out);
    if (in.good()) {
      offered->second.service->answer(call, out.encoded());
      return finish_if_wanted();
    }
  }
  if (options_.say && !std::exchange(told_of_garbage_, true))
    options_.say("a request over ROS 2 that is damaged, or of another version of simulation_interfaces, was ignored");
}

/// After the answer: with the run its participant ends.
void SimulationServices::finish_if_wanted() {
  if (!std::exchange(finishes_, false)) return;
  std::this_thread::sleep_for(answer_arrives);
  session_.finish();
}

void SimulationServices::visit(const std::function<void(scene::Scene&)>& look) { session_.visit(look).get(); }

Result SimulationServices::attempt(const std::function<void()>& call) const {
  try {
    call();
    return {};
  } catch (const SetupError& error) {
    return {ResultCode::operation_failed, files::one_line(error.what())};
  }
}

Result SimulationServices::change(const std::vector<std::string>& changes) {
  return attempt([&] { session_.change(changes).get(); });
}

/// Returns when the steps are made, or another command has taken the run to another time.
Result SimulationServices::step(std::uint64_t steps) {
  const session::SessionStatus before = session_.status();
  if (!before.paused) return {ResultCode::operation_failed, "the simulation is not paused"};
  if (steps > most_steps) return {ResultCode::operation_failed, fmt::format("at most {} steps", most_steps)};
  if (steps == 0) return {};
  session_.step(static_cast<std::int64_t>(steps));
  const Duration end = before.time + static_cast<Duration::rep>(steps) * tick_;
  session::SessionStatus now = session_.status();
  while (now.time < end && now.jumps == before.jumps && !ends_) {
    std::this_thread::sleep_for(step_done);
    now = session_.status();
  }
  stopped_ = false;
  if (now.time >= end) return {};
  return {ResultCode::operation_failed, "another command has taken the run to another time"};
}

SimulationState SimulationServices::state() const {
  const session::SessionStatus status = session_.status();
  if (!status.paused) return SimulationState::playing;
  return stopped_ && status.time == Duration{} ? SimulationState::stopped : SimulationState::paused;
}

Result SimulationServices::go_to(SimulationState wanted) {
  if (wanted == state()) return {ResultCode::already_in_target_state, ""};
  if (wanted == SimulationState::playing) {
    session_.go_on();
  } else if (wanted == SimulationState::paused) {
    session_.pause();
  } else if (wanted == SimulationState::quitting) {
    finishes_ = true;
  } else if (wanted == SimulationState::stopped) {
    session_.pause();
    const Result reset = attempt([&] { session_.reset().get(); });
    if (reset.code != ResultCode::ok) return reset;
  } else {
    return {ResultCode::operation_failed, "there is no such state to set"};
  }
  stopped_ = wanted == SimulationState::stopped;
  // the status is that of after the request
  return wanted == SimulationState::quitting ? Result{} : attempt([&] {
    for (int i = 0; i < 2; ++i) visit([](scene::Scene&) {});
  });
}

void SimulationServices::get_features(dds::CdrReader&, Answer& out) {
  using F = Feature;
  std::vector<F> features{F::spawning,
                          F::deleting,
                          F::named_poses,
                          F::pose_bounds,
                          F::entity_tags,
                          F::entity_bounds,
                          F::entity_categories,
                          F::spawning_resource_string,
                          F::entity_state_getting,
                          F::entity_state_setting,
                          F::entity_info_getting,
                          F::entity_info_setting,
                          F::spawnables,
                          F::simulation_reset,
                          F::simulation_reset_spawned,
                          F::simulation_state_getting,
                          F::simulation_state_setting,
                          F::simulation_state_pause,
                          F::step_simulation_single,
                          F::step_simulation_multiple,
                          F::step_simulation_action};
  if (options_.exchange) features.push_back(F::world_loading);
  features.insert(features.end(), {F::world_info_getting, F::available_worlds, F::spawning_entities});
  out.u32(static_cast<std::uint32_t>(features.size()));
  for (const F feature : features) out.u16(static_cast<std::uint16_t>(feature));
  out.texts(std::vector<std::string>{"mjcf", "urdf", "sdf"});
  out.text("MuRoSimF; simulation_interfaces 2.1; docs/ros2.md");
}

void SimulationServices::reset_simulation(dds::CdrReader& in, Answer& out) {
  constexpr std::uint8_t by_default = 0, spawned = 4, all_three = 7, all = 255;  // SCOPE_TIME and SCOPE_STATE are 1, 2
  const auto scope = in.number<std::uint8_t>();
  if (!in.good()) return;
  if (scope == spawned) return put(out, remove_spawned());
  if (scope != by_default && scope != all && scope != all_three)
    return put(out,
               {ResultCode::feature_unsupported, "everything is reset together (SCOPE_ALL), or SCOPE_SPAWNED alone"});
  put(out, attempt([&] { session_.reset().get(); }));
}

void SimulationServices::step_simulation(dds::CdrReader& in, Answer& out) {
  const auto steps = in.number<std::uint64_t>();
  if (in.good()) put(out, step(steps));
}

void SimulationServices::get_simulation_state(dds::CdrReader&, Answer& out) {
  out.u8(static_cast<std::uint8_t>(state()));
  put(out, Result{});
}

void SimulationServices::set_simulation_state(dds::CdrReader& in, Answer& out) {
  const auto wanted = in.number<std::uint8_t>();
  if (in.good()) put(out, go_to(static_cast<SimulationState>(wanted)));
}

void SimulationServices::refuse(dds::CdrReader&, Answer& out) {
  put(out, {ResultCode::feature_unsupported, "see GetSimulatorFeatures"});
}

}  // namespace murosimf::ros2
