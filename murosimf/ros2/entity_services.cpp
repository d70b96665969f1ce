// Services of simulation_interfaces that ask for entities and worlds, or change them.
#include <regex.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/ros2/simulation_services.h"

namespace murosimf::ros2 {
namespace {

constexpr const char* no_entity = "there is no such entity";

Category category_of(const scene::Scene& scene, const Entity& entity) {
  const auto& robots = scene.parts().robots;
  return std::ranges::find(robots, &entity) != robots.end() ? Category::robot : Category::dynamic_object;
}

/// Model and team.
std::vector<std::string> tags_of(const Entity& entity) {
  std::vector<std::string> tags{entity.model().name()};
  if (!entity.options().team.empty()) tags.push_back(entity.options().team);
  return tags;
}

const Entity* find(const scene::Scene& scene, const std::string& name) {
  const auto& all = scene.moving_entities();
  const auto found = std::ranges::find(all, name, [](const Entity* entity) { return entity->name(); });
  return found == all.end() ? nullptr : *found;
}

/// Of its base, in the world.
EntityState state_of(const scene::Scene& scene, const Entity& entity) {
  EntityState state{.time = scene.simulation().now()};
  if (const auto* position = entity.find(properties::position)) state.position = position->values[0];
  if (const auto* turn = entity.find(properties::orientation)) state.orientation = from_matrix(turn->values[0]);
  if (const auto* linear = entity.find(properties::linear_velocity)) state.linear = linear->values[0];
  if (const auto* angular = entity.find(properties::angular_velocity)) state.angular = angular->values[0];
  return state;
}

bool matches(const EntityFilters& filters, const std::vector<std::string>& tags) {
  const auto has = [&](const std::string& tag) { return std::ranges::find(tags, tag) != tags.end(); };
  if (filters.tags.empty()) return true;
  return filters.all_tags ? std::ranges::all_of(filters.tags, has) : std::ranges::any_of(filters.tags, has);
}

/// A POSIX extended regular expression. What takes longer than its length is not taken: counted repetitions and references to groups.
class Expression {
 public:
  /// Throws SetupError.
  explicit Expression(const std::string& text) {
    constexpr std::size_t longest = 200;  // [byte]
    if (text.size() > longest || text.find_first_of("{\\") != std::string::npos)
      throw SetupError(fmt::format("a filter has at most {} characters, and neither {{ nor \\", longest));
    if (regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw SetupError("the filter is no POSIX extended regular expression");
  }
  ~Expression() { regfree(&compiled_); }
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;
  [[nodiscard]] bool matches(const std::string& name) const {
    return regexec(&compiled_, name.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

/// Present ones. Throws SetupError: the filter is none.
std::vector<const Entity*> filtered(const scene::Scene& scene, const EntityFilters& filters) {
  std::optional<Expression> expression;
  if (!filters.names.empty()) expression.emplace(filters.names);
  std::vector<const Entity*> found;
  for (const Entity* entity : scene.moving_entities()) {
    const auto& of = filters.categories;
    if (!entity->present() || (expression && !expression->matches(entity->name()))) continue;
    if (!of.empty() && std::ranges::find(of, category_of(scene, *entity)) == of.end()) continue;
    if (matches(filters, tags_of(*entity))) found.push_back(entity);
  }
  return found;
}

std::string numbers(const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// Upright and at rest at first, which leaves nothing of contacts before; then as wanted.
std::vector<std::string> changes_to(const Entity& entity, const EntityState& state) {
  const std::string base = fmt::format("{}.{}", entity.name(), entity.model().objects()[0].name);
  const Mat3d R = to_matrix(state.orientation);
  return {fmt::format("{}.place = [{}, {}, 0, {}]", entity.name(), state.position.x, state.position.y, heading(R)),
          fmt::format("{}.position = {}", base, numbers(state.position)),
          fmt::format("{}.orientation = [{}, {}, {}, {}, {}, {}, {}, {}, {}]", base, R.x.x, R.y.x, R.z.x, R.x.y, R.y.y,
                      R.z.y, R.x.z, R.y.z, R.z.z),
          fmt::format("{}.linear_velocity = {}", base, numbers(state.linear)),
          fmt::format("{}.angular_velocity = {}", base, numbers(state.angular))};
}

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Empty: it can be. Normalizes the orientation.
std::string trouble_with(EntityState& state) {
  Quaterniond& q = state.orientation;
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!is_finite(state.position) || !is_finite(state.linear) || !is_finite(state.angular))
    return "numbers are not finite";
  if (!(std::abs(size - 1) < 0.01)) return "the quaternion is not of length 1";
  q = {q.w / size, q.x / size, q.y / size, q.z / size};
  return state.frame.empty() || state.frame == "world" ? "" : "the frame must be world";
}

}  // namespace

void SimulationServices::get_entities(dds::CdrReader& in, Answer& out) {
  const EntityFilters filters = read_filters(in);
  if (!in.good()) return;
  std::vector<std::string> names;
  Result result = attempt([&] {
    visit([&](scene::Scene& scene) {
      for (const Entity* entity : filtered(scene, filters)) names.push_back(entity->name());
    });
  });
  if (filters.has_bounds) result = {ResultCode::feature_unsupported, "filters by bounds"};
  if (result.code != ResultCode::ok) names.clear();
  put(out, result);
  out.texts(names);
}

void SimulationServices::get_entities_states(dds::CdrReader& in, Answer& out) {
  const EntityFilters filters = read_filters(in);
  if (!in.good()) return;
  std::vector<std::string> names;
  std::vector<EntityState> states;
  Result result = attempt([&] {
    visit([&](scene::Scene& scene) {
      for (const Entity* entity : filtered(scene, filters)) {
        names.push_back(entity->name());
        states.push_back(state_of(scene, *entity));
      }
    });
  });
  if (filters.has_bounds) result = {ResultCode::feature_unsupported, "filters by bounds"};
  if (result.code != ResultCode::ok) names.clear(), states.clear();
  put(out, result);
  out.texts(names);
  out.u32(static_cast<std::uint32_t>(states.size()));
  for (const EntityState& state : states) put(out, state);
}

void SimulationServices::get_entity_state(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  Result answer{ResultCode::not_found, no_entity};
  EntityState state;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find(scene, name);
      if (!entity || !entity->present()) return;
      state = state_of(scene, *entity);
      answer = {};
    });
  });
  put(out, visited.code == ResultCode::ok ? answer : visited);
  put(out, state);
}

void SimulationServices::set_entity_state(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  EntityState state = read_state(in);
  if (!in.good()) return;
  if (const std::string trouble = trouble_with(state); !trouble.empty())
    return put(out, {ResultCode::operation_failed, trouble});
  std::vector<std::string> changes;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find(scene, name);
      if (entity && entity->present()) changes = changes_to(*entity, state);
    });
  });
  if (visited.code != ResultCode::ok) return put(out, visited);
  if (changes.empty()) return put(out, {ResultCode::not_found, no_entity});
  put(out, change(changes));
}

