/// mjcf_context.h - what is known of an MJCF file before its bodies are read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_actuator.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/mjcf/mjcf_material.h"
#include "murosimf/robot_formats/mjcf/mjcf_mesh.h"
#include "murosimf/robot_formats/mjcf/mjcf_names.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// What a joint says of its spring and damper instead of their numbers (mjcf_joint.h).
struct MjcfSpringDamper {
  std::string joint;
  double time = 0;   ///< [s] time constant
  double ratio = 0;  ///< [1] damping over the critical one
};

struct MjcfContext {
  const MjcfDefaults& defaults;
  const MjcfCompiler& compiler;
  const MjcfNames& names;
  const std::map<std::string, MjcfActuator>& actuators;  ///< by joint
  const MjcfMaterials& materials;
  bool lenient = false;
  MjcfMeshes& meshes;
  std::vector<std::string>&warnings, &notes;
  std::vector<MjcfSpringDamper>& springs;
};

}  // namespace murosimf::robot_formats::mjcf
