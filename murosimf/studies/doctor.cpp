#include "murosimf/studies/doctor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/studies/doctor_cases.h"
#include "murosimf/studies/parallel_runs.h"

namespace murosimf::studies {
namespace {

constexpr double cos_fallen = 0.5;         // [1] of the lean: 60 degrees, as falls are counted
constexpr double far = 0.5, least = 0.25;  // [1] of the median way; [m]

/// The axis of a robot's base that points up when it stands, found where its start says how it leans; world z of that axis later.
class Upright {
 public:
  /// `dynamic`: its level starts with the lean of the file; others put it upright.
  Upright(const scene_file::RobotSpec& spec, Entity& robot, bool dynamic) : robot_(&robot) {
    const Vec3d leaning =
        rotation_z(spec.heading) * (rotation_y(spec.pitch) * (rotation_x(spec.roll) * Vec3d{0, 0, 1}));
    const Vec3d up = dynamic ? leaning : Vec3d{0, 0, 1};
    axis_ = transpose(robot.base().get(properties::orientation)) * up;
    began_up_ = up.z > cos_fallen;
  }
  [[nodiscard]] const Entity& robot() const { return *robot_; }
  [[nodiscard]] Ending ending(int falls) const {
    const bool up = (robot_->base().get(properties::orientation) * axis_).z > cos_fallen;
    if (!began_up_) return up ? Ending::stands : Ending::lies;
    if (falls == 0) return Ending::stands;
    return up ? Ending::got_up : Ending::fell;
  }

