// Services of simulation_interfaces by which entities come and go.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/ros2/entity_view.h"
#include "murosimf/ros2/simulation_services.h"

namespace murosimf::ros2 {
namespace {

constexpr std::uint32_t most_spawned = 100;  // by one request

SpawnRequest read_spawn(dds::CdrReader& in) {
  SpawnRequest wanted;
  wanted.name = in.text();
  wanted.may_rename = in.number<std::uint8_t>() != 0;
  wanted.uri = in.text();
  wanted.text = in.text();
  wanted.entity_namespace = in.text();
  wanted.pose = read_pose(in);
  return wanted;
}

}  // namespace

/// What the scene keeps in reserve, then the models that come with the program.
void SimulationServices::get_spawnables(dds::CdrReader& in, Answer& out) {
  (void)read_texts(in);  // sources: there are no others
  if (!in.good()) return;
  std::vector<std::pair<std::string, std::string>> all;  // uri, description
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      for (const Entity* entity : scene.moving_entities()) {
        if (entity->present() || spawned_.has(entity->name())) continue;
        all.emplace_back(entity->name(), fmt::format("an absent {} of the scene", entity->model().name()));
      }
    });
  });
  if (visited.code == ResultCode::ok) {
    for (const std::string& model : files::data_file_names("models", ".xml")) all.emplace_back(model, "a model");
  }
  put(out, visited);
  out.u32(static_cast<std::uint32_t>(all.size()));
  for (const auto& [uri, description] : all) {
    out.text(uri);
    out.text("");  // resource_string
    out.text(description);
    put(out, Bounds{});
  }
}

void SimulationServices::spawn_entity(dds::CdrReader& in, Answer& out) {
  SpawnRequest wanted = read_spawn(in);
  if (!in.good()) return;
  std::string name;
  const Result result = spawn(wanted, name);
  put(out, result);
  out.text(result.code == ResultCode::ok ? name : "");
}

/// One after the other; those that are refused change nothing for the others.
void SimulationServices::spawn_entities(dds::CdrReader& in, Answer& out) {
  std::vector<SpawnRequest> all;
  const std::uint32_t count = in.count(most_spawned);
  for (std::uint32_t i = 0; i < count && in.good(); ++i) all.push_back(read_spawn(in));
  if (!in.good()) return;
  std::vector<std::pair<Result, std::string>> results;
  for (SpawnRequest& wanted : all) {
    std::string name;
    const Result result = spawn(wanted, name);
    results.emplace_back(result, result.code == ResultCode::ok ? name : "");
  }
  const auto failed = std::ranges::count_if(results, [](const auto& one) { return one.first.code != ResultCode::ok; });
  put(out, failed == 0 ? Result{}
                       : Result{ResultCode::entities_spawn_failed,
                                fmt::format("{} of {} were refused: see results", failed, results.size())});
  out.u32(static_cast<std::uint32_t>(results.size()));
  for (const auto& [result, name] : results) {
    put(out, result);
    out.text(name);
  }
}

/// The name it has then.
Result SimulationServices::spawn(SpawnRequest& wanted, std::string& name) {
  if (wanted.uri.empty() && wanted.text.empty()) return {ResultCode::no_resource, "neither uri nor resource_string"};
  if (const std::string trouble = trouble_with(wanted.pose); !trouble.empty())
    return {ResultCode::invalid_pose, trouble};
  std::vector<std::string> changes;
  const auto let_in = [&](const scene::Scene& scene) {
    changes = {name + ".present = true"};
    const std::vector<std::string> placed = changes_to(*find_entity(scene, name), wanted.pose);
    changes.insert(changes.end(), placed.begin(), placed.end());
  };
  try {
    visit([&](scene::Scene& scene) {
      name = spawned_.waiting_for(scene, wanted);
      const Entity* const kept = find_entity(scene, wanted.uri);
      if (kept && !kept->present() && !spawned_.has(wanted.uri)) name = wanted.uri;
      if (!name.empty()) let_in(scene);
    });
    if (!name.empty() && name == wanted.uri && !wanted.name.empty() && wanted.name != name && !wanted.may_rename)
      return {ResultCode::name_invalid, fmt::format("it is called '{}'", name)};
    if (name.empty()) {
      session_
          .extend([&](scene::Scene& scene) {
            name = spawned_.add(scene, wanted);
            let_in(scene);
          })
          .get();
    }
  } catch (const RefusedSpawn& refused) {
    return {refused.code(), refused.what()};
  } catch (const SetupError& error) {
    return {ResultCode::operation_failed, files::one_line(error.what())};
  }
  return change(changes);
}

void SimulationServices::delete_entity(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  bool there = false;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find_entity(scene, name);
      there = entity && entity->present();
    });
  });
  if (visited.code != ResultCode::ok) return put(out, visited);
  if (!there) return put(out, {ResultCode::not_found, "there is no such entity"});
  infos_.erase(name);
  put(out, change({name + ".present = false"}));
}

/// SCOPE_SPAWNED: time and all others go on.
Result SimulationServices::remove_spawned() {
  std::vector<std::string> changes;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      for (const Entity* entity : scene.moving_entities()) {
        if (entity->present() && spawned_.has(entity->name())) changes.push_back(entity->name() + ".present = false");
      }
    });
  });
  return visited.code != ResultCode::ok || changes.empty() ? visited : change(changes);
}

}  // namespace murosimf::ros2
