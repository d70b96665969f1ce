#include "murosimf/recording/robot_urdf.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/robot/robot_conversion.h"

namespace murosimf::recording {

std::string urdf_of(const scene::Scene& scene, const Entity& robot) {
  const auto& specs = scene.spec().robots;
  const auto spec = std::ranges::find(specs, robot.name(), &scene_file::RobotSpec::name);
  if (spec == specs.end()) return {};
  const files::FileScope scope(scene.parts().files);
  const auto file = files::find_data_file(spec->model, "models", ".xml", scene.spec().file.parent_path());
  return robot::convert_robot(file, {.folder = file.parent_path(),
                                     .reader = {.lenient = true, .xacro = spec->xacro, .body = spec->body},
                                     .format = robot::WrittenFormat::urdf})
      .text;
}

/// A joint names its child before the next joint begins (robot/robot_conversion.h).
FrameNames frames_by_links(const std::string& robot, std::string_view urdf) {
  constexpr std::string_view joint = "<joint name=\"", child = "<child link=\"";
  const auto value_at = [&](std::size_t begin) { return urdf.substr(begin, urdf.find('"', begin) - begin); };
  FrameNames frames;
  for (std::size_t at = urdf.find(joint); at != std::string_view::npos; at = urdf.find(joint, at + 1)) {
    const std::size_t link = urdf.find(child, at);
    if (link == std::string_view::npos) break;
    frames.emplace(fmt::format("{}/{}", robot, value_at(at + joint.size())),
                   fmt::format("{}/{}", robot, value_at(link + child.size())));
  }
  return frames;
}

}  // namespace murosimf::recording
