/// proto_walk.h - visits the nodes of a robot and makes bodies of them.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "murosimf/robot_formats/proto/proto_geometry.h"
#include "murosimf/robot_formats/proto/proto_log.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::proto {

class ProtoWalk {
 public:
  /// `old`: the file is of a Webots before R2022a.
  ProtoWalk(robot_formats::RobotDescription& description, const robot_formats::ReaderOptions& options, bool old,
            ProtoLog& log)
      : description_(description), log_(log), geometry_(description, options, old, log), old_(old) {}

  /// Adds the Robot or Solid at the top.
  void add_base(const Node& robot);

 private:
  /// Place of nodes: the body, and the frame on it.
  struct Spot {
    int body = 0;
    Placing at;
  };

  [[nodiscard]] int begin_body(const Node& solid);
  void fill_body(const Node& solid, int number);
  void add_masses(const Node& solid, robot_formats::BodyDescription& body);
  void add_children(const Node& parent, const Spot& spot);
  void add_child(const Node& child, const Spot& spot);
  void add_device(const Node& device, const Spot& spot);
  void add_fixed(const Node& solid, const Spot& spot);
  void add_joint(const Node& joint, const Spot& spot);
  void add_joint_devices(const Node& joint, int body);
  void check_scale(const Node& node, const Spot& spot);
  [[nodiscard]] std::string free_name(std::set<std::string>& taken, const std::string& name) const;

  robot_formats::RobotDescription& description_;
  ProtoLog& log_;
  ProtoGeometry geometry_;
  std::set<std::string> bodies_, joints_;  ///< names
  bool old_;
};

}  // namespace murosimf::robot_formats::proto
