#include "murosimf/logging/log_paths.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/logging/log_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/setting_targets.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::logging {
namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

/// A pattern for one entity: the parts after its name.
struct Search {
  Entity* entity = nullptr;
  std::vector<std::string> parts;
};

std::vector<Search> searches(const std::vector<Entity*>& entities, const std::vector<std::string>& parts) {
  std::vector<Search> found;
  for (Entity* entity : entities) {
    MUROSIMF_ASSERT(!parts.empty());
    if (matches(parts[0], entity->name())) found.push_back({entity, {parts.begin() + 1, parts.end()}});
  }
  if (!found.empty() || parts.size() < 2) return found;
  for (Entity* entity : entities) {
    const std::string& team = entity->options().team;
    const bool member = matches(parts[1], entity->name()) || team + parts[1] == entity->name();
    if (!team.empty() && matches(parts[0], team) && member) {
      found.push_back({entity, {parts.begin() + 2, parts.end()}});
    }
  }
  return found;
}

/// A pattern that ends early matches everything below.
bool means(const Search& search, const LoggedNumber& number) {
  MUROSIMF_ASSERT(!number.path.empty());
  const auto path = number.path.begin() + 1;
  return search.parts.size() < number.path.size() &&
         std::equal(search.parts.begin(), search.parts.end(), path, matches);
}

/// The pattern must include the name of the property, else it would denote all properties of an object.
bool names_property(const Search& search, const LoggedNumber& number) {
  const auto property = std::find(number.path.begin() + 2, number.path.end(), number.property);
  return search.parts.size() >= static_cast<std::size_t>(property - number.path.begin());
}

std::vector<LoggedNumber> sensors_meant(const std::vector<Search>& all) {
  std::vector<LoggedNumber> meant;
  for (const Search& search : all) {
    const auto numbers = numbers_of_sensors(*search.entity);
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(meant),
                 [&](const LoggedNumber& number) { return means(search, number); });
  }
  return meant;
}

std::vector<LoggedNumber> properties_meant(const std::vector<Search>& all) {
  std::vector<LoggedNumber> meant;
  for (const Search& search : all) {
    if (search.parts.size() < 2) continue;
    const auto numbers = numbers_of_properties(*search.entity);
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(meant),
                 [&](const LoggedNumber& n) { return means(search, n) && names_property(search, n); });
  }
  return meant;
}

/// "blue1.joint_torque": numbers of all its joints, each by its own name, in the order of the model.
std::vector<LoggedNumber> numbers_of_joints(const Search& search) {
  const auto& objects = search.entity->model().objects();
  std::vector<LoggedNumber> numbers = numbers_of_properties(*search.entity);
  std::erase_if(numbers, [&](const LoggedNumber& number) {
    const Object& object = objects[number.object];
    const std::string path = fmt::format("{}.{}.{}", search.entity->name(), object.name, number.property);
    const bool own_name = fmt::format("{}.", fmt::join(number.path, ".")).starts_with(path + ".");
    const bool label = search.parts.size() == 1 || matches(search.parts[1], number.path.back());
    return number.property != search.parts[0] || !object.is_joint() || !own_name || !label;
  });
  std::stable_sort(numbers.begin(), numbers.end(),
                   [](const LoggedNumber& a, const LoggedNumber& b) { return a.object < b.object; });
  return numbers;
}

bool means_joints(const Search& search) {
  return !search.parts.empty() && search.parts.size() <= 2 && scene_file::is_of_joints(search.parts[0]);
}

std::vector<LoggedNumber> joints_meant(const std::vector<Search>& all) {
  std::vector<LoggedNumber> meant;
  for (const Search& search : all) {
    if (!means_joints(search)) continue;
    const auto numbers = numbers_of_joints(search);
    meant.insert(meant.end(), numbers.begin(), numbers.end());
  }
  return meant;
}

/// Throws if no path in `numbers` matches the pattern: names the part that fails, and the alternatives.
void refuse_where_it_ends(const Search& search, std::vector<LoggedNumber> numbers,
                          const std::array<std::string_view, 3>& kinds) {
  if (numbers.empty()) throw SetupError(fmt::format("'{}' has no numbers that change", search.entity->name()));
  for (std::size_t i = 0; i < search.parts.size(); ++i) {
    std::vector<std::string_view> names;
    for (const LoggedNumber& number : numbers) {
      if (number.path.size() <= i + 1) continue;
      const std::string& name = number.path[i + 1];
      if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    }
    if (names.empty()) throw SetupError(fmt::format("there is nothing below '{}'", numbers[0].name()));
    if (std::none_of(names.begin(), names.end(),
                     [&](std::string_view name) { return matches(search.parts[i], std::string(name)); })) {
      throw SetupError(fmt::format("'{}': {}", search.entity->name(),
                                   unknown_name(kinds[std::min(i, kinds.size() - 1)], search.parts[i], names)));
    }
    std::erase_if(numbers, [&](const LoggedNumber& number) {
      return number.path.size() <= i + 1 || !matches(search.parts[i], number.path[i + 1]);
    });
  }
}

