#include "murosimf/studies/step_learning.h"

#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/motion_engine.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/text_table.h"

namespace murosimf::studies {
namespace {

using locomotion::StepSample;
using Samples = std::vector<StepSample>;

/// [m/s, m/s, rad/s] The first one steps on the spot.
const std::vector<Vec3d> commands{{0.001, 0, 0}, {0.1, 0, 0},   {0.2, 0, 0},       {0.3, 0, 0},
                                  {-0.1, 0, 0},  {0, 0.1, 0},   {0, -0.1, 0},      {0, 0, 0.8},
                                  {0, 0, -0.8},  {0.2, 0, 0.5}, {0.2, -0.05, -0.3}};

struct LearningWalk {
  std::string level;
  Vec3d command;
  bool compliant = false;
  Samples samples;
  bool fell = false;
};

/// Of the program: one of that name in the working directory, like the result of `murosimf tune walk --out walk.toml`, is not meant.
std::string walk_scene() {
  for (const std::filesystem::path& folder : files::data_folders()) {
    const std::filesystem::path file = folder / "scenes" / "walk.toml";
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) return file.string();
  }
  throw SetupError("the scene 'walk', which comes with the program, is not there");
}

/// What the control cycles measured between the first two seconds and the end.
void take_walk(const StepLearningOptions& options, const scene::SceneOptions& common, LearningWalk& walk) {
  scene::Scene scene(walk_scene(), common);
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("walker");
  constexpr double warm_up = 2;  // [s]
  const Duration cycle = from_seconds(1 / locomotion::MotionEngine::rate_hz);
  const auto column = [&](const auto& property) { return robot.base().get(property); };
  for (double time = 0; time < options.duration; time += seconds(cycle)) {
    // Those with which the cycle begins: it measures its signals under them.
    const double phase = column(properties::gait_phase);
    const Vec3d v = column(properties::gait_velocity);
    simulation.run(cycle);
    const locomotion::MotionState state = column(properties::motion_state);
    if (state.falls > 0 || state.mode != 0) walk.fell = true;
    if (walk.fell) return;
    if (time < warm_up || column(properties::gait_amplitude) < 1) continue;
    // A step of the right foot is the mirror image of one of the left: both are fitted together.
    const bool left = phase < pi;
    const double mirror = left ? 1 : -1;
    walk.samples.push_back({.share = (left ? phase : phase - pi) / pi,
                            .velocity = {v.x, mirror * v.y, mirror * v.z},
                            .signals = column(properties::gait_state).signals});
  }
}

std::vector<LearningWalk> walks_of(const StepLearningOptions& options) {
  std::vector<LearningWalk> walks;
  for (const bool compliant : {false, true}) {
    for (const std::string& level : compliant ? options.compliant : options.rigid) {
      for (const Vec3d& command : commands) walks.push_back({level, command, compliant});
    }
  }
  return walks;
}

double error_of(const locomotion::StepTable& table, const std::vector<LearningWalk>& walks) {
  double sum = 0, count = 0;
  for (const LearningWalk& walk : walks) {
    for (const StepSample& sample : walk.samples) {
      const auto steady = locomotion::steady_signals(table, walk.compliant ? 1 : 0, sample.share, sample.velocity);
      sum +=
          std::pow(sample.signals.forward - steady.forward, 2) + std::pow(sample.signals.outward - steady.outward, 2);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Walks are parallel: each is stepped by one thread.
class StepLearner {
 public:
  explicit StepLearner(const StepLearningOptions& options) : options_(options) {
    common_ = options.common;
    common_.threads = 1;
    common_.cameras = false;
    file_ = files::find_data_file(options.model, "models", ".xml");
    kind_ = options.robot ? options.robot : scene::Assets().robot(file_, {.lenient = common_.lenient});
  }

  [[nodiscard]] StepLearning learn() {
    for (int round = 0; round < options_.rounds && !learning_.stopped; ++round) learn_round(round);
    return learning_;
  }

  /// Each round walks with the feedback that counts from the table of the round before.
 private:
  void learn_round(int round) {
    MUROSIMF_ASSERT(round == 0 || !learning_.rounds.empty());
    std::vector<LearningWalk> walks = walks_of(options_);
    const locomotion::StepTablePtr known =
        round == 0 ? nullptr : std::make_shared<const locomotion::StepTable>(learning_.table);
    scene::RobotKind kind = *kind_;
    kind.model = with_balance(*kind.model, options_.balance, known);
    common_.assets = std::make_shared<scene::Assets>();
    common_.assets->put(file_, {.lenient = common_.lenient}, std::move(kind));
    std::mutex mutex;
    run_in_parallel(walks.size(), options_.common.threads, common_.stop, [&](std::size_t i) {
      take_walk(options_, with(walks[i]), walks[i]);
      const std::scoped_lock lock(mutex);
      if (options_.progress) options_.progress(++done_, walks.size() * static_cast<std::size_t>(options_.rounds));
    });
    learning_.stopped = common_.stop && common_.stop();
    if (!learning_.stopped) fit(walks);
  }

  [[nodiscard]] scene::SceneOptions with(const LearningWalk& walk) const {
    scene::SceneOptions options = common_;
    const auto set = [&](std::string text) { options.overrides.push_back(std::move(text)); };
    set("walker.model=" + options_.model);
    set("walker.controller=motions");
    set("walker.level=" + walk.level);
    set(fmt::format("walker.command=[{},{},{}]", walk.command.x, walk.command.y, walk.command.z));
    set("walker.position=[0,0]");
    return options;
  }

  /// Levels with rigid and with compliant joints have tables of their own: their feet lag differently.
  void fit(const std::vector<LearningWalk>& walks) {
    StepLearning::Round round{.walks = walks.size()};
    for (const bool compliant : {false, true}) {
      Samples samples;
      for (const LearningWalk& walk : walks) {
        if (walk.compliant == compliant) samples.insert(samples.end(), walk.samples.begin(), walk.samples.end());
      }
      round.samples += samples.size();
      (compliant ? learning_.table.compliant : learning_.table.rigid) = locomotion::fit_course(samples);
    }
    for (const LearningWalk& walk : walks) round.fell += walk.fell ? 1 : 0;
    round.error = error_of(learning_.table, walks);
    learning_.rounds.push_back(round);
  }

  const StepLearningOptions& options_;
  scene::SceneOptions common_;
  std::filesystem::path file_;  // of the robot
  std::shared_ptr<const scene::RobotKind> kind_;
  StepLearning learning_;
  std::size_t done_ = 0;
};

}  // namespace

ModelPtr with_balance(const Model& model, const OptionValues& balance, const locomotion::StepTablePtr& steps) {
  OptionValues all = balance;
  if (const OptionValues* own = model.find(properties::given_balance, 0)) all.insert(own->begin(), own->end());
  ConstantTable constants = model.constants();
  constants.set(properties::given_balance, 0, all);
  constants.set(properties::given_steps, 0, steps);
  return std::make_shared<const Model>(model.with(std::move(constants)));
}

StepLearning learn_steps(const StepLearningOptions& options) {
  if (!(options.duration > 2)) throw SetupError("a walk to learn from takes more than 2 s");
  return StepLearner(options).learn();
}

std::string to_text(const StepLearning& learning) {
  TextTable table;
  table.add({"round", "walks", "fell", "samples", "error [mm]"});
  for (std::size_t i = 0; i < learning.rounds.size(); ++i) {
    const StepLearning::Round& round = learning.rounds[i];
    table.add({fmt::format("{}", i + 1), fmt::format("{}", round.walks), fmt::format("{}", round.fell),
               fmt::format("{}", round.samples), fmt::format("{:.2f}", 1e3 * round.error)});
  }
  return table.text();
}

}  // namespace murosimf::studies
