#include "murosimf/studies/compare_runs.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/compare_outcome.h"
#include "murosimf/studies/compare_sensors.h"

namespace murosimf::studies {
namespace {

constexpr double longest_record = 36000;  // [s] of which memory could be set aside

/// [s] of processor time that this thread has taken: other programs on the machine do not count.
double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

scene::SceneOptions scene_options(const CompareOptions& options) {
  scene::SceneOptions result;
  result.seed = options.seed;
  result.overrides = options.overrides;
  result.lenient = options.lenient;
  result.stop = options.stop;
  return result;
}

/// Overrides of the gains of all servos. Those of one type are off by the same factor, which the seed decides: it is a number of its
/// table that is not known better.
std::vector<std::string> servo_gains(const CompareOptions& options) {
  if (options.servo_tolerance == 0) return {};
  const scene::Scene scene(options.scene, scene_options(options));
  const Model& model = scene.simulation().world().entity(options.entity).model();
  std::vector<std::string> overrides;
  for (const int object : model.having(properties::servo)) {
    const Servo& servo = *model.find(properties::servo, object);
    const RandomStream stream(scene.spec().seed, "servo_tolerance/" + servo.type);
    const double factor = stream.uniform(0, 1 - options.servo_tolerance, 1 + options.servo_tolerance);
    const auto path = fmt::format("{}.{}.servo", options.entity, model.objects()[object].name);
    overrides.push_back(fmt::format("{}.position_gain={}", path, factor * servo.position_gain));
    if (servo.velocity_gain > 0) {
      overrides.push_back(fmt::format("{}.velocity_gain={}", path, factor * servo.velocity_gain));
    }
  }
  return overrides;
}

void append(const std::vector<std::string>& more, std::vector<std::string>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

/// At the state, in which the robot is then changed: it keeps its motion, as at a change of level in a run.
std::unique_ptr<scene::Scene> build_at_start(const CompareOptions& options, const CompareEntry& entry) {
  auto scene = std::make_unique<scene::Scene>(options.scene, scene_options(options));
  scene->simulation().initialize();
  options.go_to_start(*scene);
  const auto robot = std::ranges::find(scene->spec().robots, options.entity, &scene_file::RobotSpec::name);
  MUROSIMF_ASSERT(robot != scene->spec().robots.end());
  // A copy, which keeps what the robot was before the changes below.
  const scene_file::RobotSpec before = *robot;
  if (before.level != entry.level) scene->exchange_level(options.entity, entry.level);
  if (!entry.contact.empty() && before.contact != entry.contact) scene->exchange_contact(options.entity, entry.contact);
  return scene;
}

/// Overrides are those of the scene, so that all else is the same at every level.
std::unique_ptr<scene::Scene> build(const CompareOptions& options, const CompareEntry& entry) {
  if (options.go_to_start) return build_at_start(options, entry);
  scene::SceneOptions scene = scene_options(options);
  scene.overrides.push_back(fmt::format("{}.level={}", options.entity, entry.level));
  if (!entry.contact.empty()) scene.overrides.push_back(fmt::format("{}.contact={}", options.entity, entry.contact));
  if (entry.traits.servos) append(servo_gains(options), scene.overrides);
  return std::make_unique<scene::Scene>(options.scene, scene);
}

/// The robot that is to change, from the scene as it is.
const scene_file::RobotSpec& find_robot(const scene_file::SceneSpec& spec, const std::string& name) {
  std::vector<std::string_view> names;
  for (const scene_file::RobotSpec& robot : spec.robots) {
    if (robot.name == name) return robot;
    names.emplace_back(robot.name);
  }
  if (name == "ball" && spec.ball) throw SetupError("--entity 'ball': a ball has one level; name a robot");
  if (name == "field") throw SetupError("--entity 'field': the field does not move; name a robot");
  if (names.empty()) throw SetupError(fmt::format("--entity '{}': the scene has no robots", name));
  throw SetupError(fmt::format("--entity '{}': {}", name, unknown_name("robot", name, names)));
}

std::vector<CompareEntry> entries_for(const CompareOptions& options, const scene_file::RobotSpec& robot) {
  for (const std::string& name : options.levels)
    with_context("--levels", [&] { return &find_entry(catalog::levels(), "level", name); });
  std::vector<std::string> laws = options.contacts;
  if (laws.empty()) laws.push_back(robot.contact);
  for (const std::string& name : laws)
    with_context("--contacts", [&] { return &find_entry(catalog::contacts(), "contact law", name); });
  std::vector<CompareEntry> entries;
  for (const catalog::LevelType& level : catalog::levels()) {
    const std::string name(level.name);
    const auto& wanted = options.levels;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    for (const std::string& law : laws) {
      CompareEntry entry;
      entry.level = name;
      entry.traits = level.traits;
      if (level.traits.dynamic) entry.contact = law;
      entries.push_back(std::move(entry));
      if (!level.traits.dynamic) break;  // it has no contact: one run is enough
    }
  }
  return entries;
}

std::vector<NamedOutcome> named_outcomes(const CompareOptions& options, const scene::Scene& scene) {
  std::vector<OutcomeOwner> owners;
  for (const Entity* entity : scene.moving_entities()) {
    owners.push_back({entity->name(), entity->name() == options.entity, !entity->model().joints().empty()});
  }
  std::vector<NamedOutcome> outcomes;
  for (const std::string& text : options.outcomes) outcomes.push_back(named_outcome(text, owners));
  return outcomes;
}

/// A level that changes on the way is none that could be compared.
void check_events(const scene_file::SceneSpec& spec, const std::string& robot) {
  for (const scene_file::SceneEvent& event : spec.events) {
    const bool concerned = std::find(event.entities.begin(), event.entities.end(), robot) != event.entities.end();
    if (!concerned || (event.key != "level" && event.key != "contact")) continue;
    throw SetupError(fmt::format("{}: the {} of '{}' changes on the way; take the event out of the scene to compare it",
                                 event.where, event.key, robot));
  }
}

bool asked_to_stop(const CompareOptions& options) { return options.stop && options.stop(); }

/// Each level runs once to be seen, and `repeat` times to be timed.
void tell(const CompareOptions& options, const Comparison& c, std::size_t runs_done, const std::string& what) {
  if (!options.progress) return;
  const std::size_t all = c.entries.size() * static_cast<std::size_t>(1 + options.repeat);
  MUROSIMF_ASSERT(all > 0);
  options.progress(static_cast<double>(runs_done) / static_cast<double>(all), what);
}

bool has_servos(const Model& model) { return !model.having(properties::servo).empty(); }

/// Runs it once with an observer.
void observe(const CompareOptions& options, const Comparison& comparison, CompareEntry& entry) {
  const auto scene = build(options, entry);
  Simulation& simulation = scene->simulation();
  const Duration start = simulation.now(), end = from_seconds(comparison.end);
  const double longest = comparison.end - comparison.start;
  MUROSIMF_ASSERT(longest > 0);
  Entity& robot = simulation.world().entity(options.entity);
  const bool servos = entry.traits.servos;
  if (servos && !robot.model().joints().empty() && !has_servos(robot.model())) {
    throw SetupError(fmt::format("model '{}' has no servos", robot.model().name()));
  }
  const auto& recorder = simulation.attach<dynamics::MotionRecorder>(
      "motion_recorder", robot, scene->spec().rate,
      dynamics::MotionRecorderOptions{.servos = servos, .longest = longest, .start = comparison.start});
  std::vector<Entity*> others = scene->moving_entities();
  std::erase(others, &robot);
  const auto& outcome =
      simulation.attach<OutcomeRecorder>("outcome_recorder", scene->spec().rate, robot, others, longest);
  const auto& sensors = simulation.attach<InertialRecorder>("inertial_recorder", robot, scene->spec().rate, longest);
  simulation.run(end - start);
  if (simulation.now() < end) {
    entry.stopped = true;
    entry.refusal = fmt::format("stopped at {:.3f} s", seconds(simulation.now()));
    return;
  }
  entry.record = recorder.record();
  entry.outcome = outcome.record();
  entry.sensors = sensors.records();
  entry.measures = measures_of(entry.record);
  if (robot.frozen()) entry.frozen = *robot.frozen_reason();
  entry.overload = dynamics::overload_message(robot);
}

/// A level that cannot run is part of the result, unless none can.
void observe_all(const CompareOptions& options, Comparison& result) {
  for (std::size_t i = 0; i < result.entries.size(); ++i) {
    CompareEntry& entry = result.entries[i];
    tell(options, result, i, fmt::format("{} {}", entry.level, entry.contact));
    try {
      observe(options, result, entry);
    } catch (const SetupError& error) {
      entry.refusal = error.what();
    }
  }
  const auto& entries = result.entries;
  if (asked_to_stop(options)) return;
  if (std::none_of(entries.begin(), entries.end(), [](const CompareEntry& e) { return e.ran(); })) {
    throw SetupError(fmt::format("no level of '{}' can start; {}: {}", options.entity, entries.back().level,
                                 entries.back().refusal));
  }
}

/// The most detailed level that ran; of its laws the first.
std::size_t find_reference(const std::vector<CompareEntry>& entries) {
  std::size_t best = 0;
  bool found = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!entries[i].ran() || (found && entries[best].level == entries[i].level)) continue;
    best = i;
    found = true;
  }
  return best;
}

double timed_run(const CompareOptions& options, double end, const CompareEntry& entry) {
  const auto scene = build(options, entry);
  scene->simulation().initialize();
  const Duration duration = from_seconds(end) - scene->simulation().now();
  const double start = processor_time();
  scene->simulation().run(duration);
  return processor_time() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  MUROSIMF_ASSERT(n > 0);
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Levels take turns, so that a machine that becomes slower does not make one of them look dear.
void measure_cost(const CompareOptions& options, Comparison& result) {
  MUROSIMF_ASSERT(result.end > result.start);
  std::vector<std::vector<double>> times(result.entries.size());
  for (int round = 0; round < options.repeat; ++round) {
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::size_t runs = (static_cast<std::size_t>(round) + 1) * times.size() + i;
      tell(options, result, runs, fmt::format("timing {} of {}", round + 1, options.repeat));
      if (!result.entries[i].ran() || asked_to_stop(options)) continue;
      const double time = timed_run(options, result.end, result.entries[i]);
      if (!asked_to_stop(options)) times[i].push_back(time);
    }
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!times[i].empty()) result.entries[i].cost = 1e6 * median(times[i]) / (result.end - result.start);
  }
}

