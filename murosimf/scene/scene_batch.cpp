#include "murosimf/scene/scene_batch.h"

#include <cstddef>
#include <utility>

#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_state.h"
#include "murosimf/scene_file/scene_change.h"

namespace murosimf::scene {
namespace {

/// Snapshot of everything that a change can modify.
class Before {
 public:
  explicit Before(SceneParts& parts)
      : parts_(&parts),
        state_(save_state(parts)),
        agenda_(parts.simulation->agenda()),
        diagnostics_(parts.diagnostics),
        times_set_(parts.times_set) {}

  /// All changes of a batch are made, or none: the state from before is loaded again.
  void restore() {
    load_state(*parts_, state_);
    parts_->simulation->agenda_was(std::move(agenda_));
    parts_->diagnostics = std::move(diagnostics_);
    parts_->times_set = std::move(times_set_);
    parts_->simulation->publish_poses();
  }

 private:
  SceneParts* parts_;
  std::vector<std::byte> state_;
  Simulation::Agenda agenda_;
  Diagnostics diagnostics_;
  std::map<std::string, int> times_set_;
};

scene_file::SceneEvent checked(const SceneParts& parts, const std::string& text) {
  scene_file::SceneEvent change = scene_file::read_change(parts.spec, text);
  check_change(parts, change);
  return change;
}

}  // namespace

void change_all(SceneParts& parts, const std::vector<std::string>& changes) {
  Simulation& simulation = *parts.simulation;
  simulation.carry_out_commands();  // earlier commands of this instant
  for (const std::string& text : changes) {
    // light and ball are checked later, against the result of the preceding changes
    const scene_file::SceneEvent change = scene_file::read_change(parts.spec, text);
    if (change.section.empty()) check_change(parts, change);
  }
  Before before(parts);
  try {
    for (const std::string& text : changes) {
      const scene_file::SceneEvent change = checked(parts, text);
      simulation.command_queue().note(simulation.now(), text);
      apply_change(parts, change);
    }
  } catch (...) {
    before.restore();
    throw;
  }
  simulation.publish_poses();
}

}  // namespace murosimf::scene