void SimulationServices::get_entity_info(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  Result answer{ResultCode::not_found, no_entity};
  Category category = Category::unknown;
  std::string description;
  std::vector<std::string> tags;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find(scene, name);
      if (!entity) return;
      answer = {};
      category = category_of(scene, *entity);
      tags = tags_of(*entity);
      description = fmt::format("{}{}", entity->model().name(), entity->present() ? "" : ", absent");
    });
  });
  put(out, visited.code == ResultCode::ok ? answer : visited);
  out.u8(static_cast<std::uint8_t>(category));
  out.text(description);
  out.texts(tags);
}

/// What the scene keeps in reserve: entities that are absent.
void SimulationServices::get_spawnables(dds::CdrReader& in, Answer& out) {
  (void)read_texts(in);  // sources: there are no others
  if (!in.good()) return;
  std::vector<std::pair<std::string, std::string>> absent;
  put(out, attempt([&] {
        visit([&](scene::Scene& scene) {
          for (const Entity* entity : scene.moving_entities()) {
            if (!entity->present()) absent.emplace_back(entity->name(), entity->model().name());
          }
        });
      }));
  out.u32(static_cast<std::uint32_t>(absent.size()));
  for (const auto& [name, model] : absent) {
    out.text(name);  // uri
    out.text("");    // resource_string
    out.text(model);
    out.u8(0);  // no bounds
    out.u32(0);
  }
}