/// Only up to where one of both begins to fall: after a fall, runs drift apart at any level.
void compare_with(const CompareEntry& reference, CompareEntry& entry) {
  MUROSIMF_ASSERT(entry.ran() && reference.ran());
  const double fall = std::min(fall_begins(entry.record), fall_begins(reference.record));
  entry.compared_until = fall;
  entry.deviations = deviations_of(part_until(entry.record, fall), part_until(reference.record, fall));
  compare_outcome(entry.outcome, reference.outcome, fall, entry.deviations);
  compare_sensors(entry.sensors, reference.sensors, fall, entry.deviations);
}

/// How much servos matter: the reference once more, with the gains of the model.
void observe_as_modeled(const CompareOptions& options, Comparison& result) {
  MUROSIMF_ASSERT(result.reference < result.entries.size());
  const CompareEntry& reference = result.entries[result.reference];
  if (options.servo_tolerance == 0 || asked_to_stop(options)) return;
  if (!reference.traits.servos) {
    throw SetupError(
        fmt::format("--servo-tolerance: {}, the most detailed level that ran, has no servos", reference.level));
  }
  CompareOptions modeled = options;
  modeled.servo_tolerance = 0;
  CompareEntry entry;
  entry.level = reference.level;
  entry.contact = reference.contact;
  entry.traits = reference.traits;
  observe(modeled, result, entry);
  if (!entry.ran()) return;
  compare_with(reference, entry);
  result.as_modeled = std::move(entry);
}

