#include "murosimf/robot_formats/urdf/urdf_transmission.h"

#include <fmt/format.h>

#include "murosimf/robot_formats/urdf/urdf_sensor.h"

namespace murosimf::robot_formats::urdf {
namespace {

void name_reduction(const files::XmlElement& owner, UrdfLog& log) {
  for (const files::XmlElement& element : owner.children("mechanicalReduction")) {
    if (text_number(element) == 1) continue;
    log.unused(element, "transmission/mechanicalReduction",
               "gear ratios are not used: servos are described on the output side of their gears");
  }
}

}  // namespace

void read_transmissions(const files::XmlElement& robot, const UrdfTree& tree, UrdfLog& log) {
  for (const files::XmlElement& transmission : robot.children("transmission")) {
    const std::string name = transmission.attribute("name").value_or("");
    log.unused(transmission, "transmission", "element 'transmission' is not used");
    for (const files::XmlElement& joint : transmission.children("joint")) {
      const std::string joint_name = joint.attribute("name").value_or("");
      if (tree.find_joint(joint_name) < 0) {
        log.warn(joint, fmt::format("transmission '{}' speaks of joint '{}', which is not there", name, joint_name));
      }
      name_reduction(joint, log);
    }
    for (const files::XmlElement& actuator : transmission.children("actuator")) name_reduction(actuator, log);
  }
}

}  // namespace murosimf::robot_formats::urdf
