#include "murosimf/scene_file/scene_change.h"

#include <fmt/format.h>

#include "murosimf/scene_file/event_section.h"

namespace murosimf::scene_file {
namespace {

/// The tables of a scene file, reduced to names: sufficient for resolving a path.
toml::table names_of(const SceneSpec& spec) {
  toml::array robots, bodies;
  for (const RobotSpec& robot : spec.robots) robots.push_back(toml::table{{"name", robot.name}, {"team", robot.team}});
  for (const BodySpec& body : spec.bodies) bodies.push_back(toml::table{{"name", body.name}});
  toml::table names{{"robots", std::move(robots)}, {"bodies", std::move(bodies)}};
  if (spec.ball) names.insert("ball", toml::table{});
  return names;
}

}  // namespace

SceneEvent read_change(const SceneSpec& spec, const std::string& text) {
  toml::table names = names_of(spec);
  return read_event(names, 0, text, fmt::format("'{}'", text));
}

}  // namespace murosimf::scene_file
