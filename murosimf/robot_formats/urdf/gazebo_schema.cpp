#include "murosimf/robot_formats/urdf/gazebo_schema.h"

#include "murosimf/robot_formats/urdf/urdf_schema.h"

namespace murosimf::robot_formats::urdf {
namespace {

void add_noise_rules(files::XmlVocabulary& rules) {
  const files::XmlWords gaussian{"mean",
                                 "stddev",
                                 "bias_mean",
                                 "bias_stddev",
                                 "dynamic_bias_stddev",
                                 "precision",
                                 "type",
                                 "dynamic_bias_correlation_time"};
  rules["noise"] = {.used = {"type"}, .children = gaussian};
  for (const char* axis : {"x", "y", "z"}) rules[axis] = {.children = {"noise"}};
  for (const char* old : {"rate", "accel"}) rules[old] = {.children = gaussian};
  rules["imu/noise"] = {.used = {"type"}, .children = {"type", "rate", "accel"}};
}

void add_camera_rules(files::XmlVocabulary& rules) {
  rules["camera"] = {.unused = {"name"},
                     .children = {"pose", "horizontal_fov", "image", "lens", "distortion", "noise"},
                     .unused_children = {"clip", "save", "depth_camera", "optical_frame_id", "visibility_mask",
                                         "segmentation_type", "box_type", "triggered", "trigger_topic",
                                         "camera_info_topic", "view_matrix"}};
  rules["image"] = {.children = {"width", "height"}, .unused_children = {"format", "anti_aliasing"}};
  rules["lens"] = {.children = {"intrinsics"},
                   .unused_children = {"type", "scale_to_hfov", "custom_function", "cutoff_angle", "env_texture_size",
                                       "projection"}};
  rules["intrinsics"] = {.children = {"fx", "fy", "cx", "cy", "s"}};
  rules["distortion"] = {.children = {"k1", "k2", "k3", "p1", "p2"}, .unused_children = {"center"}};
}

void add_laser_rules(files::XmlVocabulary& rules) {
  for (const char* laser : {"ray", "lidar"}) {
    rules[laser] = {.children = {"scan", "range", "noise"}, .unused_children = {"visibility_mask"}};
  }
  rules["scan"] = {.children = {"horizontal"}, .unused_children = {"vertical"}};
  rules["horizontal"] = {.children = {"samples", "resolution", "min_angle", "max_angle"}};
  rules["range"] = {.children = {"min", "max", "resolution"}};
}

void add_surface_rules(files::XmlVocabulary& rules) {
  rules["collision"] = {.children = {"surface"},
                        .unused_children = {"max_contacts", "laser_retro"},
                        .unsupported_children = {"pose", "geometry"}};
  rules["surface"] = {.children = {"friction"}, .unused_children = {"bounce", "contact", "soft_contact"}};
  rules["friction"] = {.children = {"ode"}, .unused_children = {"torsional", "bullet"}};
  rules["ode"] = {.children = {"mu", "mu2"}, .unused_children = {"fdir1", "slip1", "slip2"}};
}

files::XmlVocabulary make_gazebo_rules() {
  files::XmlVocabulary rules;
  rules["gazebo"] = {.used = {"reference"},
                     .children = {"mu1", "mu2", "collision", "springStiffness", "springReference", "sensor"},
                     .unused_children = {"material",
                                         "kp",
                                         "kd",
                                         "fdir1",
                                         "maxVel",
                                         "minDepth",
                                         "maxContacts",
                                         "soft_cfm",
                                         "soft_erp",
                                         "laserRetro",
                                         "visual",
                                         "plugin",
                                         "selfCollide",
                                         "stopCfm",
                                         "self_collide",
                                         "stopErp",
                                         "stopKp",
                                         "stopKd",
                                         "fudgeFactor",
                                         "cfm",
                                         "erp",
                                         "cfmDamping",
                                         "dampingFactor",
                                         "provideFeedback",
                                         "static",
                                         "gravity",
                                         "turnGravityOff",
                                         "kinematic",
                                         "useParentModelFrame",
                                         "implicitSpringDamper",
                                         "disableFixedJointLumping",
                                         "preserveFixedJoint"},
                     .unsupported_children = {"link", "joint", "model", "include", "inertial"}};
  rules["sensor"] = {.used = {"name", "type"},
                     .children = {"pose", "update_rate", "imu", "ray", "lidar", "camera", "force_torque", "plugin"},
                     .unused_children = {"always_on", "visualize", "topic", "enable_metrics", "contact", "altimeter",
                                         "magnetometer", "gps", "navsat", "sonar", "air_pressure", "logical_camera",
                                         "transceiver", "rfid", "rfidtag", "gz_frame_id", "ignition_frame_id"}};
  rules["pose"] = {.unsupported = {"relative_to", "frame", "degrees", "rotation_format"}};
  rules["imu"] = {.children = {"angular_velocity", "linear_acceleration", "noise"},
                  .unused_children = {"orientation_reference_frame", "enable_orientation", "topic"}};
  for (const char* quantity : {"angular_velocity", "linear_acceleration", "force", "torque"}) {
    rules[quantity] = {.children = {"x", "y", "z"}};
  }
  rules["force_torque"] = {.children = {"frame", "measure_direction", "force", "torque"}};
  add_surface_rules(rules);
  add_noise_rules(rules);
  add_camera_rules(rules);
  add_laser_rules(rules);
  return rules;
}

}  // namespace

const files::XmlVocabulary& gazebo_schema() {
  static const files::XmlVocabulary rules = make_gazebo_rules();
  return rules;
}

const files::XmlVocabulary& urdf_words() {
  static const files::XmlVocabulary words = [] {
    files::XmlVocabulary all = urdf_schema();
    // Tags inside blocks have other rules than the same tags in URDF.
    for (const auto& [tag, rule] : gazebo_schema()) all[tag == "gazebo" ? tag : "gazebo//" + tag] = rule;
    return all;
  }();
  return words;
}

}  // namespace murosimf::robot_formats::urdf
