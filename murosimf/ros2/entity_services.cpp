// Services of simulation_interfaces that ask for entities and poses, or change them.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/ros2/entity_filter.h"
#include "murosimf/ros2/entity_view.h"
#include "murosimf/ros2/simulation_services.h"

namespace murosimf::ros2 {
namespace {

constexpr const char* no_entity = "there is no such entity";

/// What is not to be set stays as it is.
void keep_unset(EntityStateRequest& request, const EntityState& present) {
  EntityState& state = request.state;
  if (!request.sets_pose) {
    state.position = present.position;
    state.orientation = present.orientation;
  }
  if (request.sets_twist) return;
  state.linear = present.linear;
  state.angular = present.angular;
}

}  // namespace

Result SimulationServices::find(const EntityFilters& filters,
                                const std::function<void(const scene::Scene&, const Entity&)>& found) {
  if (!filters.bounds.is_known()) return {ResultCode::feature_unsupported, "there is no such type of bounds"};
  return attempt([&] {
    visit([&](scene::Scene& scene) {
      const auto info = [&](const Entity& entity) { return info_of(scene, entity); };
      for (const Entity* entity : filtered(scene, filters, info)) found(scene, *entity);
    });
  });
}

void SimulationServices::get_entities(dds::CdrReader& in, Answer& out) {
  const EntityFilters filters = read_filters(in);
  if (!in.good()) return;
  std::vector<std::string> names;
  put(out, find(filters, [&](const scene::Scene&, const Entity& entity) { names.push_back(entity.name()); }));
  out.texts(names);
}

void SimulationServices::get_entities_states(dds::CdrReader& in, Answer& out) {
  const EntityFilters filters = read_filters(in);
  if (!in.good()) return;
  std::vector<std::string> names;
  std::vector<EntityState> states;
  put(out, find(filters, [&](const scene::Scene& scene, const Entity& entity) {
        names.push_back(entity.name());
        states.push_back(state_of(scene, entity));
      }));
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
      const Entity* const entity = find_entity(scene, name);
      if (!entity || !entity->present()) return;
      state = state_of(scene, *entity);
      answer = {};
    });
  });
  put(out, visited.code == ResultCode::ok ? answer : visited);
  put(out, state);
}

void SimulationServices::set_entity_state(dds::CdrReader& in, Answer& out) {
  EntityStateRequest request = read_state_request(in);
  if (!in.good()) return;
  std::vector<std::string> changes;
  std::string trouble;
  bool there = false;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find_entity(scene, request.entity);
      there = entity && entity->present();
      if (!there) return;
      keep_unset(request, state_of(scene, *entity));
      trouble = trouble_with(request.state);
      if (trouble.empty()) changes = changes_to(*entity, request.state);
    });
  });
  if (visited.code != ResultCode::ok) return put(out, visited);
  if (!there) return put(out, {ResultCode::not_found, no_entity});
  if (!trouble.empty()) return put(out, {ResultCode::invalid_state, trouble});
  put(out, request.sets_pose || request.sets_twist ? change(changes) : Result{});
}

void SimulationServices::get_entity_info(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  Result answer{ResultCode::not_found, no_entity};
  EntityInfo info;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find_entity(scene, name);
      if (!entity) return;
      answer = {};
      info = info_of(scene, *entity);
    });
  });
  put(out, visited.code == ResultCode::ok ? answer : visited);
  put(out, info);
}

/// As a client has set it, or by its model.
EntityInfo SimulationServices::info_of(const scene::Scene& scene, const Entity& entity) const {
  const auto set = infos_.find(entity.name());
  if (set != infos_.end()) return set->second;
  return {category_of(scene, entity), fmt::format("{}{}", entity.model().name(), entity.present() ? "" : ", absent"),
          tags_of(entity)};
}

/// For clients alone: no result depends on it.
void SimulationServices::set_entity_info(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  EntityInfo info = read_info(in);
  if (!in.good()) return;
  bool there = false;
  const Result visited =
      attempt([&] { visit([&](scene::Scene& scene) { there = find_entity(scene, name) != nullptr; }); });
  if (visited.code != ResultCode::ok) return put(out, visited);
  if (!there) return put(out, {ResultCode::not_found, no_entity});
  infos_[name] = std::move(info);
  put(out, Result{});
}

void SimulationServices::get_entity_bounds(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  Result answer{ResultCode::not_found, no_entity};
  Bounds bounds;
  const Result visited = attempt([&] {
    visit([&](scene::Scene& scene) {
      const Entity* const entity = find_entity(scene, name);
      if (!entity || !entity->present()) return;
      bounds = bounds_of(*entity);
      answer = {};
    });
  });
  put(out, visited.code == ResultCode::ok ? answer : visited);
  put(out, bounds);
}

/// Start places: those of the entities that are present when the run begins.
void SimulationServices::note_starts(const scene::Scene& scene) {
  for (const Entity* entity : scene.moving_entities()) {
    if (!entity->present()) continue;
    std::vector<std::string> tags = tags_of(*entity);
    tags.insert(tags.begin(), "start");
    starts_.push_back({.name = entity->name(),
                       .description = fmt::format("where {} starts", entity->name()),
                       .tags = std::move(tags),
                       .state = state_of(scene, *entity),
                       .bounds = bounds_of(*entity)});
  }
}

void SimulationServices::get_named_poses(dds::CdrReader& in, Answer& out) {
  EntityFilters filters;
  read_tags_into(in, filters);
  if (!in.good()) return;
  std::vector<const NamedPose*> found;
  for (const NamedPose& start : starts_) {
    if (has_tags(filters, start.tags)) found.push_back(&start);
  }
  put(out, Result{});
  out.u32(static_cast<std::uint32_t>(found.size()));
  for (const NamedPose* pose : found) put(out, *pose);
}

void SimulationServices::get_named_pose_bounds(dds::CdrReader& in, Answer& out) {
  const std::string name = in.text();
  if (!in.good()) return;
  const auto start = std::ranges::find(starts_, name, &NamedPose::name);
  const bool there = start != starts_.end();
  put(out, there ? Result{} : Result{ResultCode::not_found, "there is no such pose: see GetNamedPoses"});
  put(out, there ? start->bounds : Bounds{});
}

}  // namespace murosimf::ros2
