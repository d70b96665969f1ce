#include "murosimf/viewer/scene_steering.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace murosimf::viewer {

void SceneSteering::begin(session::Session& session) {
  session_ = &session;
  requests_.forget();
}

void SceneSteering::ask(std::string what, std::future<void> done, bool silent) {
  requests_.ask(std::move(what), std::move(done), silent);
}

void SceneSteering::set_property(const ObjectPath& path, const PropertyValue& property) {
  const std::string numbers = fmt::format("{}", fmt::join(property.numbers, ", "));
  change(fmt::format("{}.{} = {}", outline_.path_text(path), property.name,
                     property.numbers.size() == 1 ? numbers : "[" + numbers + "]"));
}

void SceneSteering::move(int entity, const Vec3d& place) {
  requests_.move(outline_.path_text({entity, 0}) + ".position", fmt::format("[{}, {}, {}]", place.x, place.y, place.z));
  collect();
}

void SceneSteering::move_joint(const ObjectPath& path, double position) {
  if (!status_.paused) return messages_.tell("pause first (Space), then move joints", true);
  requests_.move(outline_.path_text(path) + ".joint_position", fmt::format("{}", position));
  collect();
}

void SceneSteering::push(const ObjectPath& path, const Vec3d& force) {
  change(fmt::format("{}.push = [{:.4g}, {:.4g}, {:.4g}, {:g}]", outline_.path_text(path), force.x, force.y, force.z,
                     push_seconds));
}

void SceneSteering::twist(const ObjectPath& path, const Vec3d& moment) {
  change(fmt::format("{}.push = [0, 0, 0, {:.4g}, {:.4g}, {:.4g}, {:g}]", outline_.path_text(path), moment.x, moment.y,
                     moment.z, push_seconds));
}

void SceneSteering::seek(double time, std::optional<int> branch) {
  ask(fmt::format("back to {:.3f} s", time), session_->seek(from_seconds(time), branch), true);
}

void SceneSteering::record() {
  const bool on = !status_.recorded.value_or(false);
  ask(on ? "recording" : "no longer recording", session_->record(on));
}

void SceneSteering::publish_poses() {
  ask("poses", session_->visit([](scene::Scene& scene) { scene.simulation().publish_poses(); }), true);
}

}  // namespace murosimf::viewer
