/// motion_recorder.h - algorithm: records the motion of one entity, for comparisons of runs.
///
/// It reads columns that every level has and changes nothing. Samples are taken a hundred times a second, the first one at the
/// start. Torso means the base. With u = R^T e_z, the vertical in base axes:
///     pitch = atan2(-u_x, u_z)      roll = asin(u_y)          order yaw, roll, pitch: not singular at a pitch of 90 degrees
/// Clearance of a sole: height of its lowest corner above the plane z = 0. Slip: horizontal motion of the soles' contact points that
/// the preceding sample has as well, averaged by load, summed over both soles; zero at levels without contact.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

struct MotionSample {
  double time = 0;                    ///< [s]
  Vec3d base, center;                 ///< [m] world: origin of the base, common center of mass
  double pitch = 0, roll = 0;         ///< [rad] of the torso
  Vec3d rate;                         ///< [rad/s] of the torso, base axes
  std::array<double, 2> clearance{};  ///< [m] of the first two soles
  double slip = 0;                    ///< [m] of the soles since the start
  bool full_duty = false;             ///< some servo has requested its full duty since the preceding sample
};

struct MotionRecord {
  std::vector<MotionSample> samples;
  std::size_t soles = 0;            ///< number of valid clearances: at most two
  std::vector<std::string> joints;  ///< names; empty if the level computes no torques
  std::vector<double> torques;      ///< [N m | N] joints.size() numbers per sample: means since the preceding sample
  double full_duty = 0;             ///< [1] share of time in which some servo requested its full duty
};

struct MotionRecorderOptions {
  bool servos = false;    ///< servos move the joints: watch whether they request full duty
  double longest = 60.0;  ///< [s] for which memory is reserved
  double start = 0;       ///< [s] when it begins
};

/// Number of steps between two samples of a recorder that is executed with this period.
[[nodiscard]] std::int64_t steps_per_sample(Duration period);

class MotionRecorder final : public Algorithm {
 public:
  explicit MotionRecorder(Setup& setup, const MotionRecorderOptions& options = {});

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;

  [[nodiscard]] const MotionRecord& record() const { return record_; }

  static constexpr double samples_per_second = 100;

 private:
  struct Servoed {
    int object = 0;
    double full_at = 0;  // [rad] between target and position
    double limit = 0;    // [N m]; 0: none
  };
  struct Grip {
    std::uint64_t feature = 0;
    Vec3d point;
    double load = 0;
  };

  void find_servos(const Model& model);
  void take_sample(Duration now) noexcept;
  void take_torques() noexcept;
  void watch_servos() noexcept;
  [[nodiscard]] double clearance(const Foot& foot) const noexcept;
  [[nodiscard]] double slip(std::size_t foot) noexcept;

  const Model& model_;
  MotionRecord record_;
  std::vector<Foot> feet_;  // the first two
  std::vector<Servoed> servos_;
  std::array<std::vector<Grip>, 2> grips_, new_grips_;
  std::vector<double> torque_sum_;  // [N m | N] by joint since the last sample
  std::int64_t stride_;             // steps per sample
  Duration start_;
  std::int64_t steps_ = 0, full_steps_ = 0;
  double slip_ = 0;
  bool full_ = false;  // since the last sample
  std::span<const Vec3d> r_, v_, w_;
  std::span<const Mat3d> R_;
  std::span<const double> q_, target_, torque_;  // empty where the level has none
  const collision::ContactSet* contacts_ = nullptr;
};

}  // namespace murosimf::dynamics
