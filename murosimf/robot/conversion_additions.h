/// conversion_additions.h - data that a robot's own file may omit, but that another simulator needs: drives, soles,
/// exclusions of bodies that overlap in the pose of the file, and a pose to start from.
#pragma once

#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Joints without an actuator in the file get that of the table, or the guessed one, as a position servo: gain, damping (for a DC motor
/// that of its speed-torque line, stall torque over no-load rate), largest torque, rotor, friction; its targets are limited to the joint's
/// range. Others get the table's gain. `robot`: the same file as read_robot reads it. Source of the damping: dynamics/servo/servo_law.h.
void give_servos(robot_formats::RobotDescription& description, const RobotFile& robot);

/// Masses and inertias that were repaired (repair_solids.h), with those of all parts that are welded to the body, become those of the body;
/// the parts then have none. `description`: bodies of the same file, not welded.
void take_repaired_solids(robot_formats::RobotDescription& description, const RobotFile& robot);

/// Guessed soles as box sites: the written file needs no guess.
void give_soles(robot_formats::RobotDescription& description, RobotFile& robot);

/// Excludes bodies that are no neighbors and overlap in the pose of the file: here they never touch each other
/// (collision/inner_pairs.h); another simulator would push them apart.
void exclude_overlaps(robot_formats::RobotDescription& description);

/// A key `stand` if the file has none: the pose of the file, with the lowest point of all shapes on the ground.
void give_key(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
