#include "murosimf/studies/motion_space.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/dynamics/rate_limit.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::studies {
namespace {

using locomotion::Channel;
using locomotion::KeyframeMotion;

// Units of the search: with a sigma of 0.1 values move by 0.1 rad (feet 1 cm) and durations by 0.05 s at first.
constexpr double first_sigma = 0.1;
constexpr double radian = 1, second = 0.5, foot_meter = 0.1;
constexpr double shortest = 0.05, longest = 3;  // [s]
constexpr double foot_share = 0.5;              // [1] of the leg's length
constexpr double foot_pitch = 0.6;              // [rad]
constexpr double beyond = 0.4;                  // [rad]
constexpr int samples_of_a_frame = 48;          // along the cosine, whose steepest part they miss by 0.02 %
constexpr double within_rate = 0.999;           // [1] of the no-load rate, which files that round numbers keep

bool is_foot(const Channel& channel) { return channel.name.find("_foot.") != std::string::npos; }

/// [rad/s | m/s] 0: the model knows none.
double largest_rate_of(const Model& model, int joint) {
  const double rate = dynamics::fastest_rate(model, joint);
  return std::isfinite(rate) ? rate : 0;
}

}  // namespace

MotionSpace::MotionSpace(const Model& model, const KeyframeMotion& motion, double fastest)
    : model_(model), motion_(motion), targets_(model, motion) {
  for (const int joint : model.joints()) {
    const double rate = largest_rate_of(model, joint);
    const bool hinge = model.objects()[static_cast<std::size_t>(joint)].kind == Kind::revolute;
    fastest_.push_back(rate > 0 || !hinge ? rate : fastest);
  }
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    numbers_.push_back({frame, -1, second, shortest, longest});
    if (frame + 1 == motion.frames.size()) break;
    for (std::size_t column = 0; column < motion.columns.size(); ++column) {
      const Bounds bounds = bounds_of(column);
      numbers_.push_back({frame, static_cast<int>(column), bounds.scale, bounds.low, bounds.high});
    }
  }
}

MotionSpace::Bounds MotionSpace::bounds_of(std::size_t column) const {
  MUROSIMF_ASSERT(column < motion_.columns.size() && !motion_.columns[column].empty());
  const Channel& first = motion_.columns[column][0];
  if (is_foot(first)) {
    if (first.name.ends_with(".pitch")) return {radian, -foot_pitch, foot_pitch};
    const locomotion::Leg& leg = locomotion::legs_of(model_)[0];
    const double reach = foot_share * (leg.thigh + leg.shin);
    return {foot_meter, -reach, reach};
  }
  Bounds bounds{radian, -pi, pi};
  bool has_range = false;
  for (const auto& sink : targets_.joints()) {
    if (sink.column != column) continue;
    for (const auto* property : {&properties::joint_range, &properties::joint_target_range}) {
      const Vec3d* range = model_.find(*property, sink.object);
      if (!range) continue;
      has_range = true;
      // A column that moves a joint against its sign has the mirrored range.
      bounds.low = std::max(bounds.low, sink.sign > 0 ? range->x : -range->y);
      bounds.high = std::min(bounds.high, sink.sign > 0 ? range->y : -range->x);
    }
  }
  if (!has_range) {
    double low = motion_.start[column], high = low;
    for (const locomotion::KeyFrame& frame : motion_.frames) {
      low = std::min(low, frame.values[column]);
      high = std::max(high, frame.values[column]);
    }
    return {radian, low - beyond, high + beyond};
  }
  if (bounds.low < bounds.high) return bounds;
  throw SetupError(fmt::format("motion '{}', column '{}': the ranges of its joints leave nothing to search",
                               motion_.name, first.name));
}

/// Numbers in units of about equal effect: one sigma fits all of them.
CmaEsOptions MotionSpace::space() const {
  CmaEsOptions space{.start = {}, .sigma = first_sigma};
  for (const Number& number : numbers_) {
    const locomotion::KeyFrame& frame = motion_.frames[number.frame];
    const double value = number.column < 0 ? frame.duration : frame.values[static_cast<std::size_t>(number.column)];
    space.start.push_back(std::clamp(value, number.low, number.high) / number.scale);
    space.low.push_back(number.low / number.scale);
    space.high.push_back(number.high / number.scale);
  }
  return space;
}

/// Frames that would demand too high rates are stretched, so that every point is a possible motion.
KeyframeMotion MotionSpace::motion_at(const std::vector<double>& point) const {
  MUROSIMF_ASSERT(point.size() == numbers_.size());
  KeyframeMotion motion = motion_;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const Number& number = numbers_[i];
    locomotion::KeyFrame& frame = motion.frames[number.frame];
    double& value = number.column < 0 ? frame.duration : frame.values[static_cast<std::size_t>(number.column)];
    value = std::clamp(point[i] * number.scale, number.low, number.high);
  }
  const std::vector<double> shares = rate_shares(motion);
  MUROSIMF_ASSERT(shares.size() == motion.frames.size());
  for (std::size_t i = 0; i < motion.frames.size(); ++i)
    motion.frames[i].duration *= std::max(1.0, shares[i] / within_rate);
  return motion;
}

std::vector<double> MotionSpace::rates(const KeyframeMotion& motion, std::size_t index) const {
  MUROSIMF_ASSERT(index < motion.frames.size());
  const locomotion::KeyFrame& frame = motion.frames[index];
  const std::vector<double>& from = index == 0 ? motion.start : motion.frames[index - 1].values;
  std::vector<double> values(from), before(static_cast<std::size_t>(model_.size())), now(before);
  std::vector<double> largest(model_.joints().size());
  targets_.write(values, before);
  // The player moves along a half cosine from frame to frame.
  for (int k = 1; k <= samples_of_a_frame; ++k) {
    const double share = 0.5 * (1 - std::cos(pi * k / samples_of_a_frame));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = from[i] + share * (frame.values[i] - from[i]);
    targets_.write(values, now);
    for (std::size_t j = 0; j < largest.size(); ++j) {
      const auto object = static_cast<std::size_t>(model_.joints()[j]);
      largest[j] = std::max(largest[j], std::abs(now[object] - before[object]) * samples_of_a_frame / frame.duration);
    }
    before.swap(now);
  }
  return largest;
}

std::vector<double> MotionSpace::rate_shares(const KeyframeMotion& motion) const {
  std::vector<double> shares;
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    const std::vector<double> all = rates(motion, frame);
    MUROSIMF_ASSERT(all.size() == fastest_.size());
    double share = 0;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (fastest_[j] > 0) share = std::max(share, all[j] / fastest_[j]);
    }
    shares.push_back(share);
  }
  return shares;
}

double MotionSpace::largest_rate(const KeyframeMotion& motion) const {
  double largest = 0;
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    const std::vector<double> all = rates(motion, frame);
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (model_.objects()[static_cast<std::size_t>(model_.joints()[j])].kind == Kind::revolute)
        largest = std::max(largest, all[j]);
    }
  }
  return largest;
}

}  // namespace murosimf::studies
