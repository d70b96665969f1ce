#include "murosimf/robot/robot_reader.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/formats/mjcf/mjcf_reader.h"
#include "murosimf/formats/urdf/urdf_reader.h"
#include "murosimf/robot/robot_builder.h"
#include "murosimf/robot/robot_roles.h"
#include "murosimf/robot/robot_sensors.h"
#include "murosimf/robot/robot_table.h"
#include "murosimf/robot/robot_weld.h"

namespace murosimf::robot {
namespace {

/// Materials of the table, by the bodies of the file.
void apply_surfaces(description::RobotDraft& draft, const RobotTable& table) {
  for (description::DraftBody& body : draft.bodies) {
    for (description::DraftShape& shape : body.shapes) shape.placed.surface.material = table.surface(body.name);
  }
}

void check_names(const RobotTable& table, const description::RobotDraft& draft) {
  RobotNames names;
  for (const description::DraftBody& body : draft.bodies) {
    names.bodies.push_back(body.name);
    for (const description::DraftJoint& joint : body.joints) names.joints.push_back(joint.name);
    for (const description::DraftFrame& frame : body.frames) names.frames.push_back(frame.name);
  }
  for (const description::DraftMesh& mesh : draft.meshes) names.meshes.push_back(mesh.name);
  check_names(table, names);
}

description::RobotDraft read_draft(const std::filesystem::path& file, const description::ReaderOptions& options) {
  const files::XmlFile xml(file);
  const std::string root = xml.root().tag();
  if (root == "mujoco") return formats::mjcf::read_mjcf(file, options);
  if (root == "robot") return formats::urdf::read_urdf(file, options);
  xml.root().fail(fmt::format("the root is <{}>; a robot file has <mujoco> (MJCF) or <robot> (URDF)", root));
}

}  // namespace

RobotFile read_robot(const std::filesystem::path& file, const description::ReaderOptions& options) {
  RobotTable table = read_table_beside(file);
  description::ReaderOptions all = options;
  for (const TableName& mesh : table.part_per_group) all.part_per_group.push_back(mesh.name);
  RobotFile robot;
  robot.draft = read_draft(file, all);
  check_names(table, robot.draft);
  apply_surfaces(robot.draft, table);
  weld_fixed_bodies(robot.draft);
  if (options.guess) guess_roles(robot.draft, table);
  place_soles(robot.draft, table);
  robot.model = build_model(robot.draft, table);
  robot.sensors = sensors_of(robot.draft, table, *robot.model, file.parent_path(), options.lenient);
  robot.warnings = std::move(robot.draft.warnings);
  robot.notes = std::move(robot.draft.notes);
  robot.table = std::move(table);
  return robot;
}

}  // namespace murosimf::robot
