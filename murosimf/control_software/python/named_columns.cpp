#include "murosimf/control_software/python/named_columns.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"

namespace murosimf::control_software {
namespace {

struct Entry {
  const PropertyInfo* info;
  ColumnBase::Memory (*read)(Setup&);
  ColumnBase::Memory (*write)(Setup&);
};

template <const auto& property>
ColumnBase::Memory memory_of(Setup& setup) {
  return setup.entity().column(property).memory();
}

/// A number that the present level does not give reads as NaN; other values must be written by some algorithm.
template <const auto& property>
ColumnBase::Memory read(Setup& setup) {
  using Value = typename std::remove_cvref_t<decltype(property)>::Value;
  if constexpr (std::is_same_v<Value, double>) {
    (void)setup.observe(property);
  } else {
    (void)setup.read(property);
  }
  return memory_of<property>(setup);
}

template <const auto& property>
ColumnBase::Memory write(Setup& setup) {
  (void)setup.write(property);
  return memory_of<property>(setup);
}

template <const auto& property>
constexpr Entry entry() {
  return {&property, read<property>, write<property>};
}

// clang-format off
constexpr std::array entries{
    entry<properties::position>(), entry<properties::orientation>(),
    entry<properties::linear_velocity>(), entry<properties::angular_velocity>(),
    entry<properties::joint_position>(), entry<properties::joint_velocity>(),
    entry<properties::joint_target>(), entry<properties::joint_velocity_target>(),
    entry<properties::joint_torque>(), entry<properties::motor_torque>(),
    entry<properties::supply_voltage>(), entry<properties::torque_enabled>(), entry<properties::servo_temperature>(),
    entry<properties::servo_position_gain>(), entry<properties::servo_velocity_gain>(),
    entry<properties::servo_torque_limit>(), entry<properties::servo_feed_forward>(), entry<properties::servo_led>(),
    entry<properties::joint_load>(), entry<properties::robot_led>(),
    entry<properties::distance_walked>(), entry<properties::falls>(), entry<properties::lying>(),
    entry<properties::walk_command>(), entry<properties::halted>(), entry<properties::gait_velocity>(),
    entry<properties::gait_phase>(), entry<properties::gait_amplitude>(), entry<properties::motion_time>(),
    entry<properties::odometry>(),
    entry<properties::applied_force>(), entry<properties::interaction_force>(), entry<properties::external_force>(),
    entry<properties::stance_foot>()};
// clang-format on

const Entry* find(std::string_view property) {
  const auto found = std::ranges::find_if(entries, [&](const Entry& one) { return one.info->name == property; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

NamedColumn column_to_read(Setup& setup, std::string_view property) {
  const Entry* const found = find(property);
  return found ? NamedColumn{found->info, found->read(setup)} : NamedColumn{};
}

NamedColumn column_to_write(Setup& setup, std::string_view property) {
  const Entry* const found = find(property);
  return found ? NamedColumn{found->info, found->write(setup)} : NamedColumn{};
}

std::vector<std::string_view> names_of_columns() {
  std::vector<std::string_view> names;
  for (const Entry& one : entries) names.push_back(one.info->name);
  return names;
}

}  // namespace murosimf::control_software
