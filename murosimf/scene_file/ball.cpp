#include "murosimf/scene_file/ball.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/air/air_properties.h"
#include "murosimf/model/properties.h"

namespace murosimf::scene_file {

/// Checked here, since options also come from programs, not only from files.
ModelPtr ball_model(const BallOptions& options) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(options.radius) || !positive(options.mass)) {
    throw SetupError(
        fmt::format("a ball of radius {} m and mass {} kg: both must be positive", options.radius, options.mass));
  }
  const double inertia = (options.hollow ? 2.0 / 3.0 : 2.0 / 5.0) * options.mass * options.radius * options.radius;
  PlacedShape sphere;
  sphere.shape = Sphere{options.radius};
  sphere.surface.material = options.material;
  return std::make_shared<const Model>("ball", Chain{}
                                                   .base("ball")
                                                   .with(properties::mass, options.mass)
                                                   .with(properties::inertia, diagonal(inertia))
                                                   .with(properties::shapes, Shapes{sphere})
                                                   .with(properties::drag_coefficient, options.drag)
                                                   .with(properties::lift_coefficient, options.lift));
}

}  // namespace murosimf::scene_file
