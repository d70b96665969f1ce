#include "murosimf/model/properties.h"

#include <array>

#include "murosimf/model/visual_mesh.h"

namespace murosimf::properties {
namespace {

constexpr CatalogEntry constant(const PropertyInfo& info) { return {info, true}; }
constexpr CatalogEntry variable(const PropertyInfo& info) { return {info, false}; }

// clang-format off
constexpr std::array entries{
    constant(mass), constant(center_of_mass), constant(inertia), constant(shapes), constant(visuals), constant(joint_range),
    constant(servo), constant(joint_damping), constant(joint_armature), constant(joint_friction),
    constant(joint_stiffness), constant(joint_spring_reference),
    constant(joint_coupling), constant(excluded_pairs), constant(allowed_pairs), constant(sole),
    constant(markings), variable(position), variable(orientation), variable(linear_velocity),
    variable(angular_velocity), variable(joint_position), variable(joint_velocity), variable(joint_target), variable(joint_velocity_target),
    variable(joint_torque), variable(motor_torque), variable(joint_load), variable(coupling_torque), variable(felt_acceleration), variable(supply_voltage), variable(torque_enabled),
    variable(servo_temperature), variable(sent_target), variable(sent_target_age), variable(backlash_play),
    variable(backlash_side), variable(rotor_rate), variable(torque_need), variable(overload),
    variable(cycle_target), variable(applied_force), variable(interaction_force), variable(external_force),
    variable(external_damping), variable(base_quaternion), variable(total_mass), variable(common_center_of_mass),
    variable(common_center_of_mass_velocity), variable(common_inertia), variable(stance_pose),
    variable(stance_foot), variable(remaining_shift), variable(remaining_turn), variable(dynamic), variable(separation), variable(absorbed_impulse), variable(walk_command),
    variable(gait_velocity), variable(path_curvature), variable(gait_phase), variable(gait_amplitude), variable(motion_time), variable(distance_walked),
    variable(balance_up), variable(balance_upright), variable(balance_bias), variable(balance_capture), variable(pose_estimate),
    variable(pose_spread), variable(next_waypoint),
    variable(falls), variable(lying), variable(distance_sample), variable(up_at_start),
    variable(written_position), variable(written_velocity),
};
// clang-format on

}  // namespace

std::span<const CatalogEntry> catalog() { return entries; }

}  // namespace murosimf::properties
