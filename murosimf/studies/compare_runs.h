/// compare_runs.h - runs the same experiment at several levels and contact laws, and measures what each costs.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/studies/compare_metrics.h"
#include "murosimf/studies/inertial_recorder.h"
#include "murosimf/studies/named_outcome.h"
#include "murosimf/studies/outcome_recorder.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::scene {
class Scene;
}

namespace murosimf::studies {

struct CompareOptions {
  std::string scene;                   ///< file, or name of a scene that comes with the program
  std::string entity;                  ///< the robot whose level changes; all others stay as the scene has them
  std::vector<std::string> levels;     ///< empty: all
  std::vector<std::string> contacts;   ///< empty: the scene's for that robot
  std::vector<std::string> overrides;  ///< PATH=VALUE, as for --set
  std::optional<double> end;           ///< [s] simulated time at which runs end, instead of the scene's
  std::optional<std::uint64_t> seed;   ///< instead of the scene's
  int repeat = 3;                      ///< timed runs per level; their median counts. 0: costs are not measured
  std::vector<std::string>
      outcomes;          ///< OWNER.QUANTITY or OWNER.QUANTITY=TOLERANCE: they alone decide; empty: everything
  bool lenient = false;  ///< accept unknown elements in model files
  double servo_tolerance =
      0;  ///< [1] share by which gains of the robot's servos are off, at levels that have servos: at most
  /// Brings a scene that was just built to where all runs begin, for example to a saved state; empty: its own beginning.
  std::function<void(scene::Scene& scene)> go_to_start{};
  /// Called with what runs now and the share of the work that is done; may be empty.
  std::function<void(double share, const std::string& what)> progress{};
  std::function<bool()> stop{};  ///< true: ends with the results so far; may be empty
};

/// One level under one contact law.
struct CompareEntry {
  std::string level;
  LevelTraits traits;    ///< of the level
  std::string contact;   ///< empty at levels without contact
  std::string refusal;   ///< why it did not run; empty: it ran
  bool stopped = false;  ///< it did not run to its end because `stop` was true
  std::string frozen;    ///< why the robot was frozen on the way; empty: it was not
  std::string overload;  ///< which servos were too weak for their targets (full_dynamics); empty: none
  dynamics::MotionRecord record;
  OutcomeRecord outcome;
  std::vector<InertialRecord> sensors;  ///< of its accelerometers and gyroscopes
  Measures measures;
  Deviations deviations;  ///< from the reference
  /// [s] Up to when the robot was compared: one of both begins to fall there; infinity: none does.
  double compared_until = std::numeric_limits<double>::infinity();
  double cost = 0;  ///< [us] of processor time per simulated second, of the whole scene; 0: not measured
  [[nodiscard]] bool ran() const { return refusal.empty(); }
  /// "could not start: ...", "stopped at 1.234 s".
  [[nodiscard]] std::string why_not() const { return (stopped ? "" : "could not start: ") + refusal; }
};

struct Comparison {
  std::string scene, entity;
  double start = 0, end = 0;  ///< [s] simulated time, from when to when
  std::uint64_t seed = 0;
  int repeat = 0;
  std::vector<NamedOutcome> outcomes;
  std::vector<CompareEntry> entries;  ///< levels from simple to detailed, laws as they were asked for
  /// If gains of servos vary: the reference with those of the model, compared with the reference that has others.
  std::optional<CompareEntry> as_modeled{};
  std::size_t reference = 0;  ///< the most detailed level that ran, under the first law
  bool stopped = false;       ///< before all had run and been timed: maybe none ran, maybe no cost is known
};

/// "full_dynamics", or "full_dynamics with paper" if the level ran under several laws.
[[nodiscard]] std::string label(const Comparison& comparison, const CompareEntry& entry);

/// Throws SetupError for users' errors: unknown scene, entity, level or law (with the nearest name), an entity without levels,
/// no level that can start. A level that the model or the scene cannot have is no error: its entry says why.
[[nodiscard]] Comparison compare(const CompareOptions& options);

}  // namespace murosimf::studies
