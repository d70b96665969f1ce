#include "murosimf/model/properties.h"

#include "murosimf/model/keyframe.h"

#include <array>

#include "murosimf/model/visual_mesh.h"

namespace murosimf {

template class ConstantColumn<Shapes>;
template class ConstantColumn<Servo>;
template class ConstantColumn<Sole>;
template class ConstantColumn<Markings>;

}  // namespace murosimf

namespace murosimf::properties {
namespace {

constexpr std::array core_entries{constant(mass),
                                  constant(center_of_mass),
                                  constant(inertia),
                                  constant(shapes),
                                  constant(visuals),
                                  constant(joint_range),
                                  constant(joint_target_range),
                                  constant(joint_start),
                                  constant(keyframes),
                                  constant(servo),
                                  constant(sole),
                                  constant(markings),
                                  variable(position),
                                  variable(orientation),
                                  variable(linear_velocity),
                                  variable(angular_velocity),
                                  variable(joint_position),
                                  variable(joint_velocity),
                                  variable(linear_acceleration),
                                  variable(angular_acceleration),
                                  variable(joint_acceleration),
                                  variable(joint_target),
                                  variable(joint_velocity_target),
                                  variable(joint_torque),
                                  variable(motor_torque),
                                  variable(supply_voltage),
                                  variable(torque_enabled),
                                  variable(servo_temperature)};

}  // namespace

std::span<const CatalogEntry> core_list() { return core_entries; }

}  // namespace murosimf::properties
