#include "murosimf/studies/compare_thresholds.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

constexpr std::array all{
    ComparedQuantity{"path_length", "path length", "%", 100, 1, 20, &Deviations::path_length},
    ComparedQuantity{"path", "path", "m", 1, 3, 0.12, &Deviations::path},
    ComparedQuantity{"center_mean", "mean place of the center of mass", "m", 1, 3, 0.10, &Deviations::center_mean},
    ComparedQuantity{"center_max", "center of mass", "m", 1, 3, 0.20, &Deviations::center_max},
    ComparedQuantity{"pitch", "torso pitch", "deg", 180 / pi, 1, 5, &Deviations::pitch},
    ComparedQuantity{"roll", "torso roll", "deg", 180 / pi, 1, 5, &Deviations::roll},
    ComparedQuantity{"rate", "torso angular rate", "rad/s", 1, 2, 0.7, &Deviations::rate},
    ComparedQuantity{"slip", "foot slip", "mm/s", 1000, 1, 20, &Deviations::slip},
    ComparedQuantity{"clearance", "foot clearance", "mm", 1000, 0, 20, &Deviations::clearance},
    ComparedQuantity{"others_way", "way of what is around", "%", 100, 1, 20, nullptr, &Deviations::others_way,
                     Concern::others},
    ComparedQuantity{"others_end", "place of what is around", "%", 100, 1, 20, nullptr, &Deviations::others_end,
                     Concern::others},
    ComparedQuantity{"others_speed", "peak speed of what is around", "%", 100, 1, 20, nullptr,
                     &Deviations::others_speed, Concern::others},
    ComparedQuantity{"accelerometer", "accelerometer", "%", 100, 0, 30, nullptr, &Deviations::accelerometer,
                     Concern::sensors},
    ComparedQuantity{"accelerometer_peak", "peak of the accelerometer", "%", 100, 0, 60, nullptr,
                     &Deviations::accelerometer_peak, Concern::sensors},
    ComparedQuantity{"gyroscope", "gyroscope", "%", 100, 0, 40, nullptr, &Deviations::gyroscope, Concern::sensors},
};

double value_of(const std::string& text, std::size_t begin, const std::string& where) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [parsed, error] = std::from_chars(text.data() + begin, end, value);
  if (error != std::errc{} || parsed != end || !(value >= 0 && std::isfinite(value))) {
    throw SetupError(where + ": the value must be a number from 0");
  }
  return value;
}

}  // namespace

std::span<const ComparedQuantity> quantities() { return all; }

const std::string& ComparedQuantity::owner(const Deviations& deviations) const {
  static const std::string the_robot;
  return of_another ? (deviations.*of_another).name : the_robot;
}

std::string number_of(const ComparedQuantity& quantity, double value) {
  return fmt::format("{:.{}f} {}", value, quantity.decimals, quantity.unit);
}

Thresholds::Thresholds() {
  for (const ComparedQuantity& quantity : all) values.push_back(quantity.threshold);
}

void Thresholds::set(const std::string& text) {
  MUROSIMF_ASSERT(values.size() == all.size());
  const std::string where = fmt::format("--threshold '{}'", text);
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw SetupError(where + ": write NAME=VALUE, for example 'pitch=5'");
  const std::string name = text.substr(0, equals);
  std::vector<std::string_view> names{"fall_time", "contact_duty"};
  double* known = name == "fall_time" ? &fall_time : name == "contact_duty" ? &contact_duty : nullptr;
  for (std::size_t q = 0; q < all.size(); ++q) {
    names.push_back(all[q].name);
    if (all[q].name == name) known = &values[q];
  }
  if (!known) throw SetupError(fmt::format("{}: {}", where, unknown_name("threshold", name, names)));
  *known = value_of(text, equals + 1, where);
}

}  // namespace murosimf::studies
