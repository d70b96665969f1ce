/// conversion_additions.h - what a robot's own file need not say, and what another simulator has to be told: its drives, its soles, which
/// of its bodies overlap as they stand, and how it stands.
#pragma once

#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Joints that the file gives no actuator get that of the table or what was guessed, as a position servo: gain, damping (of a DC motor that
/// of its speed-torque line, stall torque over no-load rate), largest torque, rotor, friction; its targets are held to the joint's range. Others
/// get the table's gain. `robot`: the same file, read whole. Source of the damping: motion/servo_law.h.
void give_servos(robot_formats::RobotDescription& description, const RobotFile& robot);

/// Masses and inertias that were repaired (repair_solids.h), with all of what is welded to the body, become those of the body; what is welded
/// to it then has none. `description`: bodies of the same file, not welded.
void take_repaired_solids(robot_formats::RobotDescription& description, const RobotFile& robot);

/// Soles that were guessed as box sites: the file that is written needs no guess.
void give_soles(robot_formats::RobotDescription& description, RobotFile& robot);

/// Bodies that are no neighbors and overlap in the pose of the file never touch each other here
/// (collision/inner_pairs.h); another simulator would push them apart.
void exclude_overlaps(robot_formats::RobotDescription& description);

/// A key `stand` if the file has none: the pose of the file, the lowest point of all shapes on the ground.
void give_key(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