double checked_end(const CompareOptions& options, const scene_file::SceneSpec& spec, double start) {
  const double end = options.end.value_or(spec.duration);
  if (!(end > 0) || end > longest_record) {
    throw SetupError(fmt::format("--duration {}: must be a number above 0 and up to {}", end, longest_record));
  }
  if (end <= start) {
    throw SetupError(
        fmt::format("the run ends at {:g} s, the state is of {:g} s; say a later end: --duration S", end, start));
  }
  return end;
}

}  // namespace

std::string label(const Comparison& comparison, const CompareEntry& entry) {
  const auto other_law = [&](const CompareEntry& e) { return e.level == entry.level && e.contact != entry.contact; };
  const bool several = std::any_of(comparison.entries.begin(), comparison.entries.end(), other_law);
  return several ? fmt::format("{} with {}", entry.level, entry.contact) : entry.level;
}

Comparison compare(const CompareOptions& options) {
  if (options.servo_tolerance > 0 && options.go_to_start) {
    throw SetupError(
        "--servo-tolerance: a state has the servos of its run; begin at the scene's start (without --from)");
  }
  if (options.repeat < 0) throw SetupError(fmt::format("--repeat {}: must be at least 0", options.repeat));
  Comparison result;
  {
    // This scene only checks the options; every run builds its own.
    scene::Scene scene(options.scene, scene_options(options));
    const scene_file::SceneSpec& spec = scene.spec();
    result.scene = spec.name;
    result.entity = options.entity;
    const std::vector<CompareEntry> entries = entries_for(options, find_robot(spec, options.entity));
    check_events(spec, options.entity);
    result.outcomes = named_outcomes(options, scene);
    if (options.go_to_start) {
      scene.simulation().initialize();
      options.go_to_start(scene);
    }
    result.start = seconds(scene.simulation().now());
    result.end = checked_end(options, spec, result.start);
    result.seed = spec.seed;
    result.repeat = options.repeat;
    result.entries = entries;
  }
  observe_all(options, result);
  result.reference = find_reference(result.entries);
  const CompareEntry& reference = result.entries[result.reference];
  for (CompareEntry& entry : result.entries) {
    if (entry.ran()) compare_with(reference, entry);
  }
  observe_as_modeled(options, result);
  measure_cost(options, result);
  result.stopped = asked_to_stop(options);
  return result;
}

}  // namespace murosimf::studies
