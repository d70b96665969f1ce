/// urdf_tree.h - links and joints of a URDF file as a tree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"

namespace murosimf::robot_formats::urdf {

struct UrdfLink {
  std::string name;
  files::XmlElement element;
  int joint = -1;               ///< to its parent; -1: none
  std::vector<int> children{};  ///< joints below it, as in the file
};

struct UrdfJoint {
  std::string name;
  std::string type;  ///< revolute, continuous, prismatic or fixed; floating only above the base
  files::XmlElement element;
  int parent = -1, child = -1;  ///< links
  double held_at = 0;           ///< [rad | m] position of a joint that is fixed because both of its limits are this
};

struct UrdfTree {
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::vector<int> order;  ///< links of the robot from the base on, parents first, branches as in the file
  bool bolted = false;     ///< the root is the world

  /// Index, -1 if there is none.
  [[nodiscard]] int find_link(std::string_view name) const;
  [[nodiscard]] int find_joint(std::string_view name) const;
};

/// Reads the tree. A joint with equal limits is fixed there, with a warning. An empty link above a floating joint stands for the
/// world and is not part of the robot; an empty root called "world" is the base of a robot that is bolted to it. Throws SetupError if
/// links and joints form no tree, for missing and double names, and for planar joints and floating ones inside the robot.
[[nodiscard]] UrdfTree read_tree(const files::XmlElement& robot, UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
