/// mjcf_context.h - data of an MJCF file that its bodies depend on.
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

/// Spring and damper of a joint by time constant and damping ratio instead of their numbers (mjcf_joint.h).
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
