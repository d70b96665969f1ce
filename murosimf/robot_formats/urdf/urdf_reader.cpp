#include "murosimf/robot_formats/urdf/urdf_reader.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/urdf_gazebo.h"
#include "murosimf/robot_formats/urdf/urdf_inertial.h"
#include "murosimf/robot_formats/urdf/urdf_joint.h"
#include "murosimf/robot_formats/urdf/urdf_schema.h"
#include "murosimf/robot_formats/urdf/urdf_shape.h"
#include "murosimf/robot_formats/urdf/urdf_transmission.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

/// Settings of a `mujoco` block.
struct Compiler {
  std::optional<std::string> mesh_folder;
  bool strip_path = true;  // MuJoCo's default for URDF
  bool balance = false;
};

bool flag(const files::XmlElement& element, const char* name, bool fallback) {
  const std::string text = element.attribute(name).value_or(fallback ? "true" : "false");
  if (text != "true" && text != "false") element.fail(fmt::format("{} is '{}'; write true or false", name, text));
  return text == "true";
}

Compiler read_compiler(const files::XmlElement& robot) {
  Compiler compiler;
  for (const files::XmlElement& mujoco : robot.children("mujoco")) {
    for (const files::XmlElement& element : mujoco.children("compiler")) {
      if (const auto folder = element.attribute("meshdir")) compiler.mesh_folder = *folder;
      compiler.strip_path = flag(element, "strippath", compiler.strip_path);
      compiler.balance = flag(element, "balanceinertia", compiler.balance);
    }
  }
  return compiler;
}

void check_root(const files::XmlElement& robot) {
  if (robot.tag() != "robot") {
    robot.fail(fmt::format("the root is <{}>, not <robot>; this is no URDF file", robot.tag()));
  }
  refuse_xacro(robot);
}

UrdfMeshPaths mesh_paths(const std::filesystem::path& file, const robot_formats::ReaderOptions& options,
                         const Compiler& compiler) {
  UrdfMeshPaths paths(file, options.packages, options.search_paths);
  if (compiler.mesh_folder) paths.also_look_in(*compiler.mesh_folder, compiler.strip_path);
  return paths;
}

bool is_fixed(const UrdfTree& tree, int joint) { return tree.joints[joint].type == "fixed"; }

robot_formats::BodyDescription read_body(const UrdfLink& link, bool balance, UrdfLog& log) {
  robot_formats::BodyDescription body;
  body.name = link.name;
  body.where = link.element.where();
  body.solid = read_inertial(link, balance, log);
  if (const auto inertial = only_child(link.element, "inertial")) body.solid_where = inertial->where();
  return body;
}

/// Reads bodies in the order of the tree; `number` of a link is that of its body.
void read_bodies(const UrdfTree& tree, bool balance, UrdfShapes& shapes, robot_formats::RobotDescription& description,
                 UrdfLog& log) {
  std::vector<int> number(tree.links.size());
  for (const int index : tree.order) {
    const UrdfLink& link = tree.links[index];
    number[index] = static_cast<int>(description.bodies.size());
    robot_formats::BodyDescription body = read_body(link, balance, log);
    shapes.add(link.element, body);
    if (index != tree.order[0]) {
      const UrdfJoint& joint = tree.joints[link.joint];
      MUROSIMF_ASSERT(number[joint.parent] < number[index]);
      body.parent = number[joint.parent];
      body.place = read_place(joint);
      if (!is_fixed(tree, link.joint)) body.joints.push_back(read_joint(joint, log));
    }
    description.bodies.push_back(std::move(body));
  }
  MUROSIMF_ASSERT(description.bodies.size() == tree.order.size());
}

robot_formats::RobotDescription read_root(const std::filesystem::path& file, const files::XmlElement& robot,
                                          const robot_formats::ReaderOptions& options) {
  check_root(robot);
  robot_formats::RobotDescription description;
  description.name = robot.attribute("name").value_or(file.stem().string());
  description.file = file;
  constexpr auto named = files::UnknownWords::named;
  for (auto& [word, line] : files::validate(robot, urdf_schema(), options.lenient, description.warnings, named)) {
    description.unused.push_back({std::move(word), std::move(line)});
  }
  UrdfLog log(description, options.lenient);
  const UrdfTree tree = read_tree(robot, log);
  description.fixed_base = tree.bolted;
  const Compiler compiler = read_compiler(robot);
  UrdfMeshes meshes(mesh_paths(file, options, compiler), options.part_per_group, description, log);
  UrdfShapes shapes(read_paints(robot), std::move(meshes), log);
  // Couplings, blocks and transmissions refer to bodies and joints.
  read_bodies(tree, compiler.balance, shapes, description, log);
  description.mimics = read_mimics(tree, log);
  read_gazebo(robot, tree, description, log);
  read_transmissions(robot, tree, log);
  return description;
}

}  // namespace

robot_formats::RobotDescription read_urdf(const std::filesystem::path& file,
                                          const robot_formats::ReaderOptions& options) {
  return read_root(file, files::XmlFile(file).root(), options);
}

robot_formats::RobotDescription read_urdf_text(const std::filesystem::path& file, const std::string& text,
                                               const robot_formats::ReaderOptions& options) {
  return read_root(file, files::XmlFile(file, text).root(), options);
}

}  // namespace murosimf::robot_formats::urdf
