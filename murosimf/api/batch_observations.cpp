#include "murosimf/api/batch_observations.h"

#include <limits>
#include <string_view>

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

}  // namespace

BatchObservations::BatchObservations(const Entity& robot, const JointRows& joints,
                                     const std::vector<std::string>& names)
    : names_(names) {
  for (const std::string& name : names) {
    parts_.push_back(part_of(robot, joints, name));
    const Part& part = parts_.back();
    width_ += part.base ? 3 : part.named.rows.size() * part.named.numbers;
  }
}

auto BatchObservations::base_of(const std::string& name) -> Base {
  for (const auto& [known, base] : of_base) {
    if (known == name) return base;
  }
  return nullptr;
}

auto BatchObservations::part_of(const Entity& robot, const JointRows& joints, const std::string& name) -> Part {
  if (const Base base = base_of(name)) return {base, {}};
  const std::string property = name == "last_action" ? std::string(properties::joint_target.name) : name;
  return {nullptr, named_rows(robot, joints, property, "observation",
                              {"base.gravity", "base.linear_velocity", "base.angular_velocity", "last_action"})};
}

void BatchObservations::fill(const Entity& robot, float* row) const {
  for (const Part& part : parts_) {
    if (part.base) {
      const Vec3d v = part.base(robot);
      for (const double number : {v.x, v.y, v.z}) *row++ = static_cast<float>(number);
      continue;
    }
    const ColumnBase* const column = robot.find(part.named.property);  // none: the level of this one has been exchanged
    for (const std::size_t object : part.named.rows) {
      for (std::size_t i = 0; i < part.named.numbers; ++i)
        *row++ = column ? static_cast<float>(column->get(object, i)) : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace murosimf::api
