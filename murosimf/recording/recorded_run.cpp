#include "murosimf/recording/recorded_run.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/files/file_access.h"
#include "murosimf/league/league.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_external_input.h"

namespace murosimf::recording {
namespace {

/// Recordings without a description can be looked at, but not repeated.
RunDescription description_of(const McapReader& file, const std::vector<RecordedAddition>& additions) {
  return with_context(file.file().string(), [&] {
    const std::string json = attached_text(file, "run.json");
    if (json.empty())
      throw SetupError("it does not say how its run was begun: a program that embeds it, or one of before");
    RunDescription run = parse_run_description(json);
    for (const RecordedAddition& addition : additions) {
      run.names.insert(addition.names.begin(), addition.names.end());
      for (const std::string& channel : addition.channels) {
        if (std::ranges::find(run.channels, channel) == run.channels.end()) run.channels.push_back(channel);
      }
    }
    return run;
  });
}

/// A scene with its external participants.
struct RepeatedScene {
  RepeatedScene(const std::string& file, const scene::SceneOptions& options) : scene(file, options) {}
  scene::Scene scene;
  std::optional<league::League> league{};  // destroyed first
};

/// Whether there is a participant with a channel that begins like this.
bool takes_part(const RunDescription& run, std::string_view begin) {
  return std::ranges::any_of(run.channels, [&](const std::string& name) { return name.starts_with(begin); });
}

}  // namespace

RecordedRun::RecordedRun(const std::filesystem::path& file)
    : file_(file),
      additions_(recorded_additions(file_)),
      description_(description_of(file_, additions_)),
      files_(file_),
      states_(file_) {
  moved_ = std::make_shared<const files::MovedFiles>(files_.folder(), description_.names);
  if (!description_.channels.empty()) {
    outside_ = with_context(file.string(), [&] { return recorded_external_input(file_); });
  }
  end_ = Duration(static_cast<Duration::rep>(file_.contents().statistics.end_time));
}

/// Everything that could make the repeated run another one is refused here.
std::shared_ptr<scene::Scene> RecordedRun::build(const RepeatOptions& options) const {
  const RunDescription& run = description_;
  return with_context(file_.file().string(), [&] {
    if (run.libraries && !options.libraries) {
      throw SetupError("control software was loaded for this run; it may do what it likes: allow it with --libraries");
    }
    if (!run.outside.empty()) {
      throw SetupError(fmt::format("{} took part in this run, of which there is no record", run.outside.front()));
    }
    scene::SceneOptions scene_options{.threads = options.threads,
                                      .seed = run.seed,
                                      .overrides = run.overrides,
                                      .events = run.events,
                                      .pushes = run.pushes,
                                      .libraries = run.libraries,
                                      .lenient = run.lenient,
                                      .lanes = options.lanes,
                                      .cameras = options.cameras.value_or(run.cameras),
                                      .pushable = run.pushable,
                                      .files = {.moved = moved_},
                                      .stop = options.stop};
    scene_options.overrides.insert(scene_options.overrides.end(), options.overrides.begin(), options.overrides.end());
    if (outside_) scene_options.outside.repeated = outside_;
    if (outside_ && options.recorded) scene_options.outside.notes = std::make_shared<ExternalInputLog>();
    const auto repeated = std::make_shared<RepeatedScene>(run.scene, scene_options);
    check_repeatable(repeated->scene);
    if (takes_part(run, "game") || takes_part(run, "team:")) {
      repeated->league.emplace(repeated->scene, league::LeagueOptions{.outside = scene_options.outside});
    }
    return std::shared_ptr<scene::Scene>(repeated, &repeated->scene);
  });
}

std::unique_ptr<scene::Scene> RecordedRun::build_to_show(const RepeatOptions& options) const {
  return with_context(file_.file().string(), [&] {
    return std::make_unique<scene::Scene>(description_.scene, scene::SceneOptions{.threads = options.threads,
                                                                                  .seed = description_.seed,
                                                                                  .overrides = description_.overrides,
                                                                                  .events = description_.events,
                                                                                  .pushes = description_.pushes,
                                                                                  .lenient = description_.lenient,
                                                                                  .cameras = false,
                                                                                  .only_shown = true,
                                                                                  .files = {.moved = moved_},
                                                                                  .stop = options.stop});
  });
}

void RecordedRun::check_repeatable(const scene::Scene& scene) const {
  for (const scene_file::RobotSpec& robot : scene.spec().robots) check_repeatable(robot);
  for (const RecordedAddition& addition : additions_) {
    if (const auto* robot = std::get_if<scene_file::RobotSpec>(&addition.what)) check_repeatable(*robot);
  }
}

/// Software outside of the program is repeated from what it sent, which must be in the recording.
void RecordedRun::check_repeatable(const scene_file::RobotSpec& robot) const {
  const bool over_dds = robot.controller == "booster" || robot.controller == "unitree" || robot.controller == "ros2";
  if (!over_dds && robot.controller != "tcp" && robot.controller != "serial") return;
  if (takes_part(description_, (over_dds ? "dds" : robot.controller) + ":" + robot.name)) return;
  throw SetupError(fmt::format("'{}' was moved by another program (controller '{}'), of which there is no record",
                               robot.name, robot.controller));
}

void RecordedRun::initialize(scene::Scene& scene) const {
  const files::FileScope scope(access());
  scene.simulation().initialize();
}

void RecordedRun::add_until(scene::Scene& scene, Duration state) const {
  const files::FileScope scope(access());
  for (const RecordedAddition& addition : additions_) {
    if (is_part_of(addition, state)) add_to(scene, addition);
  }
}

/// One that no state of its time has comes after all that looks at the scene then.
void RecordedRun::schedule(scene::Scene& scene, const RecordedAddition& addition) const {
  const auto add = [this, &scene, &addition] {
    const files::FileScope scope(access());
    add_to(scene, addition);
  };
  scene.simulation().at(addition.time, [&scene, &addition, add] {
    addition.in_state ? add() : scene.simulation().at(addition.time, add);
  });
}

/// From the last state before the time; the rest of the way is stepped.
void RecordedRun::begin(scene::Scene& scene, Duration time, bool states) const {
  initialize(scene);
  const Duration start = description_.start;
  const RecordedState* from = states_.last_until(states ? std::max(time, start) : start);
  const bool loads = from && (states || start > Duration{});
  if (loads) {
    add_until(scene, from->time);
    states_.load(scene, *from);
  }
  if (!from && start > Duration{})
    throw SetupError(file_.file().string() + ": the state with which it began is missing");
  for (const RecordedAddition& addition : additions_) {
    if (!loads || !is_part_of(addition, from->time)) schedule(scene, addition);
  }
  for (const Command& command : states_.commands()) {
    if (command.time < scene.simulation().now()) continue;
    scene.simulation().at(command.time, [&scene, text = command.text] { static_cast<void>(scene.post(text)); });
  }
}

}  // namespace murosimf::recording
