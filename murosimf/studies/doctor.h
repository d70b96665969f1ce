/// doctor.h - does a scene end as it does only because of the step, the seed, the gains? One thing is changed at a time.
///
///     const studies::Checkup checkup = studies::examine({.scene = "get_up"});
///     fmt::print("{}", to_text(checkup));
///
///     steps     of 0.5, 1, 2, 5 and 10 ms
///     levels    all robots at each level of the program
///     gravity   none, that of the moon, that of the earth
///     seeds     1 to 5
///     servos    position and velocity gains of all servos 20 % lower and higher
///
/// A flip is a run in which a robot or body ends otherwise than in the scene as it is: it was frozen, fell or lies and does not otherwise,
/// or its way differs from the median of these runs by more than half of that and more than 0.25 m.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::studies {

struct DoctorOptions {
  std::string scene;
  bool quick = false;                     ///< the ends of each row only
  std::vector<std::string> dimensions{};  ///< names; none: all
  std::optional<double> duration{};       ///< [s] instead of the scene's
  scene::SceneOptions common{};           ///< of all runs; `threads`: runs at a time, each is stepped by one
  std::function<void(std::size_t done, std::size_t all)> progress{};  ///< from any thread, one at a time
};

/// How a run has ended for one entity.
enum class Ending {
  stands,  ///< a robot; it never fell, or began lying
  got_up,  ///< it fell, and stands
  fell,    ///< it fell, and lies
  lies,    ///< as it began
  there,   ///< no robot
  absent,  ///< not in the scene
  frozen,  ///< its numbers were no longer plausible
};
[[nodiscard]] std::string name_of(Ending ending);

struct EntityEnding {
  std::string name;
  Ending ending = Ending::there;
  double way = 0;  ///< [m] walked
  bool flips = false;
};

struct DoctorRun {
  std::string label;                   ///< "0.5 ms"
  std::string refused;                 ///< why there is no such scene; then it has no entities
  std::vector<EntityEnding> entities;  ///< in the order of the scene
};

struct DoctorDimension {
  std::string name;             ///< "steps"
  std::string skipped;          ///< why there are no runs
  std::vector<DoctorRun> runs;  ///< the first is the scene as it is
};

struct Checkup {
  std::string scene;
  double duration = 0;  ///< [s] simulated in each run
  std::vector<DoctorDimension> dimensions;
  std::vector<std::string> flips;  ///< one line each
  bool stopped = false;            ///< by common.stop; then there is nothing else
};

/// "steps", "levels", "gravity", "seeds", "servos".
[[nodiscard]] const std::vector<std::string>& doctor_dimensions();

/// Throws SetupError: a scene that cannot be built as it is, an unknown dimension.
[[nodiscard]] Checkup examine(const DoctorOptions& options);

/// Text for users: a table for each dimension, then all flips.
[[nodiscard]] std::string to_text(const Checkup& checkup);
/// docs/json.md.
[[nodiscard]] std::string to_json(const Checkup& checkup);

}  // namespace murosimf::studies
