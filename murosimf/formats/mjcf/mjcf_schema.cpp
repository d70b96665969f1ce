#include "murosimf/formats/mjcf/mjcf_schema.h"

#include <algorithm>

namespace murosimf::formats::mjcf {
namespace {

const files::XmlWords actuators{"position", "velocity", "motor", "general"};

files::XmlWords operator+(files::XmlWords a, const files::XmlWords& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

files::XmlVocabulary make_rules() {
  const files::XmlWords frame{"name", "class", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};
  const files::XmlWords unsupported_bodies{"composite", "flexcomp", "replicate", "attach", "plugin"};
  const files::XmlWords look{"group", "material", "user"};
  files::XmlVocabulary rules;
  rules["mujoco"] = {.used = {"model"},
                     .children = {"compiler", "default", "asset", "worldbody", "actuator", "contact", "equality",
                                  "sensor"},
                     .unused_children = {"option", "size", "visual", "statistic", "keyframe", "custom"},
                     .unsupported_children = {"tendon", "deformable", "extension"}};
  rules["compiler"] = {.used = {"angle", "eulerseq", "autolimits", "inertiafromgeom", "coordinate", "meshdir",
                                "assetdir", "strippath", "boundmass", "boundinertia", "settotalmass", "balanceinertia"},
                       .unused = {"texturedir", "discardvisual", "fusestatic", "usethread", "convexhull",
                                  "exactmeshinertia", "saveinertial", "fitaabb"},
                       .unsupported = {"inertiagrouprange", "alignfree"},
                       .unused_children = {"lengthrange"}};
  rules["default"] = {.used = {"class"},
                      .children = files::XmlWords{"default", "geom", "joint", "site", "mesh", "camera"} + actuators,
                      .unused_children = {"material", "light", "pair", "equality", "tendon"}};
  rules["asset"] = {.children = {"mesh"},
                    .unused_children = {"texture", "material", "hfield", "skin"},
                    .unsupported_children = {"model"}};
  rules["mesh"] = {.used = {"name", "class", "file", "vertex", "face", "scale", "refpos", "refquat", "inertia"},
                   .unused = {"content_type", "smoothnormal", "maxhullvert", "normal", "texcoord", "material",
                              "octree"},
                   .unsupported = {"builtin", "params"},
                   .unsupported_children = {"plugin"}};
  rules["worldbody"] = {.used = {"childclass"},
                        .children = {"body", "geom", "site", "frame"},
                        .unused_children = {"light", "camera"},
                        .unsupported_children = unsupported_bodies};
  rules["body"] = {.used = files::XmlWords{"childclass"} + frame,
                   .unused = {"user"},
                   .unsupported = {"gravcomp", "mocap", "sleep"},
                   .children = {"body", "joint", "freejoint", "inertial", "geom", "site", "camera", "frame"},
                   .unused_children = {"light"},
                   .unsupported_children = unsupported_bodies};
  rules["frame"] = {.used = files::XmlWords{"childclass"} + frame,
                    .children = {"body", "geom", "site", "camera", "frame"},
                    .unused_children = {"light"},
                    .unsupported_children = unsupported_bodies};
  rules["camera"] = {.used = frame + files::XmlWords{"mode", "fovy", "resolution", "focal", "focalpixel", "principal",
                                                     "principalpixel", "sensorsize", "orthographic", "projection"},
                     .unused = {"target", "ipd", "output", "user"}};
  rules["contact"] = {.children = {"exclude", "pair"}};
  rules["exclude"] = {.used = {"body1", "body2"}, .unused = {"name"}};
  rules["pair"] = {.used = {"geom1", "geom2"},
                   .unused = {"name", "class", "condim", "friction", "solref", "solreffriction", "solimp", "gap",
                              "margin"}};
  rules["equality"] = {.children = {"joint"}, .unsupported_children = {"connect", "weld", "tendon", "flex", "plugin"}};
  rules["equality/joint"] = {.used = {"joint1", "joint2", "polycoef"},
                             .unused = {"name", "class", "solref", "solimp"},
                             .unsupported = {"active"}};
  rules["freejoint"] = {.used = {"name"}, .unused = {"group"}, .unsupported = {"align"}};
  rules["joint"] = {.used = {"name", "class", "type", "pos", "axis", "range", "limited", "armature", "damping",
                             "frictionloss", "actuatorfrcrange", "actuatorfrclimited", "ref", "stiffness", "springref"},
                    .unused = {"group", "user", "solreflimit", "solimplimit", "solreffriction", "solimpfriction",
                               "margin"},
                    .unsupported = {"springdamper", "actuatorgravcomp"},
                    .unsupported_children = {"plugin"}};
  rules["inertial"] = {.used = files::XmlWords{"mass", "diaginertia", "fullinertia"} + frame};
  rules["geom"] = {.used = files::XmlWords{"type", "size", "fromto", "friction", "rgba", "mass", "density", "contype",
                                           "conaffinity", "mesh"} +
                           frame,
                   .unused =
                       look + files::XmlWords{"condim", "priority", "solmix", "solref", "solimp", "margin", "gap"},
                   .unsupported = {"hfield", "fitscale", "shellinertia", "fluidshape", "fluidcoef"},
                   .unsupported_children = {"plugin"}};
  rules["site"] = {.used = files::XmlWords{"type", "size"} + frame,
                   .unused = look + files::XmlWords{"rgba"},
                   .unsupported = {"fromto"}};
  for (const std::string_view actuator : actuators) {
    rules[std::string(actuator)] = {
        .used = {"name", "class", "joint", "kp", "kv", "forcerange", "forcelimited", "ctrlrange", "ctrllimited", "gear",
                 "dampratio", "gainprm", "biasprm", "gaintype", "biastype"},
        .unused = {"group", "user", "inheritrange", "lengthrange", "actlimited", "actrange", "actdim", "actearly"},
        .unsupported = {"timeconst", "dyntype", "dynprm", "tendon", "site", "body", "refsite", "jointinparent",
                        "slidersite", "cranksite", "cranklength"}};
  }
  rules["actuator"] = {.children = actuators,
                       .unsupported_children = {"intvelocity", "damper", "cylinder", "muscle", "adhesion", "dcmotor",
                                                "plugin"}};
  return rules;
}

}  // namespace

bool is_actuator(std::string_view tag) { return std::ranges::find(actuators, tag) != actuators.end(); }

const files::XmlVocabulary& mjcf_schema() {
  static const files::XmlVocabulary rules = make_rules();
  return rules;
}

}  // namespace murosimf::formats::mjcf
