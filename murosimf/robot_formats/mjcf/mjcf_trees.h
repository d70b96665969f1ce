/// mjcf_trees.h - finds the trees of bodies in the world of an MJCF file, and those of the robot.
///
/// A floating tree begins with a body that has a free joint; all others are bolted to the world, and are one robot together: an arm
/// and its table, a planar walker on its rails. The robot is the one with the most joints, a floating tree or everything that is bolted; of
/// several floating trees with as many joints, the one with the most bodies, then the first. Bodies with `mocap` are never part of it:
/// software moves them.
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Name of the body that all bolted trees are attached to.
inline constexpr const char* world_name = "world";

/// A body of the world and everything attached to it.
struct MjcfTree {
  files::XmlElement body;
  std::string child_class;  ///< class that applies around it
  Transformd frame;         ///< of the frames around it, in the world
  bool floats = false, mocap = false;
  std::size_t joints = 0, bodies = 0;  ///< hinges, slides and balls
  bool of_robot = false;
};

struct MjcfTrees {
  std::vector<MjcfTree> all;  ///< in the order of the file
  bool bolted = false;        ///< the robot is attached to the world; otherwise it is one floating tree
};

/// `wanted`: a body of the robot, or world_name for everything that is bolted; empty: the rule above. Throws SetupError if no body can
/// be a robot, or if `wanted` does not exist. Other trees are lines in `unused`; that a robot is bolted, in `notes`.
[[nodiscard]] MjcfTrees find_trees(const files::XmlElement& root, const MjcfDefaults& defaults,
                                   const MjcfCompiler& compiler, const std::string& wanted,
                                   robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