 private:
  Entity* robot_;
  Vec3d axis_;
  bool began_up_;
};

std::vector<Upright> robots_of(scene::Scene& scene) {
  std::vector<Upright> robots;
  for (const scene_file::RobotSpec& spec : scene.spec().robots) {
    Entity& robot = scene.simulation().world().entity(spec.name);
    const MotionLevel* level = scene.simulation().level_of(robot);
    robots.emplace_back(spec, robot, level && level->traits().dynamic);
  }
  return robots;
}

Ending ending_of(const scene::EntityReport& report, const std::vector<Upright>& robots) {
  if (report.frozen) return Ending::frozen;
  if (!report.present) return Ending::absent;
  const auto robot = std::ranges::find(robots, report.name, [](const Upright& one) { return one.robot().name(); });
  return robot == robots.end() ? Ending::there : robot->ending(report.falls);
}

/// Nothing if it was stopped.
std::vector<EntityEnding> run(scene::Scene& scene, Duration duration) {
  scene.simulation().initialize();
  const std::vector<Upright> robots = robots_of(scene);
  scene.simulation().run(duration);
  std::vector<EntityEnding> endings;
  if (scene.simulation().stopped()) return endings;
  for (const scene::EntityReport& report : make_report(scene).entities) {
    endings.push_back({report.name, ending_of(report, robots), report.distance, false});
  }
  return endings;
}

/// A scene that cannot be built is a result, too.
DoctorRun run_case(const DoctorOptions& options, const DoctorCase& one, Duration duration) {
  DoctorRun result{one.label, {}, {}};
  scene::SceneOptions changed = options.common;
  // Runs are parallel: one thread steps each of them.
  changed.threads = 1;
  changed.overrides.insert(changed.overrides.end(), one.overrides.begin(), one.overrides.end());
  if (one.seed) changed.seed = one.seed;
  try {
    scene::Scene scene(options.scene, changed);
    result.entities = run(scene, duration);
  } catch (const SetupError& error) {
    result.refused = error.what();
  }
  return result;
}

double median_way(const DoctorDimension& dimension, std::size_t entity) {
  std::vector<double> ways;
  for (const DoctorRun& run : dimension.runs) {
    if (entity < run.entities.size() && std::isfinite(run.entities[entity].way))
      ways.push_back(run.entities[entity].way);
  }
  if (ways.empty()) return std::numeric_limits<double>::quiet_NaN();  // frozen in every run
  // The upper one of two in the middle: a way that a run really has.
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
  std::ranges::nth_element(ways, middle);
  return *middle;
}

/// What is otherwise than in the scene as it is; empty: nothing.
std::string difference(const EntityEnding& one, const EntityEnding& as_it_is, double median) {
  if (one.ending == Ending::frozen && as_it_is.ending == Ending::frozen) return "is frozen, also as it is";
  if (one.ending != as_it_is.ending) {
    return fmt::format("{}; as it is: {}", name_of(one.ending), name_of(as_it_is.ending));
  }
  const double away = std::abs(one.way - median);
  if (std::isfinite(one.way) && (away <= least || away <= far * median)) return {};
  return fmt::format("goes {:.2f} m; the median is {:.2f} m", one.way, median);
}

void find_flips(DoctorDimension& dimension, std::vector<std::string>& flips) {
  MUROSIMF_ASSERT(!dimension.runs.empty());
  const std::vector<EntityEnding>& as_it_is = dimension.runs.front().entities;
  for (DoctorRun& run : dimension.runs) {
    for (std::size_t i = 0; i < run.entities.size() && i < as_it_is.size(); ++i) {
      const std::string what = difference(run.entities[i], as_it_is[i], median_way(dimension, i));
      if (what.empty()) continue;
      run.entities[i].flips = true;
      flips.push_back(fmt::format("{}, {}: {}: {}", dimension.name, run.label, run.entities[i].name, what));
    }
  }
}

}  // namespace

std::string name_of(Ending ending) {
  switch (ending) {
    case Ending::stands: return "stands";
    case Ending::got_up: return "got up";
    case Ending::fell: return "fell";
    case Ending::lies: return "lies";
    case Ending::there: return "";
    case Ending::absent: return "absent";
    case Ending::frozen: break;
  }
  return "frozen";
}

Checkup examine(const DoctorOptions& given) {
  DoctorOptions options = given;
  // All runs share models and meshes, which hardly any change affects.
  if (!options.common.assets) options.common.assets = std::make_shared<scene::Assets>();
  scene::SceneOptions unchanged = options.common;
  unchanged.threads = 1;
  scene::Scene scene(options.scene, unchanged);
  const Duration duration = from_seconds(options.duration.value_or(scene.spec().duration));
  Checkup checkup{.scene = scene.spec().name, .duration = seconds(duration), .dimensions = {}, .flips = {}};

  std::vector<DoctorCase> cases{{"as it is", {}, {}}};
  const std::vector<CasesOfDimension> dimensions = doctor_cases(options, scene);
  for (const CasesOfDimension& one : dimensions) cases.insert(cases.end(), one.cases.begin(), one.cases.end());
  std::vector<DoctorRun> runs(cases.size());
  std::mutex mutex;
  std::size_t done = 0;
  run_in_parallel(cases.size(), options.common.threads, options.common.stop, [&](std::size_t i) {
    runs[i] = run_case(options, cases[i], duration);
    const std::lock_guard lock(mutex);
    ++done;
    if (options.progress) options.progress(done, cases.size());
  });
  checkup.stopped = options.common.stop && options.common.stop();
  if (checkup.stopped) return checkup;
  // The scene must run as it is; only changes of it may be refused.
  if (!runs.front().refused.empty()) throw SetupError(runs.front().refused);

  auto next = runs.begin() + 1;
  for (const CasesOfDimension& one : dimensions) {
    DoctorDimension dimension{one.name, one.skipped, {}};
    if (!one.cases.empty()) dimension.runs.push_back(runs.front());
    const auto end = next + static_cast<std::ptrdiff_t>(one.cases.size());
    std::move(next, end, std::back_inserter(dimension.runs));
    next = end;
    if (!dimension.runs.empty()) find_flips(dimension, checkup.flips);
    checkup.dimensions.push_back(std::move(dimension));
  }
  MUROSIMF_ASSERT(next == runs.end());
  return checkup;
}

}  // namespace murosimf::studies
