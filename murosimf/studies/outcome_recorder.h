/// outcome_recorder.h - algorithm: records all other entities while one robot is examined: their ways and falls, and which of them
/// the robot touches.
///
/// It belongs to the world, reads what every level has and changes nothing. Samples are taken when MotionRecorder takes them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::studies {

struct OtherSample {
  double time = 0;      ///< [s]
  Vec3d place;          ///< [m] of the base, world
  double speed = 0;     ///< [m/s] of the base
  double cos_lean = 1;  ///< [1] cosine of the angle between the base's z axis and the vertical
};

/// One entity besides the robot.
struct OtherRecord {
  std::string name;
  bool can_fall = false;  ///< it has joints
  std::vector<OtherSample> samples;
  std::optional<double> touched, touched_last;  ///< [s] when the robot touched it first and last; nothing: never
};

struct OutcomeRecord {
  std::vector<OtherRecord> others;
  std::vector<bool> touching;  ///< by sample: whether the robot touched any of them since the sample before
};

class OutcomeRecorder final : public Algorithm {
 public:
  /// `longest` [s]: for which memory is set aside.
  OutcomeRecorder(Setup& setup, const Entity& robot, const std::vector<Entity*>& others, double longest);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override { take_sample(0); }
  void step(const Instant& instant) noexcept override;

  [[nodiscard]] const OutcomeRecord& record() const { return record_; }

 private:
  struct Source {
    int number;  // of the entity in the world
    std::span<const Vec3d> r, v;
    std::span<const Mat3d> R;
  };
  void watch_touches(double now) noexcept;
  void touch(int number, double now) noexcept;
  void take_sample(double now) noexcept;

  int robot_;  // number in the world
  const collision::PairSet& pairs_;
  std::vector<Source> sources_;
  OutcomeRecord record_;
  std::int64_t stride_;  // steps per sample
  std::int64_t steps_ = 0;
  bool touching_ = false;
};

}  // namespace murosimf::studies
