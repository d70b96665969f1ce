/// sdf_assembly.h - assembles the bodies, joints, loops, frames and sensors of a model in an SDF file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/robot_formats/sdf/sdf_joint.h"
#include "murosimf/robot_formats/sdf/sdf_link.h"
#include "murosimf/robot_formats/sdf/sdf_tree.h"

namespace murosimf::robot_formats::sdf {

class SdfAssembly {
 public:
  SdfAssembly(const SdfModel& model, const SdfPoses& poses, const robot_formats::ReaderOptions& options,
              robot_formats::RobotDescription& description, urdf::UrdfLog& log)
      : model_(model), poses_(poses), description_(description), log_(log), links_(options, description, log) {}

  /// Throws SetupError: no links, joints between unknown links, links without a joint, unknown types of joints.
  void assemble();

 private:
  void find_links();
  void find_joints();
  void add_body(const SdfNode& node);
  void add_loop(const SdfPart& joint);
  void add_connect(const SdfPart& joint, const std::string& name, const Transformd& place, bool welded);
  void add_frames();
  void add_sensors();
  [[nodiscard]] int number_of(const std::string& link) const;
  [[nodiscard]] Transformd place_of(const SdfNode& node) const;
  [[nodiscard]] int body_of(const std::string& link) const;

  const SdfModel& model_;
  const SdfPoses& poses_;
  robot_formats::RobotDescription& description_;
  urdf::UrdfLog& log_;
  SdfLinks links_;
  std::vector<SdfPart> used_links_, used_joints_;
  std::map<std::string, int> numbers_;  ///< of used links, by name
  std::vector<SdfEdge> edges_;          ///< of used joints
  SdfTree tree_;
};

}  // namespace murosimf::robot_formats::sdf
