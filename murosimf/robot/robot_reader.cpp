#include "murosimf/robot/robot_reader.h"

#include <utility>

#include "murosimf/robot/lump_fixed_joints.h"
#include "murosimf/robot/mesh_up_axis.h"
#include "murosimf/robot/repair_solids.h"
#include "murosimf/robot/robot_builder.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/robot_formats.h"
#include "murosimf/robot/robot_heading.h"
#include "murosimf/robot/robot_sensors.h"
#include "murosimf/robot/role_inference.h"
#include "murosimf/robot/sensor_cuts.h"

namespace murosimf::robot {
namespace {

/// Materials of the table, by the bodies of the file.
void apply_surfaces(robot_formats::RobotDescription& description, const RobotConfig& table) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::ShapeDescription& shape : body.shapes) shape.placed.surface.material = table.surface(body.name);
  }
}

void apply_rate_limits(robot_formats::RobotDescription& description, const RobotConfig& table) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::JointDescription& joint : body.joints) {
      const auto found = table.rate_limits.find(joint.name);
      if (found != table.rate_limits.end()) joint.rate_limit = found->second.number;
    }
  }
}

/// To be called after welding, which makes frames of the links that a URDF file has for soles.
void apply_sole_sizes(robot_formats::RobotDescription& description, const RobotConfig& table) {
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::FrameDescription& frame : body.frames) {
      const auto found = table.sole_sizes.find(frame.name);
      if (found != table.sole_sizes.end()) frame.box = found->second.sole;
    }
  }
}

void check_names(const RobotConfig& table, const robot_formats::RobotDescription& description) {
  RobotNames names;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    names.bodies.push_back(body.name);
    for (const robot_formats::JointDescription& joint : body.joints) names.joints.push_back(joint.name);
    for (const robot_formats::FrameDescription& frame : body.frames) names.frames.push_back(frame.name);
  }
  for (const robot_formats::MeshDescription& mesh : description.meshes) names.meshes.push_back(mesh.name);
  check_names(table, names);
}

}  // namespace

RobotFile read_robot(const std::filesystem::path& file, const robot_formats::ReaderOptions& options) {
  RobotConfig table = read_table_beside(file);
  robot_formats::ReaderOptions all = options;
  for (const TableName& mesh : table.part_per_group) all.part_per_group.push_back(mesh.name);
  RobotFile robot;
  robot.description = read_description(file, all);
  check_names(table, robot.description);
  // Names are checked before welding, which removes bodies.
  apply_surfaces(robot.description, table);
  apply_rate_limits(robot.description, table);
  lump_fixed_joints(robot.description, find_cuts(robot.description, table));
  repair_solids(robot.description);
  turn_meshes_up(robot.description);
  apply_sole_sizes(robot.description, table);
  if (options.guess) guess_roles(robot.description, table);
  if (options.face_forward) face_forward(robot.description, table);
  place_soles(robot.description, table);
  robot.model = build_model(robot.description, table);
  // Every step below relies on the order of those above: welded, repaired, guessed, turned, placed.
  robot.sensors = sensors_of(robot.description, table, *robot.model, file.parent_path(), options.lenient);
  robot.warnings = std::move(robot.description.warnings);
  for (const robot_formats::Unused& unused : robot.description.unused) robot.notes.push_back(unused.line);
  robot.notes.insert(robot.notes.end(), robot.description.notes.begin(), robot.description.notes.end());
  robot.table = std::move(table);
  return robot;
}

}  // namespace murosimf::robot
