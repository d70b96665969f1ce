/// mjcf_body.h - bodies of an MJCF file as chains of the seven basic objects.
///
/// A body becomes translation (<body>.offset), rotation (<body>.turn) and its joints; what is the identity is left
/// out. A joint away from the body's origin has a translation before (<joint>.anchor) and its inverse behind. The
/// last of these objects has the body's frame and carries its mass and shapes; it has the body's name, as an alias if
/// it is a joint. Child bodies and sites follow as branches of a fork; a site ends in an endpoint of its name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/io/mjcf_defaults.h"
#include "murosimf/io/mjcf_frame.h"
#include "murosimf/io/mjcf_mesh.h"
#include "murosimf/io/mjcf_names.h"
#include "murosimf/io/robot_table.h"
#include "murosimf/model/chain.h"

namespace murosimf::io {

/// What is known of the file before the bodies are built.
struct MjcfContext {
  const MjcfDefaults& defaults;
  const MjcfCompiler& compiler;
  const MjcfNames& names;
  const RobotTable& table;
  const std::map<std::string, Servo>& servos;  ///< from the actuators
  bool lenient = false;
  MjcfMeshes& meshes;
  std::vector<std::string>& warnings;
};

/// The whole robot, from the body with the free joint on. Its place in the file is left out: the scene places robots.
[[nodiscard]] Chain build_robot(const XmlElement& base, const std::string& child_class, const MjcfContext& context);

/// True for `freejoint` and for a joint of type free.
[[nodiscard]] bool is_free_joint(const XmlElement& joint, const std::string& child_class, const MjcfDefaults& defaults);

}  // namespace murosimf::io