bool has_object(const Search& search) {
  const auto objects = search.entity->model().object_names();
  return !search.parts.empty() && std::any_of(objects.begin(), objects.end(), [&](std::string_view object) {
    return matches(search.parts[0], path_parts(object)[0]);
  });
}

[[noreturn]] void refuse_entity(const World& world, const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& entity : world.entities()) names.emplace_back(entity->name());
  throw SetupError(unknown_name("entity", name, names));
}

[[noreturn]] void refuse(const Search& search) {
  const std::string& entity = search.entity->name();
  if (means_joints(search)) {
    throw SetupError(fmt::format("joints of '{}' have no '{}' at {}: nothing writes it there", entity, search.parts[0],
                                 search.entity->level.empty() ? "its level" : search.entity->level));
  }
  const auto sensors = numbers_of_sensors(*search.entity);
  const bool sensor = std::any_of(sensors.begin(), sensors.end(), [&](const LoggedNumber& number) {
    return !search.parts.empty() && matches(search.parts[0], number.path[1]);
  });
  if (!sensor && has_object(search)) {
    refuse_where_it_ends(search, numbers_of_properties(*search.entity), {"object", "property", "label"});
    throw SetupError(fmt::format("say which property: '{}.{}.position'", entity, fmt::join(search.parts, ".")));
  }
  if (search.parts.size() > 1 && sensors.empty()) {
    throw SetupError(fmt::format("'{}' has no sensors; {}", entity,
                                 unknown_name("object", search.parts[0], search.entity->model().object_names())));
  }
  if (sensors.empty()) throw SetupError(fmt::format("'{}' has no sensors", entity));
  refuse_where_it_ends(search, sensors, {"sensor", "output", "label"});
  throw SetupError(fmt::format("'{}' has nothing of that name", entity));
}

std::vector<LoggedNumber> numbers_meant(const std::vector<Search>& all) {
  auto meant = sensors_meant(all);
  if (meant.empty()) meant = properties_meant(all);
  if (meant.empty()) meant = joints_meant(all);
  return meant;
}

std::vector<Entity*> all_of(const World& world) {
  std::vector<Entity*> all;
  for (const auto& entity : world.entities()) all.push_back(entity.get());
  return all;
}

std::vector<LoggedNumber> meant_by(const World& world, const std::string& pattern) {
  return with_context(fmt::format("--log '{}'", pattern), [&] {
    const auto parts = path_parts(pattern);
    if (std::find(parts.begin(), parts.end(), "") != parts.end()) throw SetupError("the path has an empty part");
    const auto all = searches(all_of(world), parts);
    auto meant = numbers_meant(all);
    if (all.empty()) refuse_entity(world, parts[0]);
    if (meant.empty()) {
      const auto sensing = std::find_if(all.begin(), all.end(),
                                        [](const Search& s) { return !sensors::readings_of(*s.entity).empty(); });
      refuse(sensing == all.end() ? all.back() : *sensing);
    }
    return meant;
  });
}

/// Patterns may overlap: every number is logged once.
template <class Find>
std::vector<LoggedNumber> each_once(const std::vector<std::string>& patterns, const Find& find) {
  std::vector<LoggedNumber> logged;
  std::set<std::tuple<const Entity*, std::string, int, std::string, std::size_t>> known;
  for (const std::string& pattern : patterns) {
    for (LoggedNumber& n : find(pattern)) {
      if (known.insert({n.entity, n.sensor, n.object, n.property, n.index}).second) logged.push_back(std::move(n));
    }
  }
  return logged;
}

}  // namespace

std::string LoggedNumber::name() const {
  const std::string text = fmt::format("{}", fmt::join(path, "."));
  return unit.empty() || unit == "-" ? text : fmt::format("{} [{}]", text, unit);
}

bool denotes_entity(const World& world, const std::string& pattern) {
  return !searches(all_of(world), path_parts(pattern)).empty();
}

std::vector<LoggedNumber> find_logged(const World& world, const std::vector<std::string>& patterns) {
  return each_once(patterns, [&](const std::string& pattern) { return meant_by(world, pattern); });
}

std::vector<LoggedNumber> find_logged(Entity& newcomer, const std::vector<std::string>& patterns) {
  return each_once(patterns, [&](const std::string& pattern) {
    return numbers_meant(searches({&newcomer}, path_parts(pattern)));
  });
}

}  // namespace murosimf::logging
