#include "murosimf/locomotion/gait_feedback.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

struct Row {
  std::string_view name;
  double GaitFeedback::*place;
  double power;  ///< of the legs' length, by which a robot's number is that of kid21 scaled
  std::string_view unit, meaning;
  LowestValue lowest;
  double highest;
};

constexpr double length = 1, time = 0.5, speed = 0.5, rate = -0.5, per_length = -1, none = 0;
constexpr double farthest = 10;  // [m]

const std::array rows{
    Row{"stride_gain", &GaitFeedback::stride_gain, none, "1", "of the strides", 0.1, 3},
    Row{"lean_per_speed", &GaitFeedback::lean_per_speed, rate, "rad s/m", "of the pelvis, forward", -5, 5},
    Row{"setback_per_speed", &GaitFeedback::setback_per_speed, time, "s", "of the feet behind the hips", -2, 2},
    Row{"sag", &GaitFeedback::sag, none, "1", "of the lag of the standing hip's roll, added to its target", 0, 2},
    Row{"foot_level", &GaitFeedback::foot_level, none, "1", "of a tilt that the swinging foot undoes", 0, 2},
    Row{"ankle_pitch", &GaitFeedback::ankle_pitch, none, "1", "of a deviation of the pitch, at the standing ankle", -5,
        5},
    Row{"ankle_pitch_rate", &GaitFeedback::ankle_pitch_rate, time, "s", "of its rate", -5, 5},
    Row{"ankle_roll", &GaitFeedback::ankle_roll, none, "1", "of a deviation of the roll, at the standing ankle", -5, 5},
    Row{"ankle_roll_rate", &GaitFeedback::ankle_roll_rate, time, "s", "of its rate", -5, 5},
    Row{"ankle_forward", &GaitFeedback::ankle_forward, per_length, "rad/m", "of a deviation forward, at the ankle", -50,
        50},
    Row{"ankle_sideways", &GaitFeedback::ankle_sideways, per_length, "rad/m", "of one outward", -50, 50},
    Row{"step_forward", &GaitFeedback::step_forward, none, "1", "of a deviation at the end of the step, by the foot", 0,
        5},
    Row{"step_sideways", &GaitFeedback::step_sideways, none, "1", "the same outward", 0, 5},
    Row{"step_decay", &GaitFeedback::step_decay, time, "s", "in which a standing foot goes back", above(0), 10},
    Row{"timing_forward", &GaitFeedback::timing_forward, per_length, "1/m", "quicker steps by a deviation forward",
        -100, 100},
    Row{"timing_sideways", &GaitFeedback::timing_sideways, per_length, "1/m", "slower steps by one outward", -100, 100},
    Row{"hurry_at", &GaitFeedback::hurry_at, length, "m",
        "deviation outward from which on it steps as quickly as it can", above(0), 100},
    Row{"slowest", &GaitFeedback::slowest, none, "1", "of the phase", 0, 1},
    Row{"quickest", &GaitFeedback::quickest, none, "1", "of the phase", 1, 10},
    Row{"dead_zone", &GaitFeedback::dead_zone, length, "m", "of deviations", 0, farthest},
    Row{"rigid_dead_zone", &GaitFeedback::rigid_dead_zone, length, "m",
        "more, while it walks with joints that follow at once", 0, farthest},
    Row{"most_forward", &GaitFeedback::most_forward, length, "m", "that a foot is placed beside its stride", 0,
        farthest},
    Row{"most_sideways", &GaitFeedback::most_sideways, length, "m", "the same outward", 0, farthest},
    Row{"most_inward", &GaitFeedback::most_inward, length, "m", "the same towards the standing foot", 0, farthest},
    Row{"offset_speed", &GaitFeedback::offset_speed, speed, "m/s", "with which a foot leaves its stride", 0, 100},
    Row{"smoothing", &GaitFeedback::smoothing, time, "s", "of the center of mass's rate", 0, 1},
    Row{"omega", &GaitFeedback::omega, rate, "1/s", "of the pendulum that the robot is", above(0), 100},
    Row{"most_deviation", &GaitFeedback::most_deviation, length, "m", "what is larger counts as this", above(0),
        farthest},
    Row{"compliant_lag", &GaitFeedback::compliant_lag, none, "rad",
        "mean lag of the legs' joints of the compliant table", above(0), 1},
    Row{"slope", &GaitFeedback::slope, none, "1", "of the ground's slope that the feet follow", 0, 1},
    Row{"trim", &GaitFeedback::trim, rate, "1/s",
        "how quickly strides correct a velocity that, by odometry, is not the wanted one", 0, 5},
    Row{"still_rate", &GaitFeedback::still_rate, rate, "rad/s", "below which a robot stands still", 0, 10},
    Row{"step_at", &GaitFeedback::step_at, length, "m", "deviation at which a robot that stands steps", 0, farthest},
};

