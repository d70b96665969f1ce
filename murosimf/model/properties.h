/// properties.h - the catalogue: every property that the library knows, on one page.
///
/// "world" in the column `frame` means world axes; a moment or a linear velocity without further words is taken at
/// the origin of its object. Properties whose value is no row of numbers (contact sets, sightings) are declared
/// beside their type.
#pragma once

#include <span>

#include "murosimf/model/coupling.h"
#include "murosimf/model/property.h"
#include "murosimf/model/servo.h"
#include "murosimf/model/shape.h"
#include "murosimf/model/value.h"

namespace murosimf {

template <>
struct ValueTraits<Overload> : OfDoubles<Overload> {};  ///< needed, given, rate, time

}  // namespace murosimf

namespace murosimf::properties {

// clang-format off

// ---- constant: set while modelling (paper, table 2) ----
inline constexpr Property<double>   mass             {{"mass", "kg", "-", "mass of the object"}};
inline constexpr Property<Vec3d>    center_of_mass   {{"center_of_mass", "m", "object", "from the object's origin"}};
inline constexpr Property<SymMat3d> inertia          {{"inertia", "kg m^2", "object, at its center of mass", "xx yy zz xy xz yz"}};
inline constexpr Property<Shapes>   shapes           {{"shapes", "m", "object", "geometry with surface and color"}};
inline constexpr Property<Vec3d>    joint_range      {{"joint_range", "rad | m", "joint", "lowest, highest, 0"}};
inline constexpr Property<Servo>    servo            {{"servo", "-", "joint", "motor and gear that move the joint"}};
inline constexpr Property<double>   joint_damping    {{"joint_damping", "N m s/rad | N s/m", "joint", "viscous friction"}};
inline constexpr Property<double>   joint_armature   {{"joint_armature", "kg m^2 | kg", "joint", "inertia of the rotor behind the gear"}};
inline constexpr Property<double>   joint_friction   {{"joint_friction", "N m | N", "joint", "Coulomb friction"}};
inline constexpr Property<double>   joint_stiffness  {{"joint_stiffness", "N m/rad | N/m", "joint", "of a spring that acts whatever the servo does"}};
inline constexpr Property<double>   joint_spring_reference {{"joint_spring_reference", "rad | m", "joint", "position at which that spring is slack"}};
inline constexpr Property<JointCoupling> joint_coupling {{"joint_coupling", "-", "joint", "the joint that this one follows, and how"}};
inline constexpr Property<ExcludedPairs> excluded_pairs {{"excluded_pairs", "-", "-", "objects of the robot that never touch each other", Scope::base}};
inline constexpr Property<AllowedPairs> allowed_pairs {{"allowed_pairs", "-", "-", "shapes of the robot that touch each other whatever else forbids it", Scope::base}};
inline constexpr Property<Sole>     sole             {{"sole", "m", "object", "bottom of a foot, centered at the object"}};
inline constexpr Property<Markings> markings         {{"markings", "m", "object", "lines painted on the ground"}};

// ---- variable: added by the algorithms that need them (paper, table 3) ----
inline constexpr Property<Vec3d>  position           {{"position", "m", "world", "origin of the object"}};
inline constexpr Property<Mat3d>  orientation        {{"orientation", "1", "object axes to world axes", "rotation matrix, row by row"}};
inline constexpr Property<Vec3d>  linear_velocity    {{"linear_velocity", "m/s", "world", "of the object's origin"}};
inline constexpr Property<Vec3d>  angular_velocity   {{"angular_velocity", "rad/s", "world", "of the object"}};
inline constexpr Property<double> joint_position     {{"joint_position", "rad | m", "joint", "angle or shift along the axis"}};
inline constexpr Property<double> joint_velocity         {{"joint_velocity", "rad/s | m/s", "joint", "rate of joint_position"}};
inline constexpr Property<double> joint_target       {{"joint_target", "rad | m", "joint", "desired position, set by control software"}};
inline constexpr Property<double> joint_velocity_target {{"joint_velocity_target", "rad/s | m/s", "joint", "desired rate of a joint whose servo has no position gain, set by control software"}};
inline constexpr Property<double> joint_torque     {{"joint_torque", "N m | N", "joint", "of servo and gear; at full_dynamics what the motion would take"}};
inline constexpr Property<double> motor_torque     {{"motor_torque", "N m | N", "joint", "of the servo's motor alone, before its gear's friction"}};
inline constexpr Property<double> joint_load       {{"joint_load", "N m | N", "joint", "all that a joint feels besides its own servo, friction, damper, spring, coupling and end"}};
inline constexpr Property<double> coupling_torque  {{"coupling_torque", "N m | N", "joint", "on a joint that follows another one, by the coupling"}};
inline constexpr Property<Twistd> felt_acceleration {{"felt_acceleration", "rad/s^2, m/s^2", "world, at the base's origin", "of a link: what forces add to its gravity and velocity products"}};
inline constexpr Property<double> supply_voltage   {{"supply_voltage", "V", "joint", "of a servo, set by users or a battery; starts with the servo's own"}};
inline constexpr Property<double> torque_enabled   {{"torque_enabled", "1", "joint", "0: the servo's torque is switched off, nothing but friction brakes"}};
inline constexpr Property<double> servo_temperature {{"servo_temperature", "C", "joint", "of a servo's winding"}};
inline constexpr Property<double> sent_target      {{"sent_target", "rad | m", "joint", "target that went over the bus last"}};
inline constexpr Property<double> sent_target_age  {{"sent_target_age", "1", "joint", "steps since then"}};
inline constexpr Property<double> backlash_play    {{"backlash_play", "rad", "joint", "where the motor side is in the play of the gear; 0: in the middle"}};
inline constexpr Property<double> backlash_side    {{"backlash_side", "1", "joint", "1, -1: the motor side touches the output there; 0: it does not"}};
inline constexpr Property<double> rotor_rate       {{"rotor_rate", "rad/s", "joint", "of the motor side of a gear with backlash"}};
inline constexpr Property<double> torque_need      {{"torque_need", "N m | N", "joint", "joint_torque, smoothed over 20 ms"}};
inline constexpr Property<Overload> overload       {{"overload", "N m, N m, rad/s, s", "joint", "where torque_need exceeded the servo the most: needed, given, rate, time"}};
inline constexpr Property<double> cycle_target       {{"cycle_target", "rad | m", "joint", "target that the present control cycle runs to"}};
inline constexpr Property<Wrenchd> applied_force      {{"applied_force", "N, N m", "world, at the object's origin", "push on a body that stays until it is changed: force, moment"}};
inline constexpr Property<Wrenchd> interaction_force  {{"interaction_force", "N, N m", "world, at the object's origin", "contacts with other moving bodies: force, moment"}};
inline constexpr Property<Wrenchd> external_force     {{"external_force", "N, N m", "world, at the object's origin", "sum of pushes and contacts: force, moment"}};
inline constexpr Property<Sym6d>  external_damping   {{"external_damping", "N m s, N s, N s/m", "world, at the object's origin", "how fast external_force falls with the object's velocity"}};

// ---- variable: one for the whole entity ----
inline constexpr Property<Quaterniond> base_quaternion {{"base_quaternion", "1", "base axes to world axes", "w x y z", Scope::base}};
inline constexpr Property<double> total_mass         {{"total_mass", "kg", "-", "mass of all objects", Scope::base}};
inline constexpr Property<Vec3d>  common_center_of_mass {{"common_center_of_mass", "m", "world", "of all objects", Scope::base}};
inline constexpr Property<Vec3d>  common_center_of_mass_velocity {{"common_center_of_mass_velocity", "m/s", "world", "of all objects", Scope::base}};
inline constexpr Property<SymMat3d> common_inertia   {{"common_inertia", "kg m^2", "world, at the common center of mass", "xx yy zz xy xz yz", Scope::base}};
inline constexpr Property<Vec3d>  stance_pose        {{"stance_pose", "m, m, rad", "world", "x, y and heading of the standing sole", Scope::base}};
inline constexpr Property<double> stance_foot        {{"stance_foot", "1", "-", "0: first sole of the model stands, 1: second", Scope::base}};
inline constexpr Property<Vec3d>  remaining_shift    {{"remaining_shift", "m", "world", "of the base from its pinned place, since kinematic walking took over", Scope::base}};
inline constexpr Property<Vec3d>  remaining_turn     {{"remaining_turn", "rad", "world", "of the base from its pinned attitude, likewise, as rotation vector", Scope::base}};
inline constexpr Property<double> dynamic           {{"dynamic", "1", "-", "1: forces move the entity, 0: it pushes and is never pushed", Scope::base}};
inline constexpr Property<Vec3d>  separation         {{"separation", "m", "world, horizontal", "way in this step out of bodies that are not pushed either", Scope::base}};
inline constexpr Property<Wrenchd> absorbed_impulse   {{"absorbed_impulse", "N s, N m s", "world, at the world's origin", "what contacts gave to a body that cannot be pushed", Scope::base}};
inline constexpr Property<Vec3d>  walk_command       {{"walk_command", "m/s, m/s, rad/s", "robot, x forward", "desired walking velocity", Scope::base}};
inline constexpr Property<Vec3d>  gait_velocity      {{"gait_velocity", "m/s, m/s, rad/s", "robot, x forward", "walking velocity after the slew limits", Scope::base}};
inline constexpr Property<double> path_curvature     {{"path_curvature", "1/m", "-", "of the path that a car drives, positive to the left", Scope::base}};
inline constexpr Property<double> gait_phase         {{"gait_phase", "rad", "-", "0 to pi: left foot stands", Scope::base}};
inline constexpr Property<double> gait_amplitude     {{"gait_amplitude", "1", "-", "0 stands, 1 walks", Scope::base}};
inline constexpr Property<double> motion_time        {{"motion_time", "s", "-", "since the start of the key-frame motion", Scope::base}};
inline constexpr Property<Vec3d>  balance_up         {{"balance_up", "1", "sensor", "unit vector upward, as the controller that balances takes it", Scope::base}};
inline constexpr Property<Vec3d>  balance_upright    {{"balance_upright", "1", "sensor", "mean direction of gravity while the robot settled", Scope::base}};
inline constexpr Property<Vec3d>  balance_bias       {{"balance_bias", "rad/s", "sensor", "mean of the gyroscope while the robot settled", Scope::base}};
inline constexpr Property<double> balance_capture    {{"balance_capture", "rad", "-", "lean forward at which the robot would come to rest, smoothed", Scope::base}};
inline constexpr Property<Vec3d>  pose_estimate      {{"pose_estimate", "m, m, rad", "field", "x, y and heading of the robot as it takes them itself", Scope::base}};
inline constexpr Property<Vec3d>  pose_spread        {{"pose_spread", "m, m, rad", "field", "standard deviations of what the robot takes for possible poses", Scope::base}};
inline constexpr Property<double> next_waypoint      {{"next_waypoint", "1", "-", "of the way that the robot walks; 0: the first", Scope::base}};
inline constexpr Property<double> distance_walked    {{"distance_walked", "m", "world, horizontal", "length of the base's path, sampled twice a second", Scope::base}};
inline constexpr Property<double> falls              {{"falls", "1", "-", "how often the base tilted over 60 degrees", Scope::base}};
inline constexpr Property<double> lying              {{"lying", "1", "-", "1 while the base leans over after a fall", Scope::base}};
inline constexpr Property<Vec3d>  distance_sample    {{"distance_sample", "m", "world", "place of the last sample of distance_walked", Scope::base}};
inline constexpr Property<Vec3d>  up_at_start        {{"up_at_start", "1", "base", "axis of the base that pointed up at the start", Scope::base}};
inline constexpr Property<Vec3d>  written_position   {{"written_position", "m", "world", "base position as its level left it", Scope::base}};
inline constexpr Property<Vec3d>  written_velocity   {{"written_velocity", "m/s", "world", "base velocity as its level left it", Scope::base}};

// clang-format on

/// Where a property lives, for the list that people read.
struct CatalogEntry {
  PropertyInfo info;
  bool constant = false;
};

/// Every property of this page, constant ones first.
[[nodiscard]] std::span<const CatalogEntry> catalog();

}  // namespace murosimf::properties
