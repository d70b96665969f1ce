#include "murosimf/web/watched_numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/logging/log_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/world/object_access.h"

namespace murosimf::web {
namespace {

std::string path_of(const logging::LoggedNumber& number) { return fmt::format("{}", fmt::join(number.path, ".")); }

}  // namespace

logging::LoggedNumber find_number(const World& world, const std::string& path) {
  std::vector<logging::LoggedNumber> found = logging::find_logged(world, {path});
  if (found.size() == 1) return found.front();
  throw SetupError(fmt::format("'{}' means {} numbers, from '{}' to '{}'; one is shown at a time", path, found.size(),
                               path_of(found.front()), path_of(found.back())));
}

std::optional<double> value_of(const logging::LoggedNumber& number) {
  if (!number.entity->present()) return std::nullopt;
  if (!number.sensor.empty()) {
    const sensors::Reading* reading = sensors::find_reading(*number.entity, number.sensor);
    if (!reading || reading->samples == 0) return std::nullopt;
    MUROSIMF_ASSERT(number.index < reading->values.size());
    return reading->values[number.index];
  }
  if (!number.entity->find(number.property)) return std::nullopt;  // its level was changed
  return ObjectAccess(*number.entity, number.object).get(number.property).numbers[number.index];
}

std::vector<std::pair<std::string, std::optional<double>>> WatchedNumbers::read(const World& world,
                                                                                const std::vector<std::string>& paths) {
  if (paths != paths_) {
    paths_ = paths;
    numbers_.assign(paths.size(), std::nullopt);
  }
  MUROSIMF_ASSERT(numbers_.size() == paths.size());
  std::vector<std::pair<std::string, std::optional<double>>> values;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    try {
      if (!numbers_[i]) numbers_[i] = find_number(world, paths[i]);
      values.emplace_back(paths[i], value_of(*numbers_[i]));
    } catch (const SetupError&) {
      values.emplace_back(paths[i], std::nullopt);
    }
  }
  return values;
}

std::vector<std::string> paths_of(World& world, const std::string& entity) {
  Entity& which = world.entity(entity);
  std::vector<std::string> paths;
  for (const auto& number : logging::numbers_of_sensors(which)) paths.push_back(path_of(number));
  for (const auto& number : logging::numbers_of_properties(which)) paths.push_back(path_of(number));
  return paths;
}

}  // namespace murosimf::web
