/// motion_space.h - a key-frame motion as numbers that a search may change.
///
/// The numbers are the duration of every frame and the values of all but the last one; the start and the last frame stay, since other
/// motions continue from there. Bounds are those of the joints (their range, and that of their servo's targets; without any 0.4 rad beyond what
/// the motion has), for feet half a leg's length around the stance and 0.6 rad. Whatever the numbers are, the motion keeps to its servos: where a target of a joint would run faster than the
/// servo's no-load rate, or the joint's own largest rate, the frame takes as much longer.
#pragma once

#include <vector>

#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/locomotion/keyframe_targets.h"
#include "murosimf/model/model.h"
#include "murosimf/studies/cma_es.h"

namespace murosimf::studies {

class MotionSpace {
 public:
  /// `model` lives as long; `fastest` [rad/s]: of hinges for which the model has no largest rate, 0: any. Throws SetupError as
  /// KeyframeTargets, and for a column whose joints have no position in common.
  MotionSpace(const Model& model, const locomotion::KeyframeMotion& motion, double fastest = 0);

  /// Start (the motion itself, moved within the bounds), bounds and sigma.
  [[nodiscard]] CmaEsOptions space() const;
  [[nodiscard]] locomotion::KeyframeMotion motion_at(const std::vector<double>& point) const;

  /// [1] The largest rate of a target over that of its joint, in each frame; 0: no joint has one.
  [[nodiscard]] std::vector<double> rate_shares(const locomotion::KeyframeMotion& motion) const;
  /// [rad/s] The largest rate of a target of a hinge.
  [[nodiscard]] double largest_rate(const locomotion::KeyframeMotion& motion) const;

 private:
  struct Number {
    std::size_t frame = 0;
    int column = 0;    // -1: the duration
    double scale = 1;  // of the unit in which the search counts
    double low = 0, high = 0;
  };
  struct Bounds {
    double scale = 1, low = 0, high = 0;
  };
  [[nodiscard]] Bounds bounds_of(std::size_t column) const;
  /// [rad/s | m/s] of every joint's target, the largest in the frame.
  [[nodiscard]] std::vector<double> rates(const locomotion::KeyframeMotion& motion, std::size_t frame) const;

  const Model& model_;
  locomotion::KeyframeMotion motion_;
  locomotion::KeyframeTargets targets_;
  std::vector<double> fastest_;  // [rad/s | m/s] by joint of the model; 0: not known
  std::vector<Number> numbers_;
};

}  // namespace murosimf::studies
