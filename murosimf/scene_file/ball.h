/// ball.h - the model of a ball: one object, one sphere.
#pragma once

#include <string>

#include "murosimf/model/model.h"

namespace murosimf::scene_file {

struct BallOptions {
  double radius = 0.05;           ///< [m]
  double mass = 0.1;              ///< [kg]
  bool hollow = false;            ///< inertia 2/3 m r^2 instead of 2/5 m r^2
  std::string material = "ball";  ///< surface, for the pair table
};

/// Throws SetupError if radius or mass are not positive.
[[nodiscard]] ModelPtr ball_model(const BallOptions& options = {});

}  // namespace murosimf::scene_file
