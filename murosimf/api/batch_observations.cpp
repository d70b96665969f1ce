#include "murosimf/api/batch_observations.h"

#include <limits>
#include <string_view>

#include "murosimf/api/told.h"
#include "murosimf/model/properties.h"

namespace murosimf::api {
namespace {

const Mat3d& turned(const Entity& robot) { return robot.find(properties::orientation)->values[0]; }

/// In the axes of the base.
Vec3d seen_from_base(const Entity& robot, const Property<Vec3d>& property) {
  return transposed_times(turned(robot), robot.find(property)->values[0]);
}

Vec3d gravity(const Entity& robot) { return transposed_times(turned(robot), Vec3d{0, 0, -1}); }
Vec3d linear_velocity(const Entity& robot) { return seen_from_base(robot, properties::linear_velocity); }
Vec3d angular_velocity(const Entity& robot) { return seen_from_base(robot, properties::angular_velocity); }

struct Named {
  std::string_view name;
  Vec3d (*base)(const Entity& robot);
};
constexpr Named of_base[] = {{"base.gravity", gravity},
                             {"base.linear_velocity", linear_velocity},
                             {"base.angular_velocity", angular_velocity}};

[[noreturn]] void refuse(const Entity& robot, const std::string& name) {
  std::vector<std::string> known = {"base.gravity", "base.linear_velocity", "base.angular_velocity", "last_action"};
  for (const auto& [property, column] : robot.columns()) {
    if (column->numbers() > 0) known.push_back(property);
  }
  throw_unknown("observation", name, {known.begin(), known.end()});
}

}  // namespace

BatchObservations::BatchObservations(const Entity& robot, const JointRows& joints,
                                     const std::vector<std::string>& names)
    : names_(names) {
  for (const std::string& name : names) {
    parts_.push_back(part_of(robot, joints, name));
    const Part& part = parts_.back();
    width_ += part.base ? 3 : part.rows.size() * part.numbers;
  }
}

auto BatchObservations::base_of(const std::string& name) -> Base {
  for (const auto& [known, base] : of_base) {
    if (known == name) return base;
  }
  return nullptr;
}

/// "OBJECT.PROPERTY", or a property alone: of all joints if all objects have it, else of the base.
auto BatchObservations::part_of(const Entity& robot, const JointRows& joints, const std::string& name) -> Part {
  Part part;
  part.base = base_of(name);
  if (part.base) return part;
  const std::size_t dot = name.find('.');
  part.property = name == "last_action" ? std::string(properties::joint_target.name) : name.substr(dot + 1);
  if (dot == std::string::npos && name != "last_action") part.property = name;
  const ColumnBase* column = robot.find(part.property);
  if (!column || column->numbers() == 0) refuse(robot, name);
  part.numbers = column->numbers();
  if (dot != std::string::npos) {
    const std::string object = name.substr(0, dot);
    const auto found = robot.model().find_object(object);
    if (!found) throw_unknown("object", object, robot.model().object_names());
    part.rows = {column->rows() == 1 ? 0 : static_cast<std::size_t>(*found)};
  } else if (column->rows() == 1) {
    part.rows = {0};
  } else {
    part.rows.assign(joints.objects.begin(), joints.objects.end());
  }
  return part;
}

void BatchObservations::fill(const Entity& robot, float* row) const {
  for (const Part& part : parts_) {
    if (part.base) {
      const Vec3d v = part.base(robot);
      for (const double number : {v.x, v.y, v.z}) *row++ = static_cast<float>(number);
      continue;
    }
    const ColumnBase* const column = robot.find(part.property);  // none: the level of this one has been exchanged
    for (const std::size_t object : part.rows) {
      for (std::size_t i = 0; i < part.numbers; ++i)
        *row++ = column ? static_cast<float>(column->get(object, i)) : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace murosimf::api
