#include "murosimf/components/sensor_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::components {

void fail(std::string_view where, std::string_view message) { throw SetupError(fmt::format("{}: {}", where, message)); }

double number_of(const std::string& key, const SensorValue& value) {
  const double* number = std::get_if<double>(&value.is);
  if (!number || std::isnan(*number)) fail(value.where, fmt::format("'{}' must be a number", key));
  return *number;
}

double finite_number(const std::string& key, const SensorValue& value) {
  const double number = number_of(key, value);
  if (!std::isfinite(number)) fail(value.where, fmt::format("'{}' must be a finite number", key));
  return number;
}

bool flag_of(const std::string& key, const SensorValue& value) {
  const bool* truth = std::get_if<bool>(&value.is);
  if (!truth) fail(value.where, fmt::format("'{}' must be true or false", key));
  return *truth;
}

Vec3d vector_of(const std::string& key, const SensorValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value.is);
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, finite)) {
    fail(value.where, fmt::format("'{}' must be three finite numbers in brackets", key));
  }
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::string name_of(const std::string& key, const SensorValue& value) {
  const auto* text = std::get_if<std::string>(&value.is);
  if (!text || text->empty()) fail(value.where, fmt::format("'{}' must be a name in quotes", key));
  return *text;
}

std::vector<std::string> names_of(const std::string& key, const SensorValue& value) {
  if (std::holds_alternative<std::string>(value.is)) return {name_of(key, value)};
  const auto* names = std::get_if<std::vector<std::string>>(&value.is);
  if (!names) fail(value.where, fmt::format("'{}' must be a list of names, like [\"a\", \"b\"]", key));
  if (names->empty()) fail(value.where, fmt::format("'{}' names nothing; leave it out for all there are", key));
  for (auto name = names->begin(); name != names->end(); ++name) {
    if (std::find(names->begin(), name, *name) != name) {
      fail(value.where, fmt::format("'{}' stands twice in '{}'", *name, key));
    }
  }
  return *names;
}

}  // namespace murosimf::components