std::vector<OptionInfo> make_infos() {
  std::vector<OptionInfo> infos;
  for (const Row& row : rows)
    infos.push_back({std::string(row.name), std::numeric_limits<double>::quiet_NaN(), std::string(row.unit),
                     std::string(row.meaning), row.lowest, row.highest});
  return infos;
}

}  // namespace

const std::vector<OptionInfo>& feedback_options() {
  MUROSIMF_ASSERT(std::ranges::all_of(rows, [](const Row& row) { return row.place != nullptr && !row.name.empty(); }));
  static const std::vector<OptionInfo> infos = make_infos();
  return infos;
}

OptionValues feedback_values(const GaitFeedback& numbers) {
  OptionValues values;
  for (const Row& row : rows) values[std::string(row.name)] = numbers.*row.place;
  return values;
}

const std::vector<OptionInfo>& balanced_walk_options() {
  static const std::vector<OptionInfo> all = [] {
    std::vector<OptionInfo> options = walk_options();
    options.insert(options.end(), feedback_options().begin(), feedback_options().end());
    return options;
  }();
  return all;
}

namespace {

/// [1] Compliance of the servos relative to those of kid21.
double softness(const Model& model) {
  constexpr double kid21_droop = 0.08535027;  // [rad] hip_droop
  const double droop = hip_droop(model);
  MUROSIMF_ASSERT(droop >= 0);
  return droop > 0 ? droop / kid21_droop : 1;
}

}  // namespace

GaitFeedback gait_feedback(const Model& model, const OptionValues& given) {
  constexpr double kid21_leg = 0.24;  // [m] thigh and shin
  const Leg& leg = legs_of(model)[0];
  const double scale = (leg.thigh + leg.shin) / kid21_leg;
  MUROSIMF_ASSERT(scale > 0);
  // The model's own numbers fill in what is not given: insert() keeps entries that exist.
  OptionValues all = values_among(feedback_options(), given);
  if (const OptionValues* own = model.find(properties::given_balance, 0)) {
    const OptionValues feedback = values_among(feedback_options(), *own);
    all.insert(feedback.begin(), feedback.end());
  }
  check_options("the balance", feedback_options(), all);
  GaitFeedback numbers;
  numbers.compliant_lag *= softness(model);
  for (const Row& row : rows) {
    double& number = numbers.*row.place;
    number *= std::pow(scale, row.power);
    if (const auto value = all.find(row.name); value != all.end()) number = std::get<double>(value->second);
  }
  return numbers;
}

WalkParameters balanced_walk(const Model& model, const OptionValues& given) {
  OptionValues all = values_among(walk_options(), given);
  if (const OptionValues* own = model.find(properties::given_balance, 0)) {
    const OptionValues walk = values_among(walk_options(), *own);
    all.insert(walk.begin(), walk.end());
  }
  return walk_parameters(model, all);
}

}  // namespace murosimf::locomotion
