#include "murosimf/robot_formats/sdf/sdf_schema.h"

#include "murosimf/robot_formats/urdf/gazebo_schema.h"

namespace murosimf::robot_formats::sdf {
namespace {

void add_world_rules(files::XmlVocabulary& rules) {
  rules["sdf"] = {.used = {"version"}, .children = {"world", "model"}, .unused_children = {"actor", "light"}};
  rules["world"] = {.used = {"name"},
                    .children = {"model", "include"},
                    .unused_children = {"physics", "gravity", "scene", "light", "plugin", "gui", "atmosphere", "wind",
                                        "magnetic_field", "spherical_coordinates", "state", "road", "population",
                                        "audio", "actor", "frame", "joint"}};
  rules["include"] = {.used = {"merge"},
                      .children = {"uri", "name", "pose", "static", "placement_frame"},
                      .unused_children = {"plugin"},
                      .unsupported_children = {"experimental:params"}};
}

void add_model_rules(files::XmlVocabulary& rules) {
  rules["model"] = {.used = {"name", "canonical_link", "placement_frame"},
                    .children = {"static", "self_collide", "pose", "frame", "link", "joint", "model", "include"},
                    .unused_children = {"allow_auto_disable", "enable_wind", "plugin", "gripper"}};
  rules["frame"] = {.used = {"name", "attached_to"}, .children = {"pose"}};
  rules["pose"] = {.used = {"relative_to", "frame", "degrees", "rotation_format"}};
  rules["link"] = {.used = {"name"},
                   .children = {"pose", "inertial", "collision", "visual", "sensor", "gravity", "kinematic"},
                   .unused_children = {"self_collide", "enable_wind", "velocity_decay", "must_be_base_link",
                                       "projector", "audio_sink", "audio_source", "battery", "light",
                                       "particle_emitter", "plugin"}};
  rules["inertial"] = {.unsupported = {"auto"},
                       .children = {"pose", "mass", "inertia"},
                       .unused_children = {"fluid_added_mass"},
                       .unsupported_children = {"density", "auto_inertia_params"}};
  rules["inertia"] = {.children = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"}};
}

void add_shape_rules(files::XmlVocabulary& rules) {
  rules["collision"] = {.used = {"name"},
                        .children = {"pose", "geometry", "surface"},
                        .unused_children = {"max_contacts", "laser_retro", "density", "auto_inertia_params"}};
  rules["visual"] = {.used = {"name"},
                     .children = {"pose", "geometry", "material", "transparency"},
                     .unused_children = {"cast_shadows", "laser_retro", "visibility_flags", "meta", "plugin"}};
  rules["geometry"] = {.children = {"box", "cylinder", "sphere", "capsule", "ellipsoid", "mesh"},
                       .unused_children = {"empty"},
                       .unsupported_children = {"plane", "heightmap", "image", "polyline", "cone"}};
  rules["visual/geometry"] = {.children = rules["geometry"].children,
                              .unused_children = {"empty", "plane", "heightmap", "image", "polyline", "cone"}};
  rules["box"] = {.children = {"size"}};
  rules["sphere"] = {.children = {"radius"}};
  for (const char* round : {"cylinder", "capsule"}) rules[round] = {.children = {"radius", "length"}};
  rules["ellipsoid"] = {.children = {"radii"}};
  rules["mesh"] = {.unused = {"optimization"},
                   .children = {"uri", "scale"},
                   .unused_children = {"convex_decomposition"},
                   .unsupported_children = {"submesh"}};
  rules["material"] = {.children = {"diffuse", "ambient", "pbr"},
                       .unused_children = {"script", "shader", "lighting", "specular", "emissive", "shininess",
                                           "render_order", "double_sided"}};
  rules["pbr"] = {.children = {"metal"}, .unused_children = {"specular"}};
  rules["metal"] = {.children = {"albedo_map"},
                    .unused_children = {"normal_map", "roughness", "roughness_map", "metalness", "metalness_map",
                                        "environment_map", "ambient_occlusion_map", "emissive_map", "light_map"}};
}

void add_joint_rules(files::XmlVocabulary& rules) {
  rules["joint"] = {.used = {"name", "type"},
                    .children = {"parent", "child", "pose", "axis", "axis2", "sensor"},
                    .unused_children = {"physics", "gearbox_ratio", "gearbox_reference_body", "thread_pitch",
                                        "screw_thread_pitch"}};
  const files::XmlRule axis{.children = {"xyz", "limit", "dynamics", "mimic", "use_parent_model_frame"},
                            .unused_children = {"initial_position"}};
  rules["axis"] = rules["axis2"] = axis;
  rules["xyz"] = {.used = {"expressed_in"}};
  rules["limit"] = {.children = {"lower", "upper", "effort", "velocity"},
                    .unused_children = {"stiffness", "dissipation"}};
  rules["dynamics"] = {.children = {"damping", "friction", "spring_reference", "spring_stiffness"}};
  rules["mimic"] = {.used = {"joint", "axis"}, .children = {"multiplier", "offset", "reference"}};
}

files::XmlVocabulary make_rules() {
  // Sensors, their noise, and surfaces are those of gazebo blocks in URDF.
  files::XmlVocabulary rules = urdf::gazebo_schema();
  rules.erase("gazebo");
  rules["camera/pose"] = rules["pose"];
  add_world_rules(rules);
  add_model_rules(rules);
  add_shape_rules(rules);
  add_joint_rules(rules);
  return rules;
}

}  // namespace

const files::XmlVocabulary& sdf_schema() {
  static const files::XmlVocabulary rules = make_rules();
  return rules;
}

}  // namespace murosimf::robot_formats::sdf
