/// ball.h - the model of a ball: one object, one sphere, in the color of its entity.
#pragma once

#include <string>

#include "murosimf/air/air_options.h"
#include "murosimf/model/model.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::scene_file {

struct BallOptions {
  double radius = 0.05;           ///< [m]
  double mass = 0.1;              ///< [kg]
  bool hollow = false;            ///< inertia 2/3 m r^2 instead of 2/5 m r^2
  std::string material = "ball";  ///< surface, for the pair table
  double drag = air::usual_drag;  ///< [1] C_d (air/air.h)
  double lift = air::usual_lift;  ///< [1] limit of C_l at high spin

  friend bool operator==(const BallOptions&, const BallOptions&) = default;
  void state(StateArchive& archive) { archive(radius, mass, hollow, material, drag, lift); }
};

/// Throws SetupError if radius or mass are not positive.
[[nodiscard]] ModelPtr ball_model(const BallOptions& options = {});

}  // namespace murosimf::scene_file
