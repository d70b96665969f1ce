/// detector.h - sensor: sees the ball and other robots as vision software would report them, without any picture.
///
/// One output for each entity that is looked at, named after it, with the labels distance [m], azimuth [rad, positive
/// to the left] and elevation [rad, positive upwards] of the origin of its base, in axes of the sensor: x forward, y
/// left, z up. All three are NaN if it is not seen. With d, a, e the true values of p + o, where p is the true place in
/// axes of the sensor and o a constant offset, and n_j, m_j, k_j standard normal numbers of each entity's own:
///
///     distance = d (1 + distance_noise n_j),   azimuth = a + azimuth_noise m_j,   elevation = e + elevation_noise k_j
///
/// Each component of o is drawn once, evenly from -offset to offset. Errors of the outputs' signals come on top.
/// An entity is seen if its base's origin is in the field of view, |a| <= fov_azimuth / 2 and |e| <=
/// fov_elevation / 2, and in the range; if of the points by which it is looked at (sight.h) one is free, and at
/// least the part visible_share; and if it is not missed, which happens with the probability `misses`. Everything that
/// collides hides what is behind it, but for the robot that carries the sensor.
/// Source: vision perceptor of the RoboCup 3D simulation league (SimSpark wiki, Perceptors): field of view, polar
/// values, error proportional to the distance, constant offset. There, nothing hides anything.
///
/// SimSpark's errors: distance_noise 0.000965, azimuth_noise 0.002583 (0.1480 deg), elevation_noise 0.002138 (0.1225
/// deg), offset 0.005.
#pragma once

#include "murosimf/math/random.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/range.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/sensor_options.h"
#include "murosimf/sensors/sight.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::sensors {

struct DetectorOptions {
  double fov_azimuth = 2 * pi / 3, fov_elevation = 2 * pi / 3;  ///< [rad] from side to side
  Range range{.min = 0.1};
  double visible_share = 0.25;                    ///< [1] of a body's points that must be free
  double misses = 0;                              ///< [1] probability
  double distance_noise = 0;                      ///< [1] of the distance
  double azimuth_noise = 0, elevation_noise = 0;  ///< [rad]
  double offset = 0;                              ///< [m] largest, of each component
};

[[nodiscard]] const OptionTable<DetectorOptions>& detector_options();

class Detector final : public Sensor {
 public:
  /// Looks at spec.objects, or at all other moving entities. Throws SetupError that names the number that is impossible, or the
  /// entity that there is none of.
  Detector(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

  void entity_added(Setup& setup) override { view_.add(setup); }
  void entity_taken_back(const Entity& entity) noexcept override { view_.take_back(entity); }
  void model_exchanged(const Entity& entity) override;

 private:
  struct Target {
    Seen seen;
    RandomStream errors, misses;
  };
  /// In axes of the sensor.
  struct Polar {
    double distance, azimuth, elevation;  // [m], [rad], [rad]
  };

  [[nodiscard]] static Polar polar(const Vec3d& place) noexcept;
  [[nodiscard]] bool sees(const Target& target, const Polar& place, collision::QueryScene& scene) const noexcept;
  [[nodiscard]] Polar with_errors(const Target& target, Polar place) const noexcept;
  void measure(std::span<double> values) noexcept override;
  void start() noexcept override { looks_ = 0; }
  void memory(StateArchive& archive) override { archive(looks_); }
  void draw_anew(std::uint64_t seed) override;
  void draw_offset() noexcept;

  const Entity& robot_;
  Mounting mounting_;
  DetectorOptions options_;
  std::vector<Target> targets_;
  RandomStream offsets_;
  Vec3d offset_;  // [m] axes of the sensor
  WorldView view_;
  std::uint64_t looks_ = 0;
};

}  // namespace murosimf::sensors
