#include "benchmarks/peers/description.h"

#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace peers {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Shape, kind, size, position, rotation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Link, joint, parent, axis, offset, rotation, mass, center, inertia, shapes, gain,
                                   damping, limit, armature, friction)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Start, position, rotation, joints)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Description, step, friction, steps_per_cycle, links, statics, robots, targets)

namespace {

void check(const Description& description) {
  const auto require = [](bool right, const char* what) {
    if (!right) throw std::runtime_error(what);
  };
  require(description.links.size() > 1 && !description.robots.empty() && !description.targets.empty(),
          "no joints, robots or targets");
  require(description.step > 0 && description.steps_per_cycle > 0, "steps and cycles must be longer than nothing");
  for (const Start& robot : description.robots) {
    require(robot.joints.size() == description.joints(), "a robot has another number of joints");
  }
  for (const auto& row : description.targets) {
    require(row.size() == description.joints() * description.robots.size(), "a cycle has another number of targets");
  }
  for (std::size_t i = 1; i < description.links.size(); ++i) {
    const int parent = description.links[i].parent;
    require(parent >= 0 && static_cast<std::size_t>(parent) < i, "a link comes before its parent");
  }
}

}  // namespace

Description read_description(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  try {
    auto description = nlohmann::json::parse(stream).get<Description>();
    check(description);
    return description;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

void write_description(const Description& description, const std::filesystem::path& file) {
  std::ofstream stream(file);
  stream << nlohmann::json(description).dump() << '\n';
  stream.flush();
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace peers
