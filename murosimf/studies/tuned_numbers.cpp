#include "murosimf/studies/tuned_numbers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/math/assert.h"

namespace murosimf::studies {
namespace {

/// [1] Of these numbers a smaller share to either side is another robot or another gait.
const std::map<std::string, double> narrow{{"stride_gain", 0.2}, {"omega", 0.3}, {"slowest", 0.3}, {"quickest", 0.45}};

TunedNumber bounds_around(const OptionInfo& option, double value) {
  const auto found = narrow.find(option.name);
  const double least = 1e-3;  // of a number that is 0
  const double width = std::max((found == narrow.end() ? 1 : found->second) * std::abs(value), least);
  return {option.name, value, std::max(option.lowest.value, value - width), std::min(option.highest, value + width)};
}

}  // namespace

double number_in(const OptionValues& values, const std::string& name) { return std::get<double>(values.at(name)); }

/// Bounds scale with the robot: lengths with its leg, the others with its own value.
std::vector<TunedNumber> walk_numbers(const Model& model, const OptionValues& seed) {
  const auto& leg = locomotion::legs_of(model)[0];
  const double length = leg.thigh + leg.shin;
  std::vector<TunedNumber> all;
  const auto times = [&](const char* name, double low, double high) {
    const double value = number_in(seed, name);
    all.push_back({name, value, low * value, high * value});
  };
  const auto about = [&](const char* name, double down, double up) {
    const double value = number_in(seed, name);
    all.push_back({name, value, value - down, value + up});
  };
  const auto within = [&](const char* name, double low, double high) {
    all.push_back({name, std::clamp(number_in(seed, name), low, high), low, high});
  };
  times("period", 0.6, 1.8);
  times("lift", 0.4, 2.5);
  within("lean", -0.25, 0.25);
  within("hip_roll", 0, 0.15);
  within("sway", 0, 0.3 * length);
  within("lead", -0.8, 0.8);
  about("setback", 0.12 * length, 0.12 * length);
  about("hip_height", 0.12 * length, 0.04 * length);
  times("half_width", 0.7, 1.5);
  within("double_support", 0, 0.3);
  return all;
}

std::vector<TunedNumber> feedback_numbers(const Model& model) {
  const OptionValues values = locomotion::feedback_values(locomotion::gait_feedback(model, {}));
  std::vector<TunedNumber> all;
  for (const OptionInfo& option : locomotion::feedback_options())
    all.push_back(bounds_around(option, number_in(values, option.name)));
  return all;
}

double place_of(const TunedNumber& number, double value) {
  MUROSIMF_ASSERT(number.low < number.high);
  return std::clamp((value - number.low) / (number.high - number.low), 0.0, 1.0);
}

OptionValues values_at(const std::vector<TunedNumber>& numbers, const std::vector<double>& point) {
  MUROSIMF_ASSERT(point.size() == numbers.size());
  OptionValues values;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double value = numbers[i].low + point[i] * (numbers[i].high - numbers[i].low);
    // As a file has it, so that the file gives the walk that was tried.
    values[numbers[i].name] = std::round(value * 1e5) * 1e-5;
  }
  return values;
}

CmaEsOptions space_of(const std::vector<TunedNumber>& numbers, double sigma) {
  CmaEsOptions space{.start = {}, .sigma = sigma};
  for (const TunedNumber& one : numbers) space.start.push_back(place_of(one, one.value));
  space.low.assign(numbers.size(), 0);
  space.high.assign(numbers.size(), 1);
  return space;
}

}  // namespace murosimf::studies
