/// simulation_services.h - a run steered by clients of simulation_interfaces, the standard services of ROS 2 for simulators.
///
///     get_simulator_features, get_entities, get_entities_states, get_entity_state, set_entity_state, get_entity_info, set_entity_info,
///     get_entity_bounds, get_spawnables, spawn_entity, spawn_entities, delete_entity, reset_simulation, step_simulation, get_simulation_state, set_simulation_state,
///     get_current_world, get_available_worlds, load_world, unload_world, get_named_poses, get_named_pose_bounds; the action simulate_steps
///
/// Requests are answered one after the other, in a thread of its own, by the session: what they change are commands of the run, as of a supervisor. What
/// comes with them names entities of the scene, and scenes and models in the folders that the run was started with, or is the text of a
/// model that reads no other file of these; nothing else (SECURITY.md).
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/dds/ros2/service.h"
#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/ros2/spawned_entities.h"
#include "murosimf/ros2/step_action.h"
#include "murosimf/session/session.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::ros2 {

struct SimulationServicesOptions {
  /// As of supervise::SupervisionOptions: stores the request for another scene, or throws SetupError. None: the run keeps its scene.
  std::function<void(const supervise::SceneRequest&)> exchange{};
  /// Files that models to be spawned may be made of; null: those that come with the program.
  std::shared_ptr<const files::AllowedFiles> models_from{};
  /// One line for the first damaged request, and for each model with an error; called by other threads.
  std::function<void(const std::string& line)> say{};
};

class SimulationServices {
 public:
  /// The session outlives it. It has a participant of its own, which ends with it. Throws SetupError.
  SimulationServices(session::Session& session, int domain, SimulationServicesOptions options);
  ~SimulationServices();
  SimulationServices(const SimulationServices&) = delete;
  SimulationServices& operator=(const SimulationServices&) = delete;

 private:
  using Answer = dds::ros2::RosWriter;
  using Handler = void (SimulationServices::*)(dds::CdrReader&, Answer&);
  struct Offer {
    Handler handle = nullptr;
    std::unique_ptr<dds::ros2::Service> service;
  };
  void offer(const std::string& type, Handler handle);
  void offer_all();
  void serve() noexcept;
  void answer(const dds::Arrival& arrival);
  void finish_if_wanted();
  void visit(const std::function<void(scene::Scene&)>& look);
  [[nodiscard]] Result attempt(const std::function<void()>& call) const;
  /// Calls `found` for each entity that the filters choose, between two steps.
  [[nodiscard]] Result find(const EntityFilters& filters,
                            const std::function<void(const scene::Scene&, const Entity&)>& found);
  [[nodiscard]] Result change(const std::vector<std::string>& changes);
  [[nodiscard]] Result step(std::uint64_t steps);
  [[nodiscard]] Result spawn(SpawnRequest& wanted, std::string& name);
  [[nodiscard]] Result remove_spawned();
  [[nodiscard]] EntityInfo info_of(const scene::Scene& scene, const Entity& entity) const;
  void note_starts(const scene::Scene& scene);

  // Of a service each: read the request, and write the answer.
  void get_features(dds::CdrReader& in, Answer& out);
  void get_entities(dds::CdrReader& in, Answer& out);
  void get_entities_states(dds::CdrReader& in, Answer& out);
  void get_entity_state(dds::CdrReader& in, Answer& out);
  void set_entity_state(dds::CdrReader& in, Answer& out);
  void get_entity_info(dds::CdrReader& in, Answer& out);
  void set_entity_info(dds::CdrReader& in, Answer& out);
  void get_entity_bounds(dds::CdrReader& in, Answer& out);
  void get_spawnables(dds::CdrReader& in, Answer& out);
  void spawn_entity(dds::CdrReader& in, Answer& out);
  void spawn_entities(dds::CdrReader& in, Answer& out);
  void delete_entity(dds::CdrReader& in, Answer& out);
  void reset_simulation(dds::CdrReader& in, Answer& out);
  void step_simulation(dds::CdrReader& in, Answer& out);
  void get_simulation_state(dds::CdrReader& in, Answer& out);
  void set_simulation_state(dds::CdrReader& in, Answer& out);
  void get_current_world(dds::CdrReader& in, Answer& out);
  void get_available_worlds(dds::CdrReader& in, Answer& out);
  void load_world(dds::CdrReader& in, Answer& out);
  void refuse(dds::CdrReader& in, Answer& out);
  void get_named_poses(dds::CdrReader& in, Answer& out);
  void get_named_pose_bounds(dds::CdrReader& in, Answer& out);

  [[nodiscard]] SimulationState state() const;
  [[nodiscard]] Result go_to(SimulationState wanted);

  session::Session& session_;
  SimulationServicesOptions options_;
  SpawnedEntities spawned_;
  std::map<std::string, EntityInfo> infos_;  // that clients have set
  std::vector<NamedPose> starts_;
  dds::Inbox inbox_;
  dds::Participant participant_;  // ends before the inbox
  StepAction steps_;
  std::map<char, Offer> offers_;
  Duration tick_{};
  bool stopped_ = false, finishes_ = false, told_of_garbage_ = false;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::ros2
