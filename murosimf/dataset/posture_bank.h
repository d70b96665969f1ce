/// posture_bank.h - postures that robots take in pictures: recorded while the scene runs with its own controllers, and while robots get up.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::dataset {

/// How a robot stands or lies on the ground, without place and heading.
struct Posture {
  double height = 0;           ///< [m] of the base
  double reach = 0;            ///< [m] radius about its base that it takes on the ground (ground_reach.h)
  Mat3d attitude;              ///< base axes to level axes whose x points where the base's x points from above
  std::vector<double> joints;  ///< [rad | m] by object of the model
};

enum class Doing { standing, moving, down };

/// Of one kind of robot, by what it does; one of them may have none.
using Postures = std::array<std::vector<Posture>, 3>;

class PostureBank {
 public:
  /// Runs the scene for `seconds`, and for every kind of robot its motions get_up_back and get_up_front, if it has them. `spec`: of the
  /// scene as it is; `options`: of building it. Throws SetupError.
  PostureBank(const scene_file::SceneSpec& spec, const scene::SceneOptions& options, double seconds);

  [[nodiscard]] const Postures& of(const scene_file::RobotSpec& robot) const;
  /// Of all postures, bit for bit: it tells another motion, controller or model.
  [[nodiscard]] std::uint64_t hash() const;

 private:
  void record(scene::Scene& scene, double seconds, bool only_down);
  void record_get_up(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot,
                     const scene::SceneOptions& options);

  std::map<std::string, Postures> kinds_;
};

}  // namespace murosimf::dataset
