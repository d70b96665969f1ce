/// tuning_cases.h - the circumstances under which a motion is tried: levels, friction, errors of the model, how the robot begins.
///
/// The same for every level, so that levels can be compared, and for every candidate, so that its cost is a function. Frictions are
/// spread evenly; masses with their inertias and gains of servos are 10 % off in each combination in turn; leans (up to 2 degrees about any horizontal
/// axis), headings (5 degrees to either side), zeros of joints (0.03 rad, of feet 3 mm) and shifts of a ball (10 mm in x and y) come from the seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene/assets.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::studies {

struct TuningCase {
  std::string level;
  double friction = 1;         ///< [1] between the ground and everything
  double mass = 1, gain = 1;   ///< [1] of what the model says
  double roll = 0, pitch = 0;  ///< [rad] added to those of the start
  double heading = 0;          ///< [rad]
  Vec3d ball;                  ///< [m] added to its place
  std::uint64_t zeros = 0;     ///< seed of zero_error()
};

/// `each` cases of every level, level by level. Cases of other streams of the same seed are other ones. Throws SetupError for an unknown
/// level, one that is named twice, or none.
[[nodiscard]] std::vector<TuningCase> tuning_cases(const std::vector<std::string>& levels, std::size_t each,
                                                   std::uint64_t seed, std::string_view stream);

/// [1] By how much of 0.03 rad or 3 mm what a motion's column sets is off, -1 to 1: encoders that are not quite where they should be.
[[nodiscard]] double zero_error(const TuningCase& one, std::size_t column);

/// (mean over levels + worst level) / 2, of a level the mean over its cases: what is good at one level only is not good.
[[nodiscard]] double mean_and_worst(const std::vector<double>& costs, std::size_t levels);

/// One robot with its errors, and what scenes share of it. Any number of threads may call it at once.
class VariedRobot {
 public:
  /// `model` as in scenes. Throws SetupError: no such file, an error in it.
  VariedRobot(const std::string& model, bool lenient);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const Model& model() const { return *model_; }
  /// Assets in which the file names the robot with these errors.
  [[nodiscard]] std::shared_ptr<scene::Assets> assets(double mass, double gain) const;
  [[nodiscard]] std::shared_ptr<const scene::RobotKind> kind(double mass, double gain) const;
  /// Assets in which the file names this robot.
  [[nodiscard]] std::shared_ptr<scene::Assets> assets_of(scene::RobotKind kind) const;

 private:
  std::filesystem::path file_;
  bool lenient_;
  ModelPtr model_;
  std::map<std::pair<double, double>, std::shared_ptr<scene::Assets>> assets_;
};

/// Some of these robots, 3 m apart in a row, without sensors, on the carpet of the case: "r0", "r1", ...
[[nodiscard]] scene_file::SceneSpec row_of_robots(const VariedRobot& robot, const TuningCase& one, std::size_t count);

/// [1] One of the numbers that come from the case's seed besides, -1 to 1: which of them, `number` says.
[[nodiscard]] double case_number(const TuningCase& one, std::size_t number);

/// How many robots stand in a row: as many as step together in lanes.
inline constexpr std::size_t robots_in_a_row = 8;

}  // namespace murosimf::studies
