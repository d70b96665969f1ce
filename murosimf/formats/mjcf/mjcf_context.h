/// mjcf_context.h - what is known of an MJCF file before its bodies are read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/description/robot_description.h"
#include "murosimf/formats/mjcf/mjcf_actuator.h"
#include "murosimf/formats/mjcf/mjcf_defaults.h"
#include "murosimf/formats/mjcf/mjcf_frame.h"
#include "murosimf/formats/mjcf/mjcf_material.h"
#include "murosimf/formats/mjcf/mjcf_mesh.h"
#include "murosimf/formats/mjcf/mjcf_names.h"

namespace murosimf::formats::mjcf {

struct MjcfContext {
  const MjcfDefaults& defaults;
  const MjcfCompiler& compiler;
  const MjcfNames& names;
  const std::map<std::string, MjcfActuator>& actuators;  ///< by joint
  const MjcfMaterials& materials;
  bool lenient = false;
  MjcfMeshes& meshes;
  std::vector<std::string>& warnings;
};

}  // namespace murosimf::formats::mjcf
