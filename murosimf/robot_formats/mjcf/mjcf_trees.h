/// mjcf_trees.h - the trees of bodies in the world of an MJCF file, and which of them are the robot.
///
/// A tree that floats begins with a body that has a free joint; all others are bolted to the world, and are one robot together: an arm
/// and its table, a planar walker on its rails. The robot is what has the most joints, a tree that floats or all that is bolted; of
/// several trees that float and have as many, the one with the most bodies, then the first. Bodies with `mocap` are never of it:
/// software moves them.
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Of the body that all bolted trees hang on.
inline constexpr const char* world_name = "world";

/// A body of the world and all that hangs on it.
struct MjcfTree {
  files::XmlElement body;
  std::string child_class;  ///< that holds around it
  Transformd frame;         ///< of the frames around it, in the world
  bool floats = false, mocap = false;
  std::size_t joints = 0, bodies = 0;  ///< hinges, slides and balls
  bool of_robot = false;
};

struct MjcfTrees {
  std::vector<MjcfTree> all;  ///< in the order of the file
  bool bolted = false;        ///< the robot hangs on the world; else it is one tree that floats
};

/// `wanted`: a body of the robot, or world_name for what is bolted; empty: the rule above. Throws SetupError if there is no body that can
/// be a robot, or no such one. What is left out is a line in `unused`; that a robot is bolted, in `notes`.
[[nodiscard]] MjcfTrees find_trees(const files::XmlElement& root, const MjcfDefaults& defaults,
                                   const MjcfCompiler& compiler, const std::string& wanted,
                                   robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
