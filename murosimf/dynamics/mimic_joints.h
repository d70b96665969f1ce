/// mimic_joints.h - joints that others take along: one other (joint_coupling), position = offset + ratio * leader's; several
/// (joint_tendon), position = sum of coefficient * position; what a string runs through (spatial_tendon), position = its length.
///
/// A joint that follows a follower counts as one that follows the first leader. A leader's range is narrowed by those of its
/// followers, so that no follower has to leave its own; and so is its largest rate (rate_limit.h).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/multibody/loop_joints.h"
#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/multibody/tendon_tie.h"

namespace murosimf::dynamics {

class MimicJoints {
 public:
  struct Pair {
    int follower = 0, leader = 0;  ///< objects; a leader follows no joint
    double ratio = 1;              ///< [1 | rad/m | m/rad]
    double offset = 0;             ///< [rad | m]
  };
  /// A joint that stands at the length of a tendon.
  struct Tendon {
    int follower = 0;         ///< object
    std::vector<int> joints;  ///< objects that it runs over
    std::optional<multibody::TendonPath> path{};
    /// [m/rad | 1] Slope of its length by each of `joints`; of a path at the positions of the last length().
    mutable std::vector<double> slopes{};

    /// [m | rad] Its length at the positions q, by object.
    [[nodiscard]] double length(std::span<const double> q) const noexcept;
    /// [m/s | rad/s] The rate of its length where length() has been asked, for the rates qd, by object.
    [[nodiscard]] double rate(std::span<const double> qd) const noexcept;
  };
  /// Two tendons, or one, held together: position of the follower = start + polynomial(position of the leader - leader_start).
  struct Tie {
    int follower = 0, leader = -1;  ///< objects; -1: none
    TendonTie by;
  };
  struct Range {
    double lowest, highest;  ///< [rad | m]
  };

  /// Throws SetupError if a leader or a joint of a tendon does not exist or is no joint, joints follow each other in a circle, a number is
  /// no sensible one, one of two joints turns by a rate (velocity_joints.h), or the ranges have nothing in common.
  explicit MimicJoints(const Model& model);

  /// In the order of the followers in the model.
  [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
  [[nodiscard]] std::span<const Tendon> tendons() const { return tendons_; }
  /// They hold where forces move the joints (coupling_forces.h).
  [[nodiscard]] std::span<const Tie> ties() const { return ties_; }
  [[nodiscard]] bool empty() const { return pairs_.empty() && tendons_.empty(); }
  /// Where a joint (an object of the model) can stand; without a range, anywhere.
  [[nodiscard]] const Range& range(int joint) const { return ranges_[static_cast<std::size_t>(joint)]; }
  /// [rad/s | m/s] The largest rate of a joint; infinite: none.
  [[nodiscard]] double rate_limit(int joint) const { return rate_limits_[static_cast<std::size_t>(joint)]; }
  /// Followers go where their leaders are, tendons where their joints are then; by object.
  void follow(std::span<double> q, std::span<double> qd) const noexcept;

 private:
  [[nodiscard]] Pair pair(const Model& model, int follower) const;
  [[nodiscard]] Tendon tendon(const Model& model, int follower) const;
  [[nodiscard]] Tendon spatial_tendon(const Model& model, int follower) const;
  [[nodiscard]] Tie tie(const Model& model, int follower) const;
  void narrow(const Model& model);

  std::vector<Pair> pairs_;
  std::vector<Tendon> tendons_;
  std::vector<Tie> ties_;
  std::vector<Range> ranges_;        // by object
  std::vector<double> rate_limits_;  // [rad/s | m/s] by object
};

/// Passive joints of the model's loops: those with neither servo nor coupling; in a loop with a joint that is commanded
/// (loop_commanded) all others. `joint_start` is the posture with closed loops. Throws SetupError where a commanded joint is in no loop.
[[nodiscard]] multibody::LoopJoints joints_of_loops(const Model& model);

}  // namespace murosimf::dynamics