void SimulationServices::spawn_entity(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  const bool may_rename = in.number<std::uint8_t>() != 0;
  const std::string uri = in.text(), resource = in.text();
  (void)in.text();  // namespace: topics stand below the entity's name
  EntityState pose = read_pose(in);
  if (!in.good()) return;
  const auto refused = [&](ResultCode code, const std::string& why) {
    put(out, {code, why});
    out.text("");
  };
  if (uri.empty() && resource.empty()) return refused(ResultCode::no_resource, "no uri");
  if (uri.empty()) return refused(ResultCode::feature_unsupported, "resource_string: see GetSpawnables");
  if (!name.empty() && name != uri && !may_rename)
    return refused(ResultCode::name_invalid, fmt::format("it is called '{}'", uri));
  if (const std::string trouble = trouble_with(pose); !trouble.empty())
    return refused(ResultCode::operation_failed, trouble);
  std::vector<std::string> changes;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find(scene, uri);
      if (!entity || entity->present()) return;
      changes = {uri + ".present = true"};
      const std::vector<std::string> placed = changes_to(*entity, pose);
      changes.insert(changes.end(), placed.begin(), placed.end());
    });
  });
  if (visited.code != ResultCode::ok) return refused(visited.code, visited.message);
  if (changes.empty())
    return refused(ResultCode::not_found, "there is no absent entity of this name: see GetSpawnables");
  const Result done = change(changes);
  if (done.code != ResultCode::ok) return refused(done.code, done.message);
  put(out, done);
  out.text(uri);
}

void SimulationServices::delete_entity(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  bool there = false;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find(scene, name);
      there = entity && entity->present();
    });
  });
  if (visited.code != ResultCode::ok) return put(out, visited);
  if (!there) return put(out, {ResultCode::not_found, no_entity});
  put(out, change({name + ".present = false"}));
}

void SimulationServices::get_current_world(dds::CdrReader&, Answer& out) {
  std::string name, file;
  put(out, attempt([&] {
        visit([&](scene::Scene& scene) {
          name = scene.spec().name;
          file = scene.spec().file.stem().string();
        });
      }));
  put_world(out, file, name);
}

void SimulationServices::get_available_worlds(dds::CdrReader& in, Answer& out) {
  (void)read_texts(in);
  if (!in.good()) return;
  const std::vector<std::string> names = files::data_file_names("scenes", ".toml");
  put(out, Result{});
  out.u32(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) put_world(out, name, "");
}

/// The present run ends then; the next one, stopped at its start, has the wanted scene, and services of the same names.
void SimulationServices::load_world(dds::CdrReader& in, Answer& out) {
  const std::string uri = in.text(), resource = in.text();
  for (int i = 0; i < 2; ++i) (void)in.number<std::uint8_t>();
  if (!in.good()) return;
  const auto answer_with = [&](const Result& result) {
    put(out, result);
    put_world(out, result.code == ResultCode::ok ? uri : "", "");
  };
  if (uri.empty() && resource.empty()) return answer_with({ResultCode::no_world_resource, "no uri"});
  if (uri.empty() || !options_.exchange)
    return answer_with(
        {ResultCode::feature_unsupported, "scenes are loaded by uri, where the run may change its scene"});
  Result result = attempt([&] {
    visit([&](scene::Scene&) { options_.exchange({.scene = uri, .overrides = {}, .seed = {}, .paused = true}); });
  });
  if (result.code != ResultCode::ok) return answer_with({ResultCode::world_parse_error, result.message});
  answer_with(result);
  finishes_ = true;
}

}  // namespace murosimf::ros2
