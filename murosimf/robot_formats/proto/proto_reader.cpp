#include "murosimf/robot_formats/proto/proto_reader.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/proto/proto_file.h"
#include "murosimf/robot_formats/proto/proto_schema.h"
#include "murosimf/robot_formats/proto/proto_walk.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr int year_of_new_axes = 2022;  // R2022a: cylinders along z, cameras look along x

/// The node of the PROTO, or the only Robot of a world.
const Node& robot_of(const ProtoFile& proto) {
  MUROSIMF_ASSERT(!proto.nodes.empty());
  if (!proto.name.empty()) return *proto.nodes[0];
  const Node* robot = nullptr;
  for (const NodePtr& node : proto.nodes) {
    if (node->type != "Robot") continue;
    if (robot) node->fail("a second Robot in this world; write the robot that you mean into a PROTO file of its own");
    robot = node.get();
  }
  if (!robot) proto.nodes[0]->fail("there is no PROTO in this file and no Robot at its top");
  return *robot;
}

}  // namespace

robot_formats::RobotDescription read_proto(const std::filesystem::path& file,
                                           const robot_formats::ReaderOptions& options) {
  const ProtoFile proto = read_proto_file(file, options.lenient);
  const Node& robot = robot_of(proto);
  if (!is_solid(robot.type)) {
    robot.fail(is_base_node(robot.type)
                   ? fmt::format("the PROTO is a {}, not a Robot or Solid", robot.type)
                   : fmt::format("the PROTO is a {0}, and there is no file {0}.proto beside", robot.type));
  }
  robot_formats::RobotDescription description;
  description.name = proto.name.empty() ? file.stem().string() : proto.name;
  description.file = file;
  ProtoLog log(description, options.lenient);
  for (const auto& [where, message] : proto.notes) log.note(where, message);
  const bool old = proto.year > 0 && proto.year < year_of_new_axes;
  if (old) {
    log.note(fmt::format("{}:1", file.string()),
             fmt::format("of Webots R{}: cylinders and capsules along y, cameras look along -z", proto.year));
  }
  MUROSIMF_ASSERT(description.bodies.empty());
  ProtoWalk(description, options, old, log).add_base(robot);
  return description;
}

}  // namespace murosimf::robot_formats::proto
