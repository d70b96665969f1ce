/// mjcf_context.h - what is known of an MJCF file before its bodies are read.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/io/mjcf_actuator.h"
#include "murosimf/io/mjcf_defaults.h"
#include "murosimf/io/mjcf_frame.h"
#include "murosimf/io/mjcf_mesh.h"
#include "murosimf/io/mjcf_names.h"
#include "murosimf/io/robot_draft.h"

namespace murosimf::io {

struct MjcfContext {
  const MjcfDefaults& defaults;
  const MjcfCompiler& compiler;
  const MjcfNames& names;
  const std::map<std::string, MjcfActuator>& actuators;  ///< by joint
  bool lenient = false;
  MjcfMeshes& meshes;
  std::vector<std::string>& warnings;
};

}  // namespace murosimf::io
