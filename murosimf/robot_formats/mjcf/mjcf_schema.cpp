#include "murosimf/robot_formats/mjcf/mjcf_schema.h"

#include <algorithm>

namespace murosimf::robot_formats::mjcf {
namespace {

const files::XmlWords actuators{"position", "velocity", "intvelocity", "motor", "general"};
/// Actuators without effect here, each with a warning.
const files::XmlWords idle_actuators{"damper",  "cylinder",    "muscle", "adhesion",
                                     "dcmotor", "orientation", "pid",    "plugin"};

files::XmlWords operator+(files::XmlWords a, const files::XmlWords& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void add_tendon_rules(files::XmlVocabulary& rules) {
  const files::XmlWords own{"name", "class"};
  const files::XmlWords used{"range",    "limited",      "stiffness",        "springlength",      "damping",
                             "armature", "frictionloss", "actuatorfrcrange", "actuatorfrclimited"};
  const files::XmlWords unused{"group",          "user",           "margin", "solreflimit", "solimplimit",
                               "solreffriction", "solimpfriction", "width",  "material",    "rgba"};
  rules["tendon"] = {.children = {"fixed", "spatial"}};
  rules["default/tendon"] = {.used = used, .unused = unused};
  rules["fixed"] = {.used = own + used, .unused = unused, .children = {"joint"}};
  rules["spatial"] = {.used = own + used, .unused = unused, .children = {"site", "geom", "pulley"}};
  rules["fixed/joint"] = {.used = {"joint", "coef"}};
  rules["spatial/site"] = {.used = {"site"}};
  rules["spatial/geom"] = {.used = {"geom", "sidesite"}};
  rules["pulley"] = {.used = {"divisor"}};
}

/// Adds the rules of sensors that become sensors of the robot, by their objects, and of others.
void add_sensor_rules(files::XmlVocabulary& rules) {
  const files::XmlWords signal{"name", "noise", "cutoff"};
  const files::XmlWords at_site{"accelerometer", "gyro", "velocimeter", "force", "torque", "touch", "rangefinder"};
  const files::XmlWords of_joint{"jointpos", "jointvel", "jointactuatorfrc"};
  const files::XmlWords of_frame{"framepos", "framequat", "framelinvel", "frameangvel"};
  rules["sensor"] = {.children = at_site + of_joint + of_frame + files::XmlWords{"actuatorfrc", "subtreecom"},
                     .unused_children = {"magnetometer",   "jointlimitpos",  "jointlimitvel",
                                         "jointlimitfrc",  "actuatorpos",    "actuatorvel",
                                         "subtreelinvel",  "subtreeangmom",  "framexaxis",
                                         "frameyaxis",     "framezaxis",     "framelinacc",
                                         "frameangacc",    "clock",          "user",
                                         "plugin",         "ballquat",       "ballangvel",
                                         "tendonpos",      "tendonvel",      "tendonactuatorfrc",
                                         "tendonlimitpos", "tendonlimitvel", "tendonlimitfrc",
                                         "camprojection",  "distance",       "normal",
                                         "fromto",         "insidesite",     "contact",
                                         "e_potential",    "e_kinetic",      "tactile"}};
  const auto add = [&](const files::XmlWords& kinds, const files::XmlWords& object, const files::XmlWords& unused) {
    for (const std::string_view kind : kinds) {
      rules["sensor/" + std::string(kind)] = {.used = signal + object,
                                              .unused = unused + files::XmlWords{"user", "nsample", "interp", "delay",
                                                                                 "interval"}};
    }
  };
  add(at_site, {"site"}, {});
  add(of_joint, {"joint"}, {});
  add(of_frame, {"objtype", "objname"}, {"reftype", "refname"});
  add({"actuatorfrc"}, {"actuator"}, {});
  add({"subtreecom"}, {"body"}, {});
  files::XmlRule& turn = rules["sensor/framequat"];  // components of a quaternion have no cutoff
  std::erase(turn.used, "cutoff");
  turn.unused.push_back("cutoff");
}

files::XmlVocabulary make_rules() {
  const files::XmlWords place{"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};
  const files::XmlWords placed = files::XmlWords{"name", "class"} + place;
  const files::XmlWords unsupported_bodies{"composite", "flexcomp", "plugin"};
  files::XmlVocabulary rules;
  rules["mujoco"] = {.used = {"model"},
                     .children = {"compiler", "default", "asset", "worldbody", "actuator", "contact", "equality",
                                  "sensor", "keyframe", "tendon"},
                     .unused_children = {"option", "size", "visual", "statistic", "custom", "extension"},
                     .unsupported_children = {"deformable"}};
  rules["compiler"] = {.used = {"angle", "eulerseq", "autolimits", "inertiafromgeom", "coordinate", "meshdir",
                                "texturedir", "assetdir", "strippath", "inertiagrouprange", "boundmass", "boundinertia",
                                "settotalmass", "balanceinertia"},
                       .unused = {"alignfree", "discardvisual", "fusestatic", "usethread", "convexhull",
                                  "exactmeshinertia", "saveinertial", "fitaabb", "savecanonical", "savecompiled",
                                  "conflict", "passthrough"},
                       .unused_children = {"lengthrange"}};
  rules["default"] = {.used = {"class"},
                      .children =
                          files::XmlWords{"default", "geom", "joint", "site", "mesh", "material", "camera", "tendon"} +
                          actuators,
                      .unused_children = files::XmlWords{"light", "pair", "equality"} + idle_actuators};
  rules["asset"] = {.children = {"mesh", "material", "model", "texture"}, .unused_children = {"hfield", "skin"}};
  rules["texture"] = {.used = {"name", "type", "file", "builtin", "rgb1", "rgb2"},
                      .unused = {"content_type", "gridsize", "gridlayout", "fileright", "fileleft", "fileup",
                                 "filedown", "filefront", "fileback", "mark", "markrgb", "random", "width", "height",
                                 "hflip", "vflip", "colorspace", "nchannel"}};
  rules["asset/model"] = {.used = {"name", "file"}, .unused = {"content_type"}};
  rules["attach"] = {.used = {"model", "body", "prefix"}};
  rules["material"] = {.used = {"name", "class", "rgba", "texture", "texrepeat"},
                       .unused = {"texuniform", "emission", "specular", "shininess", "reflectance", "metallic",
                                  "roughness"},
                       .unused_children = {"layer"}};
  rules["mesh"] = {.used = {"name", "class", "file", "vertex", "face", "scale", "refpos", "refquat", "inertia",
                            "material"},
                   .unused = {"content_type", "smoothnormal", "maxhullvert", "normal", "texcoord", "octree"},
                   .unsupported = {"builtin", "params"},
                   .unsupported_children = {"plugin"}};
  rules["worldbody"] = {.used = {"childclass"},
                        .children = {"body", "frame", "replicate", "attach"},
                        .unused_children = {"light", "camera", "geom", "site"},
                        .unsupported_children = unsupported_bodies};
  rules["body"] = {.used = files::XmlWords{"name", "childclass"} + place,
                   .unused = {"user", "gravcomp", "sleep", "mocap"},
                   .children = {"body", "joint", "freejoint", "inertial", "geom", "site", "camera", "frame",
                                "replicate", "attach"},
                   .unused_children = {"light"},
                   .unsupported_children = unsupported_bodies};
  rules["frame"] = {.used = files::XmlWords{"childclass"} + place,
                    .unused = {"name"},
                    .children = {"body", "joint", "freejoint", "geom", "site", "camera", "frame", "replicate",
                                 "attach"},
                    .unused_children = {"light"},
                    .unsupported_children = unsupported_bodies};
  rules["replicate"] = {.used = {"count", "offset", "euler", "sep"},
                        .children = {"body", "geom", "site", "camera", "frame", "replicate", "attach"},
                        .unused_children = {"light"},
                        .unsupported_children = unsupported_bodies};
  rules["keyframe"] = {.children = {"key"}};
  rules["key"] = {.used = {"name", "qpos", "ctrl"}, .unused = {"time", "qvel", "act", "mpos", "mquat", "plastic"}};
  add_sensor_rules(rules);
  add_tendon_rules(rules);
  rules["camera"] = {.used = placed + files::XmlWords{"mode", "fovy", "resolution", "focal", "focalpixel", "principal",
                                                      "principalpixel", "sensorsize", "orthographic", "projection"},
                     .unused = {"target", "ipd", "output", "user"}};
  rules["contact"] = {.children = {"exclude", "pair"}};
  rules["exclude"] = {.used = {"body1", "body2"}, .unused = {"name"}};
  rules["pair"] = {.used = {"geom1", "geom2"},
                   .unused = {"name", "class", "condim", "friction", "solref", "solreffriction", "solimp", "gap",
                              "margin"},
                   .unsupported = {"adhesion"}};
  const files::XmlWords ends{"active", "body1", "body2", "site1", "site2", "anchor"};
  rules["equality"] = {.children = {"joint", "connect", "weld", "tendon"},
                       .unsupported_children = {"flex", "flexvert", "flexstrain", "plugin"}};
  rules["equality/joint"] = {.used = {"joint1", "joint2", "polycoef", "active"},
                             .unused = {"name", "class", "solref", "solimp"}};
  rules["equality/tendon"] = {.used = {"tendon1", "tendon2", "polycoef", "active"},
                              .unused = {"name", "class", "solref", "solimp"}};
  rules["connect"] = {.used = ends + files::XmlWords{"name"}, .unused = {"class", "solref", "solimp"}};
  rules["weld"] = {.used = ends + files::XmlWords{"name", "relpose"},
                   .unused = {"class", "solref", "solimp", "torquescale"}};
  rules["freejoint"] = {.used = {"name"}, .unused = {"group", "align"}};
  rules["joint"] = {.used = {"name", "class", "type", "pos", "axis", "range", "limited", "armature", "damping",
                             "frictionloss", "actuatorfrcrange", "actuatorfrclimited", "ref", "stiffness", "springref",
                             "springdamper"},
                    .unused = {"group", "user", "solreflimit", "solimplimit", "solreffriction", "solimpfriction",
                               "margin"},
                    .unsupported = {"springyield", "actuatorgravcomp"},
                    .unsupported_children = {"plugin"}};
  rules["inertial"] = {.used = files::XmlWords{"mass", "diaginertia", "fullinertia"} + place};
  rules["geom"] = {.used = files::XmlWords{"type", "size", "fromto", "friction", "rgba", "mass", "density", "contype",
                                           "conaffinity", "mesh", "material", "group"} +
                           placed,
                   .unused = {"user", "fluidshape", "fluidcoef", "condim", "priority", "solmix", "solref", "solimp",
                              "margin", "gap", "castshadow"},
                   .unsupported = {"hfield", "fitscale", "shellinertia", "surfacevel", "adhesion"},
                   .unsupported_children = {"plugin"}};
  rules["site"] = {.used = files::XmlWords{"type", "size", "fromto"} + placed,
                   .unused = {"group", "material", "user", "rgba"}};
  const std::map<std::string_view, files::XmlWords> own{
      {"position", {"kp", "kv", "dampratio", "timeconst", "inheritrange"}},
      {"velocity", {"kv"}},
      {"intvelocity", {"kp", "kv", "dampratio", "inheritrange"}},
      {"motor", {}},
      {"general", {"gainprm", "biasprm", "gaintype", "biastype", "dyntype", "dynprm"}}};
  // Names of the parts of a control; without effect.
  const files::XmlWords labels{"input", "velrange", "ffrange"};
  for (const std::string_view actuator : actuators) {
    const files::XmlWords common{"name", "class", "joint", "tendon", "forcerange", "forcelimited", "gear"};
    const files::XmlWords control{"ctrlrange", "ctrllimited"}, activation{"actrange", "actlimited"};
    // Without a joint it moves nothing, which is a warning.
    const files::XmlWords unused{"group", "user",    "lengthrange",   "actdim",     "actearly",  "site",
                                 "body",  "refsite", "jointinparent", "slidersite", "cranksite", "cranklength"};
    const bool general = actuator == "general", integrates = actuator == "intvelocity";
    rules[std::string(actuator)] = {.used = common + own.at(actuator) + (integrates ? files::XmlWords{} : control) +
                                            (general || integrates ? activation : files::XmlWords{}),
                                    .unused = unused + (general      ? labels
                                                        : integrates ? control
                                                                     : activation)};
  }
  rules["actuator"] = {.children = actuators, .unused_children = idle_actuators};
  return rules;
}

}  // namespace

bool is_actuator(std::string_view tag) { return std::ranges::find(actuators, tag) != actuators.end(); }

bool is_idle_actuator(std::string_view tag) { return std::ranges::find(idle_actuators, tag) != idle_actuators.end(); }

const files::XmlVocabulary& mjcf_schema() {
  static const files::XmlVocabulary rules = make_rules();
  return rules;
}

}  // namespace murosimf::robot_formats::mjcf
