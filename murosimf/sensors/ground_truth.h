/// ground_truth.h - sensor: where everybody really is (paper 6.3), for behavior tests without perception.
///
/// No sensing at all: true poses and velocities of all robots and the ball, at the sensor's rate.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/model/algorithm.h"
#include "murosimf/model/setup.h"

namespace murosimf::sensors {

/// One entity as ground truth shows it.
struct Sighting {
  std::string name;
  std::string team;    ///< empty for things that play in no team
  bool self = false;   ///< the robot that carries the sensor
  Vec3d position;      ///< [m] of the base, world frame
  double heading = 0;  ///< [rad] of the base about the vertical, world frame
  Vec3d velocity;      ///< [m/s] of the base, world frame
};

struct GroundTruthData {
  Duration time{};  ///< of the sample
  std::vector<Sighting> sightings;
};

void append_hash(Hasher& hasher, const GroundTruthData& data);

inline constexpr Property<GroundTruthData> ground_truth{
    {"ground_truth", "m, rad, m/s", "world", "true poses and velocities of all entities", Scope::base}};

class GroundTruth final : public Algorithm {
 public:
  /// `setup`: the robot that carries the sensor; `entities`: whom it sees, itself among them.
  GroundTruth(Setup& setup, const std::vector<Entity*>& entities);

  void initialize() override;
  void step(const Instant& instant) noexcept override;

 private:
  struct Source {
    std::span<const Vec3d> r, v;
    std::span<const Mat3d> R;
  };

  const Entity& self_;
  std::vector<const Entity*> entities_;
  std::vector<Source> sources_;
  GroundTruthData& data_;
};

}  // namespace murosimf::sensors
