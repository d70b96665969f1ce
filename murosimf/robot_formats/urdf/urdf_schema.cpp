#include "murosimf/robot_formats/urdf/urdf_schema.h"

#include <fmt/format.h>

namespace murosimf::robot_formats::urdf {
namespace {

void add_link_rules(files::XmlVocabulary& rules) {
  rules["link"] = {.used = {"name"},
                   .unused = {"type"},
                   .children = {"inertial", "visual", "collision", "contact"},
                   .unused_children = {"self_collision_checking", "sensor", "origin"}};
  // Elements of Bullet.
  rules["contact"] = {.children = {"lateral_friction"},
                      .unused_children = {"rolling_friction", "spinning_friction", "restitution", "stiffness",
                                          "damping", "contact_cfm", "contact_erp", "inertia_scaling",
                                          "friction_anchor"}};
  rules["lateral_friction"] = {.used = {"value"}};
  rules["inertial"] = {.children = {"origin", "mass", "inertia"}};
  rules["mass"] = {.used = {"value"}};
  rules["inertia"] = {.used = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz", "iyx", "izx", "izy"}};
  rules["origin"] = {.used = {"xyz", "rpy"}, .unsupported = {"quat_xyzw"}};
  rules["visual"] = {.used = {"name"}, .children = {"origin", "geometry", "material"}, .unused_children = {"meta"}};
  rules["collision"] = {.used = {"name"},
                        .unused = {"group"},
                        .children = {"origin", "geometry"},
                        .unused_children = {"verbose", "material", "contact_coefficients"}};
  rules["geometry"] = {.children = {"box", "cylinder", "sphere", "capsule", "mesh"},
                       .unsupported_children = {"ellipsoid", "plane", "polyline", "heightmap"},
                       .all_act = true};
  rules["box"] = {.used = {"size"}, .unused = {"scale"}};
  rules["cylinder"] = {.used = {"radius", "length"}};
  rules["capsule"] = {.used = {"radius", "length"}};
  rules["sphere"] = {.used = {"radius"}};
  rules["mesh"] = {.used = {"filename", "scale"}};
  rules["material"] = {.used = {"name"}, .children = {"color", "texture"}};
  rules["texture"] = {.used = {"filename"}};
  rules["color"] = {.used = {"rgba"}};
}

void add_joint_rules(files::XmlVocabulary& rules) {
  rules["joint"] = {.used = {"name", "type"},
                    .children = {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"},
                    .unused_children = {"safety_controller", "calibration"},
                    .unsupported_children = {"joint_properties"}};
  rules["parent"] = {.used = {"link"}};
  rules["child"] = {.used = {"link"}};
  rules["axis"] = {.used = {"xyz"}};
  rules["limit"] = {.used = {"lower", "upper", "effort", "velocity"}, .unused = {"acceleration", "jerk"}};
  rules["dynamics"] = {.used = {"damping", "friction"},
                       .unsupported = {"stiffness", "spring_stiffness", "spring_reference", "armature"}};
  rules["mimic"] = {.used = {"joint", "multiplier", "offset"}};
}

files::XmlVocabulary make_rules() {
  files::XmlVocabulary rules;
  rules["robot"] = {.used = {"name"},
                    .unused = {"version"},
                    .children = {"link", "joint", "material", "transmission", "gazebo", "mujoco"},
                    .unused_children = {"ros2_control", "sensor", "group", "group_state", "disable_collisions",
                                        "verbose", "author"},
                    .unsupported_children = {"include", "loop_joint", "model"}};
  add_link_rules(rules);
  add_joint_rules(rules);
  rules["mujoco"] = {.children = {"compiler"}, .unused_children = {"option", "size"}};
  rules["compiler"] = {.used = {"meshdir", "strippath", "balanceinertia"},
                       .unused = {"discardvisual", "fusestatic", "angle", "eulerseq", "autolimits", "convexhull",
                                  "usethread", "texturedir", "saveinertial", "exactmeshinertia"},
                       .unsupported = {"boundmass", "boundinertia", "settotalmass", "inertiafromgeom",
                                       "inertiagrouprange"}};
  return rules;
}

}  // namespace

const files::XmlVocabulary& urdf_schema() {
  static const files::XmlVocabulary rules = make_rules();
  return rules;
}

void refuse_xacro(const files::XmlElement& robot) {
  // An explicit stack: depth of a file must not exhaust that of the program.
  std::vector<files::XmlElement> open{robot};
  while (!open.empty()) {
    const files::XmlElement element = open.back();
    open.pop_back();
    if (element.tag().starts_with("xacro:")) {
      element.fail(fmt::format(
          "<{}> is a macro; end the file's name in .xacro, or expand it first: xacro robot.xacro > robot.urdf",
          element.tag()));
    }
    for (const files::XmlElement& child : element.children()) open.push_back(child);
  }
}

}  // namespace murosimf::robot_formats::urdf
