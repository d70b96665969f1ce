/// motion_properties.h - properties that levels of detail keep for themselves, and quantities of an entity as a whole.
///
/// Frames as in model/properties.h: "world" means world axes.
#pragma once

#include <span>

#include "murosimf/model/coupling.h"
#include "murosimf/model/property.h"
#include "murosimf/model/servo.h"
#include "murosimf/model/value.h"
#include "murosimf/multibody/loops.h"

namespace murosimf {

template <>
struct ValueTraits<Overload> : OfDoubles<Overload> {};  ///< needed, given, rate, time

}  // namespace murosimf

namespace murosimf::properties {

// clang-format off

// ---- constant: of joints ----
inline constexpr Property<double>   joint_damping    {{"joint_damping", "N m s/rad | N s/m", "joint", "viscous friction"}};
inline constexpr Property<double>   joint_armature   {{"joint_armature", "kg m^2 | kg", "joint", "inertia of the rotor behind the gear"}};
inline constexpr Property<double>   joint_friction   {{"joint_friction", "N m | N", "joint", "Coulomb friction"}};
inline constexpr Property<double>   joint_stiffness  {{"joint_stiffness", "N m/rad | N/m", "joint", "of a spring that acts whatever the servo does"}};
inline constexpr Property<double>   joint_rate_limit {{"joint_rate_limit", "rad/s | m/s", "joint", "largest rate to which it is driven; 0: none"}};
inline constexpr Property<double>   joint_spring_reference {{"joint_spring_reference", "rad | m", "joint", "position at which that spring is slack"}};
inline constexpr Property<JointCoupling> joint_coupling {{"joint_coupling", "-", "joint", "the joint that this one follows, and how"}};

// ---- variable: of every object ----
inline constexpr Property<double> joint_load       {{"joint_load", "N m | N", "joint", "all that a joint feels besides its own servo, friction, damper, spring, coupling and end"}};
inline constexpr Property<double> coupling_torque  {{"coupling_torque", "N m | N", "joint", "on a joint that follows another one, by the coupling"}};
inline constexpr Property<double> tie_force        {{"tie_force", "N", "joint", "on the slider of a tendon that is tied to another one, by the tie"}};
inline constexpr Property<Wrenchd> loop_force     {{"loop_force", "N, N m", "world, where the loop closes", "on the frame that closes a loop (loop_closure), by the other one"}};
inline constexpr Property<Twistd> felt_acceleration {{"felt_acceleration", "rad/s^2, m/s^2", "world, at the base's origin", "of a link: what forces add to its gravity and velocity products"}};
inline constexpr Property<double> sent_target      {{"sent_target", "rad | m", "joint", "target that went over the bus last"}};
inline constexpr Property<double> sent_target_age  {{"sent_target_age", "1", "joint", "steps since then"}};
inline constexpr Property<double> filtered_target  {{"filtered_target", "rad | m", "joint", "what the filter of a servo (command_filter) has come to"}};
inline constexpr Property<double> backlash_play    {{"backlash_play", "rad", "joint", "where the motor side is in the play of the gear; 0: in the middle"}};
inline constexpr Property<double> backlash_side    {{"backlash_side", "1", "joint", "1, -1: the motor side touches the output there; 0: it does not"}};
inline constexpr Property<double> rotor_rate       {{"rotor_rate", "rad/s", "joint", "of the motor side of a gear with backlash"}};
inline constexpr Property<double> servo_position_gain {{"servo_position_gain", "N m/rad", "joint", "of a servo, set by control software that asks for it; starts with the servo's own"}};
inline constexpr Property<double> servo_velocity_gain {{"servo_velocity_gain", "N m s/rad", "joint", "likewise"}};
inline constexpr Property<double> servo_torque_limit {{"servo_torque_limit", "N m", "joint", "likewise, of the motor; its stall torque: none"}};
inline constexpr Property<double> servo_feed_forward {{"servo_feed_forward", "N m", "joint", "torque that a servo adds to that of its gains, set by control software that asks for it"}};
inline constexpr Property<double> servo_led        {{"servo_led", "1", "joint", "brightness of the LED at a servo, 0 to 1, set by control software"}};
inline constexpr Property<double> torque_need      {{"torque_need", "N m | N", "joint", "joint_torque, smoothed over 20 ms"}};
inline constexpr Property<Overload> overload       {{"overload", "N m, N m, rad/s, s", "joint", "where torque_need exceeded the servo the most: needed, given, rate, time"}};
inline constexpr Property<double> saturated_time  {{"saturated_time", "s", "joint", "how long its servo has given all that it has, since its level began"}};
inline constexpr Property<double> cycle_target       {{"cycle_target", "rad | m", "joint", "target that the present control cycle runs to"}};
inline constexpr Property<double> joint_offset     {{"joint_offset", "rad | m", "joint", "what is left of its way from its reference when a level without servos took it over", Scope::object, true}};

// ---- variable: one for the whole entity ----
inline constexpr Property<double> joint_reference_kind {{"joint_reference_kind", "1", "-", "of a level without servos: 1 filter, 2 linear, 3 exact; nothing else is one", Scope::wiring}};
inline constexpr Property<double> watched_time     {{"watched_time", "s", "-", "in which saturated_time was counted", Scope::base}};
inline constexpr Property<double> catch_up_time    {{"catch_up_time", "s", "-", "left of the second in which joints that a level without servos took over are no faster than their servos", Scope::base, true}};
inline constexpr Property<Quaterniond> base_quaternion {{"base_quaternion", "1", "base axes to world axes", "w x y z", Scope::base}};
inline constexpr Property<Vec3d>  robot_led          {{"robot_led", "1", "red, green, blue", "brightness of the robot's LED, 0 to 1 each, set by control software", Scope::base}};
inline constexpr Property<double> total_mass         {{"total_mass", "kg", "-", "mass of all objects", Scope::base}};
inline constexpr Property<Vec3d>  common_center_of_mass {{"common_center_of_mass", "m", "world", "of all objects", Scope::base}};
inline constexpr Property<Vec3d>  common_center_of_mass_velocity {{"common_center_of_mass_velocity", "m/s", "world", "of all objects", Scope::base}};
inline constexpr Property<SymMat3d> common_inertia   {{"common_inertia", "kg m^2", "world, at the common center of mass", "xx yy zz xy xz yz", Scope::base}};
inline constexpr Property<Vec3d>  stance_pose        {{"stance_pose", "m, m, rad", "world", "x, y and heading of the standing sole", Scope::base}};
inline constexpr Property<Vec3d>  stance_ground      {{"stance_ground", "m, 1, 1", "world", "ground below the standing sole: height, dz/dx, dz/dy", Scope::base, true}};
inline constexpr Property<Vec3d>  remaining_shift    {{"remaining_shift", "m", "world", "of the standing sole from its place on the ground at kinematic_walking, until it has faded", Scope::base}};
inline constexpr Property<Vec3d>  remaining_turn     {{"remaining_turn", "rad", "world", "of the standing sole from lying flat, likewise, as rotation vector", Scope::base}};
inline constexpr Property<Twistd>   remaining_twist    {{"remaining_twist", "rad/s, m/s", "world, at the sole", "what is left of the standing sole's motion when it landed or kinematic_walking took over", Scope::base, true}};
inline constexpr Property<double> distance_walked    {{"distance_walked", "m", "world, horizontal", "length of the base's path, sampled twice a second", Scope::base}};
inline constexpr Property<double> falls              {{"falls", "1", "-", "how often the base tilted over 60 degrees", Scope::base}};
inline constexpr Property<double> lying              {{"lying", "1", "-", "1 while the base leans over after a fall", Scope::base}};
inline constexpr Property<Vec3d>  distance_sample    {{"distance_sample", "m", "world", "place of the last sample of distance_walked", Scope::base}};
inline constexpr Property<Vec3d>  up_at_start        {{"up_at_start", "1", "base", "axis of the base that pointed up at the start", Scope::base}};
inline constexpr Property<Vec3d>  written_position   {{"written_position", "m", "world", "base position as its level left it", Scope::base}};
inline constexpr Property<Vec3d>  written_velocity   {{"written_velocity", "m/s", "world", "base velocity as its level left it", Scope::base}};

// clang-format on

/// Every property of this page, constant ones first.
[[nodiscard]] std::span<const CatalogEntry> motion_list();

}  // namespace murosimf::properties
