/// properties.h - the properties that independent folders share: the contents of a model, the poses of its
/// bodies, the state of its joints and servos.
///
/// Every other folder declares its own beside what uses them: collision/contact_properties.h,
/// dynamics/motion_properties.h, locomotion/gait_properties.h, soccer/behavior_properties.h. All of them are in the namespace
/// `properties`, and catalog/property_catalog.h has the list of all.
///
/// "world" in the column `frame` means world axes; a moment or a linear velocity without further words is taken at
/// the origin of its object. Properties whose value is no row of numbers (contact sets, sightings) are declared
/// beside their type.
#pragma once

#include <span>

#include "murosimf/model/constants.h"
#include "murosimf/model/property.h"
#include "murosimf/model/servo.h"
#include "murosimf/model/shape.h"
#include "murosimf/model/value.h"

namespace murosimf {

// Made once, in properties.cpp.
extern template class ConstantColumn<Shapes>;
extern template class ConstantColumn<Servo>;
extern template class ConstantColumn<Sole>;
extern template class ConstantColumn<Markings>;

}  // namespace murosimf

namespace murosimf::properties {

// clang-format off

// ---- constant: set while modelling (paper, table 2) ----
inline constexpr Property<double>   mass             {{"mass", "kg", "-", "mass of the object"}};
inline constexpr Property<Vec3d>    center_of_mass   {{"center_of_mass", "m", "object", "from the object's origin"}};
inline constexpr Property<SymMat3d> inertia          {{"inertia", "kg m^2", "object, at its center of mass", "xx yy zz xy xz yz"}};
inline constexpr Property<Shapes>   shapes           {{"shapes", "m", "object", "geometry with surface and color"}};
inline constexpr Property<Vec3d>    joint_range      {{"joint_range", "rad | m", "joint", "lowest, highest, 0"}};
inline constexpr Property<Vec3d>    joint_target_range {{"joint_target_range", "rad | m", "joint", "lowest and highest target that its servo takes, 0; of a servo without position gain rates"}};
inline constexpr Property<double>   joint_start      {{"joint_start", "rad | m", "joint", "position at the start, where nothing else is asked for; missing: 0"}};
inline constexpr Property<Servo>    servo            {{"servo", "-", "joint", "motor and gear that move the joint"}};
inline constexpr Property<Sole>     sole             {{"sole", "m", "object", "bottom of a foot, centered at the object"}};
inline constexpr Property<Markings> markings         {{"markings", "m", "object", "lines painted on the ground"}};

// ---- variable: added by the algorithms that need them (paper, table 3) ----
inline constexpr Property<Vec3d>  position           {{"position", "m", "world", "origin of the object"}};
inline constexpr Property<Mat3d>  orientation        {{"orientation", "1", "object axes to world axes", "rotation matrix, row by row"}};
inline constexpr Property<Vec3d>  linear_velocity    {{"linear_velocity", "m/s", "world", "of the object's origin"}};
inline constexpr Property<Vec3d>  angular_velocity   {{"angular_velocity", "rad/s", "world", "of the object"}};
inline constexpr Property<double> joint_position     {{"joint_position", "rad | m", "joint", "angle or shift along the axis"}};
inline constexpr Property<double> joint_velocity         {{"joint_velocity", "rad/s | m/s", "joint", "rate of joint_position"}};
inline constexpr Property<Vec3d>  linear_acceleration  {{"linear_acceleration", "m/s^2", "world", "of the object's origin, mean over the last step", Scope::shown}};
inline constexpr Property<Vec3d>  angular_acceleration {{"angular_acceleration", "rad/s^2", "world", "of the object, mean over the last step", Scope::shown}};
inline constexpr Property<double> joint_acceleration   {{"joint_acceleration", "rad/s^2 | m/s^2", "joint", "rate of joint_velocity, mean over the last step", Scope::shown}};
inline constexpr Property<double> joint_target       {{"joint_target", "rad | m", "joint", "desired position, set by control software"}};
inline constexpr Property<double> joint_velocity_target {{"joint_velocity_target", "rad/s | m/s", "joint", "desired rate of a joint whose servo has no position gain, set by control software"}};
inline constexpr Property<double> joint_torque     {{"joint_torque", "N m | N", "joint", "of servo and gear; at full_dynamics what the motion would take"}};
inline constexpr Property<double> motor_torque     {{"motor_torque", "N m | N", "joint", "of the servo's motor alone, before its gear's friction"}};
inline constexpr Property<double> supply_voltage   {{"supply_voltage", "V", "joint", "of a servo, set by users or a battery; starts with the servo's own"}};
inline constexpr Property<double> torque_enabled   {{"torque_enabled", "1", "joint", "0: the servo's torque is switched off, nothing but friction brakes"}};
inline constexpr Property<double> servo_temperature {{"servo_temperature", "C", "joint", "of a servo's winding"}};
inline constexpr Property<double> step_ratio       {{"step_ratio", "1", "-", "length of the next step of motion and contact, over that of the scene's", Scope::base}};

// clang-format on

/// Every property of this page and `visuals` (visual_mesh.h).
[[nodiscard]] std::span<const CatalogEntry> core_list();

}  // namespace murosimf::properties
