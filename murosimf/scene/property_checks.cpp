#include "murosimf/scene/property_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/catalog/property_catalog.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene_file/setting_targets.h"
#include "murosimf/scene_file/unused_settings.h"

namespace murosimf::scene {
namespace {

using Numbers = std::span<const double>;

/// Kind of object that a settable property belongs to.
enum class Owner { base, body, joint, servo, motor, gear };

/// Reason why a property cannot have these numbers; empty if it can.
using ValueCheck = std::string_view (*)(Numbers);

std::string_view not_negative(Numbers numbers) {
  MUROSIMF_ASSERT(!numbers.empty());
  return numbers[0] < 0 ? "must not be negative" : "";
}
std::string_view zero_or_one(Numbers numbers) {
  MUROSIMF_ASSERT(!numbers.empty());
  return numbers[0] == 0 || numbers[0] == 1 ? "" : "must be 0 or 1";
}
std::string_view above_absolute_zero(Numbers numbers) {
  MUROSIMF_ASSERT(!numbers.empty());
  return numbers[0] < -273 ? "is colder than anything" : "";
}
std::string_view unit_length(Numbers numbers) {
  double square = 0;
  for (const double number : numbers) square += number * number;
  return std::abs(std::sqrt(square) - 1) < 1e-3 ? "" : "must have length 1: w, x, y, z of a turn";
}

/// A property that has an effect if set although algorithms may write it, or that no algorithm writes.
struct SettableProperty {
  std::string_view name;
  Owner owner = Owner::base;
  bool of_level = false;  ///< used only by levels that list it (LevelType::inputs)
  ValueCheck check = nullptr;
};

constexpr std::array settable{
    SettableProperty{"position"},
    SettableProperty{"linear_velocity", Owner::base, true},
    SettableProperty{"angular_velocity", Owner::base, true},
    SettableProperty{"base_quaternion", Owner::base, true, unit_length},
    SettableProperty{"stance_pose", Owner::base, true},
    SettableProperty{"stance_foot", Owner::base, true, zero_or_one},
    SettableProperty{"remaining_shift", Owner::base, true},
    SettableProperty{"remaining_turn", Owner::base, true},
    SettableProperty{"joint_position", Owner::joint},
    SettableProperty{"joint_velocity", Owner::joint},
    SettableProperty{"joint_target", Owner::joint},
    SettableProperty{"joint_velocity_target", Owner::joint},
    SettableProperty{"cycle_target", Owner::joint},
    SettableProperty{"applied_force", Owner::body, true},
    SettableProperty{"supply_voltage", Owner::motor, true, not_negative},
    SettableProperty{"torque_enabled", Owner::servo, true, zero_or_one},
    SettableProperty{"servo_temperature", Owner::motor, true, above_absolute_zero},
    SettableProperty{"backlash_play", Owner::gear, true},
    SettableProperty{"backlash_side", Owner::gear, true},
    SettableProperty{"rotor_rate", Owner::gear, true},
    SettableProperty{"gait_velocity"},
    SettableProperty{"gait_phase"},
    SettableProperty{"gait_amplitude"},
    SettableProperty{"path_curvature"},
    SettableProperty{"motion_time"},
    SettableProperty{"balance_up"},
    SettableProperty{"balance_upright"},
    SettableProperty{"balance_bias"},
    SettableProperty{"balance_capture"},
    SettableProperty{"next_waypoint"},
};

const SettableProperty* find_settable(std::string_view name) {
  const auto found = std::ranges::find(settable, name, &SettableProperty::name);
  return found == settable.end() ? nullptr : &*found;
}

const scene_file::RobotSpec* find_spec(const scene_file::SceneSpec& spec, std::string_view name) {
  const auto found = std::ranges::find(spec.robots, name, &scene_file::RobotSpec::name);
  return found == spec.robots.end() ? nullptr : &*found;
}

bool changes_level_before(const scene_file::SceneSpec& spec, const std::string& robot, double time) {
  return std::ranges::any_of(spec.events, [&](const scene_file::SceneEvent& event) {
    const bool concerned = std::ranges::find(event.entities, robot) != event.entities.end();
    return concerned && event.key == "level" && event.time <= time;
  });
}

bool is_variable(std::string_view name) {
  return std::ranges::any_of(properties::catalog(),
                             [&](const auto& entry) { return !entry.constant && entry.info.name == name; });
}

std::string called(const Entity& entity, int index) {
  return fmt::format("entity '{}', object '{}'", entity.name(), entity.model().objects()[index].name);
}

/// Checks setting it now. Returns false if the property does not exist yet, but a level may create it.
bool can_be_set(Entity& entity, ObjectAccess object, int index, const scene_file::PropertySetting& setting,
                bool level_changes) {
  const ColumnBase* column = entity.find(setting.property);
  if (!column && level_changes && is_variable(setting.property)) return false;
  if (!column && is_variable(setting.property)) {
    throw SetupError(fmt::format("{}: '{}' is not used here: neither {} nor its controller and sensors",
                                 called(entity, index), setting.property, entity.level));
  }
  const bool whole = column && !of_every_object(column->info().scope);
  const bool fits = column && column->numbers() > 0 && column->numbers() == setting.numbers.size() &&
                    std::ranges::all_of(setting.numbers, [](double x) { return std::isfinite(x); }) &&
                    (whole ? index == 0 : !entity.model().objects()[index].structural);
  if (!fits) object.set(setting.property, setting.numbers);  // throws with the reason, and sets nothing
  return true;
}

/// Throws SetupError if the property does not apply to this object.
void check_owner(const Entity& entity, int index, const SettableProperty& property) {
  const Model& model = entity.model();
  const auto need = [&](bool good, std::string_view what) {
    if (!good) throw SetupError(fmt::format("{}: '{}' is for {}", called(entity, index), property.name, what));
  };
  switch (property.owner) {
    case Owner::base:
      return need(index == 0, fmt::format("the base '{}' only; the others follow it", model.objects()[0].name));
    case Owner::body: {
      const auto bodies = model.bodies();
      return need(std::ranges::find(bodies, index) != bodies.end(), "objects with mass or shape");
    }
    case Owner::joint: {
      const auto joints = model.joints();
      return need(std::ranges::find(joints, index) != joints.end(), "joints");
    }
    case Owner::servo:
    case Owner::motor:
    case Owner::gear: return need(model.find(properties::servo, index) != nullptr, "joints with a servo");
  }
}

/// Throws SetupError if the value would be overwritten.
void check_writers(const Simulation& simulation, const Entity& entity, int index, std::string_view property) {
  const auto writers = simulation.writers_of(entity, property);
  if (writers.empty()) return;
  throw SetupError(fmt::format("{}: '{}' is a result that {} writes while the scene runs; setting it changes nothing",
                               called(entity, index), property, fmt::join(writers, ", ")));
}

/// Reason why a servo does not use its supply; empty if it does.
std::string why_no_motor(const Servo& servo, const scene_file::RobotSpec& robot, std::string_view property) {
  if (dynamics::with_law(servo, robot.servo_law).law != "dc_motor") return "the law of this servo has no motor";
  if (property == "supply_voltage" && servo.voltage <= 0)
    return "this servo has no 'voltage' that it could differ from";
  if (property == "servo_temperature" && servo.heat.heat_capacity <= 0) return "this servo has no 'heat_capacity'";
  return {};
}

/// Reason why a joint does not use this one of the two targets; empty if it does.
std::string why_no_target(const Model& model, int joint, const std::vector<const catalog::LevelType*>& levels,
                          std::string_view property) {
  const Servo* servo = model.find(properties::servo, joint);
  const bool of_rate = servo && dynamics::follows_rate(*servo);
  if (of_rate != (property == "joint_velocity_target")) {
    return fmt::format("this joint follows '{}'", of_rate ? "joint_velocity_target" : "joint_target");
  }
  if (model.find(properties::joint_coupling, joint)) return "this joint follows another one";
  if (model.find(properties::loop_commanded, joint)) return {};
  const auto needs_servo = [](const catalog::LevelType* level) { return catalog::has_word(level->keys, "servo_law"); };
  if (multibody::is_tendon(model, joint) && (!servo || std::ranges::none_of(levels, needs_servo))) {
    return "this is the length of a tendon, which nothing pulls here: its joints say what it is";
  }
  if (!servo && std::ranges::all_of(levels, needs_servo)) return "this joint has no servo and hangs free";
  return {};
}

/// Whether the property would move a base that is fixed to the world.
bool moves_fixed_base(const scene_file::RobotSpec& robot, const std::vector<const catalog::LevelType*>& levels,
                      const Model& model, int index, std::string_view property) {
  const bool moves = property == "linear_velocity" || property == "angular_velocity" || property == "applied_force";
  if (index == 0 && moves && has_fixed_base(model)) return true;
  return robot.fixed_base && index == 0 && moves && std::ranges::all_of(levels, [](const catalog::LevelType* level) {
           return catalog::has_word(level->keys, "fixed_base");
         });
}

std::string why_it_does_not_act(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot,
                                const Entity& entity, int index, const SettableProperty& property, double time) {
  MUROSIMF_ASSERT(index >= 0 && static_cast<std::size_t>(index) < entity.model().objects().size());
  const auto levels = scene_file::levels_from(spec, robot, time);
  const bool acts = !property.of_level || std::ranges::any_of(levels, [&](const catalog::LevelType* level) {
    return catalog::has_word(level->inputs, property.name);
  });
  if (!acts) return fmt::format("{} does not use '{}'", levels.front()->name, property.name);
  if (moves_fixed_base(robot, levels, entity.model(), index, property.name)) return "its base is fixed";
  if (property.name == "joint_target" || property.name == "joint_velocity_target") {
    return why_no_target(entity.model(), index, levels, property.name);
  }
  if (property.owner == Owner::gear && entity.model().find(properties::servo, index)->backlash <= 0) {
    return "this servo has no 'backlash'";
  }
  if (property.owner == Owner::motor) {
    return why_no_motor(*entity.model().find(properties::servo, index), robot, property.name);
  }
  return {};
}

bool moves_height(const scene_file::PropertySetting& setting, const Entity& entity) {
  const auto* place = entity.find(properties::position);
  return setting.property == "position" && place && setting.numbers[2] != place->values[0].z;
}

/// check_setting for one of the denoted objects.
std::string check_object(Simulation& simulation, const scene_file::SceneSpec& spec,
                         const scene_file::PropertySetting& setting, Entity& entity, int index, double time) {
  const ObjectAccess object(entity, index);
  if (!can_be_set(entity, object, index, setting, changes_level_before(spec, entity.name(), time))) return {};
  const SettableProperty* property = find_settable(setting.property);
  if (!property) {
    if (is_variable(setting.property)) check_writers(simulation, entity, index, setting.property);
    return {};
  }
  check_owner(entity, index, *property);
  if (property->check) {
    if (const auto why = property->check(setting.numbers); !why.empty()) {
      throw SetupError(fmt::format("{}: '{}' {}", called(entity, index), setting.property, why));
    }
  }
  const scene_file::RobotSpec* robot = find_spec(spec, entity.name());
  if (!robot) return {};  // ball and bodies are always at one level, which uses all of them
  if (auto why = why_it_does_not_act(spec, *robot, entity, index, *property, time); !why.empty()) return why;
  const auto levels = scene_file::levels_from(spec, *robot, time);
  if (!catalog::has_word(levels.front()->keys, "position.z") && levels.size() == 1 && moves_height(setting, entity)) {
    return fmt::format("{} does not use z of 'position'", levels.front()->name);
  }
  return {};
}

}  // namespace

std::string check_setting(Simulation& simulation, const scene_file::SceneSpec& spec,
                          const scene_file::PropertySetting& setting, const std::string& name, double time) {
  if (is_constant(setting)) return {};  // checked by what changes it (constant_changes.h)
  Entity& entity = simulation.world().entity(name);
  for (const int index : scene_file::objects_meant(entity.model(), setting.object, setting.property)) {
    if (auto why = check_object(simulation, spec, setting, entity, index, time); !why.empty()) return why;
  }
  return {};
}

std::string check_command(const scene_file::RobotSpec& robot, const Model& model, const Vec3d& command) {
  const catalog::ControllerType& controller = find_entry(catalog::controllers(), "controller", robot.controller);
  if (!controller.attainable || is_zero(command)) return {};
  const Vec3d most = controller.attainable(model, robot.options, command);
  // below the rounding of clamps and curvatures
  if (norm(most - command) < 1e-9) return {};
  return fmt::format(
      "the command [{:.3g}, {:.3g}, {:.3g}] (m/s, m/s, rad/s) is more than '{}' can do with this robot: "
      "[{:.3g}, {:.3g}, {:.3g}]",
      command.x, command.y, command.z, robot.controller, most.x, most.y, most.z);
}

/// As users write it: without an object where none is needed.
std::string setting_path(const scene_file::PropertySetting& setting, const Entity& entity) {
  if (setting.object.empty() && scene_file::is_of_joints(setting.property)) {
    return fmt::format("{}.{}", entity.name(), setting.property);
  }
  const std::string& object = setting.object.empty() ? entity.model().objects()[0].name : setting.object;
  return fmt::format("{}.{}.{}", entity.name(), object, setting.property);
}

std::string to_text(const scene_file::PropertySetting& setting, const Entity& entity) {
  const std::string value = setting.numbers.size() == 1 ? fmt::format("{}", setting.numbers[0])
                                                        : fmt::format("[{}]", fmt::join(setting.numbers, ", "));
  return fmt::format("{} = {}", setting_path(setting, entity), value);
}

}  // namespace murosimf::scene
