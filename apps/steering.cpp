#include "apps/steering.h"

#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/requested_scene.h"

namespace murosimf::app {
namespace {

/// What belongs to one run, and would have to be given up; empty: nothing.
std::string why_it_stays(const RunOptions& options) {
  if (const std::string reason = no_way_back(options); !reason.empty()) return reason;
  const GameArguments& game = options.game;
  if (!game.game_controller.empty() || !game.team_links.empty() || !game.repeat.empty()) {
    return "it has to do with the world outside";
  }
  if (!options.listen.empty() || !options.serial.empty() || !options.booster.empty() || !options.unitree.empty())
    return "its robots have software (--listen, --serial, --booster, --unitree)";
  if (!options.save_at.empty() || !options.save_state.empty()) return "its states are saved (--save-at, --save-state)";
  return options.picture.empty() ? "" : "a picture is made of it (--picture)";
}

std::int64_t seed_of(std::uint64_t seed) {
  constexpr auto most = std::numeric_limits<std::int64_t>::max();  // as of --seed
  if (seed <= static_cast<std::uint64_t>(most)) return static_cast<std::int64_t>(seed);
  throw SetupError(fmt::format("the seed {} must be from 0 to {}", seed, most));
}

}  // namespace

void Steering::begin(session::Session& session, const scene::Scene& scene, const RunOptions& options,
                     RunOutputs& outputs) {
  options_ = &options;
  outputs_ = &outputs;
  if (supervision_) return supervision_->steer(session);
  const std::vector<std::string>& folders = options.supervision.folders;
  if (!allowed_) allowed_ = scene::files_of_run(scene, {folders.begin(), folders.end()}, outputs.files_read());
  supervision_ = supervision_of(session, options.supervision,
                                {.save = [this](scene::Scene& scene) { return outputs_->state_of(scene); },
                                 .exchange = [this](const supervise::SceneRequest& request) { exchange(request); }});
}

void Steering::leave() {
  if (goes_on() && supervision_) return supervision_->leave();
  supervision_.reset();
}

/// It is built as it will be, so that whatever is wrong with it is told, and the present run goes on.
void Steering::exchange(const supervise::SceneRequest& request) {
  if (const std::string reason = why_it_stays(*options_); !reason.empty()) {
    throw SetupError(fmt::format("the run keeps its scene: {}", reason));
  }
  const RunOptions options = options_for(request);
  const scene::SceneOptions scene_options = scene_options_of(options);
  const auto build = [&] {
    scene::Scene scene(options.scene.file, scene_options);
    check_serial(scene.spec(), options.serial);
    check_vendors(scene.spec(), options);
    scene.simulation().initialize();
  };
  try {
    scene::for_outside(options.scene.file, scene_options, build);
  } catch (const scene::RequestError& error) {
    say_warning(fmt::format("a supervisor's scene was refused: {}", error.whole()));
    throw;
  }
  next_ = request;
}

RunOptions Steering::options_for(const supervise::SceneRequest& request) const {
  RunOptions options = first_;
  options.scene.file = request.scene;
  options.scene.overrides = request.overrides;
  options.scene.seed.reset();
  if (request.seed) options.scene.seed = seed_of(*request.seed);
  options.scene.events.clear();
  options.scene.pushes.clear();
  options.scene.plugins.clear();  // they are loaded
  options.scene.only_from = allowed_;
  options.duration.reset();
  options.from.clear();
  options.supervision.paused = request.paused;
  return options;
}

RunOptions Steering::take_next() { return options_for(*std::exchange(next_, std::nullopt)); }

}  // namespace murosimf::app
