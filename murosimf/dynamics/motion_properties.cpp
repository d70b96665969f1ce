#include "murosimf/dynamics/motion_properties.h"

#include <array>

#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/multibody/joint_tendon.h"
#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/multibody/tendon_tie.h"

namespace murosimf::properties {
namespace {

constexpr std::array motion_entries{constant(joint_damping),
                                    constant(joint_armature),
                                    constant(joint_friction),
                                    constant(joint_stiffness),
                                    constant(joint_rate_limit),
                                    constant(joint_spring_reference),
                                    constant(joint_spring_slack),
                                    constant(joint_coupling),
                                    constant(joint_tendon),
                                    constant(spatial_tendon),
                                    constant(tendon_tie),
                                    constant(fixed_base),
                                    variable(joint_load),
                                    constant(loop_closure),
                                    constant(loop_commanded),
                                    variable(coupling_torque),
                                    variable(loop_force),
                                    variable(tie_force),
                                    variable(felt_acceleration),
                                    variable(sent_target),
                                    variable(sent_target_age),
                                    variable(filtered_target),
                                    variable(backlash_play),
                                    variable(backlash_side),
                                    variable(rotor_rate),
                                    variable(servo_position_gain),
                                    variable(servo_velocity_gain),
                                    variable(servo_torque_limit),
                                    variable(servo_feed_forward),
                                    variable(servo_led),
                                    variable(torque_need),
                                    variable(overload),
                                    variable(saturated_time),
                                    variable(watched_time),
                                    variable(cycle_target),
                                    variable(joint_offset),
                                    variable(catch_up_time),
                                    variable(base_quaternion),
                                    variable(robot_led),
                                    variable(total_mass),
                                    variable(common_center_of_mass),
                                    variable(common_center_of_mass_velocity),
                                    variable(common_inertia),
                                    variable(stance_pose),
                                    variable(stance_ground),
                                    variable(remaining_shift),
                                    variable(remaining_turn),
                                    variable(remaining_twist),
                                    variable(distance_walked),
                                    variable(falls),
                                    variable(lying),
                                    variable(distance_sample),
                                    variable(up_at_start),
                                    variable(written_position),
                                    variable(written_velocity)};

}  // namespace

std::span<const CatalogEntry> motion_list() { return motion_entries; }

}  // namespace murosimf::properties
