/// keyframe.h - postures that a robot file names, for the start of a scene (MJCF key).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/model/property.h"

namespace murosimf {

struct Keyframe {
  std::string name;
  std::vector<std::pair<std::string, double>> positions;  ///< [rad | m] by joint
  std::vector<std::pair<std::string, double>> targets;    ///< [rad | m] by joint, where they are not the positions
  Mat3d base;                                             ///< base axes to world axes, heading and all
};
using Keyframes = std::vector<Keyframe>;

namespace properties {

inline constexpr Property<Keyframes> keyframes{
    {"keyframes", "rad | m", "-", "postures that the robot's file names", Scope::base}};

}  // namespace properties

}  // namespace murosimf
