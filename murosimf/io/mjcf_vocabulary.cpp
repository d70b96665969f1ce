#include "murosimf/io/mjcf_vocabulary.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

using Words = std::vector<std::string_view>;

struct ElementRule {
  Words used{};         // attributes that the reader acts on
  Words unused{};       // attributes that mean nothing here
  Words unsupported{};  // attributes that MuJoCo knows and that would change the robot
  Words children{};     // the same three, of elements inside
  Words unused_children{};
  Words unsupported_children{};
  Words open_children{};  // elements that are used, whatever stands in them
};

const Words actuators{"position", "velocity", "motor", "general"};

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::map<std::string, ElementRule, std::less<>> make_rules() {
  const Words frame{"name", "class", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};
  const Words unsupported_bodies{"composite", "flexcomp", "replicate", "attach", "plugin"};
  const Words look{"group", "material", "user"};
  std::map<std::string, ElementRule, std::less<>> rules;
  rules["mujoco"] = {.used = {"model"},
                     .children = {"compiler", "default", "asset", "worldbody", "actuator", "contact", "equality"},
                     .unused_children = {"option", "size", "visual", "statistic", "keyframe", "custom"},
                     .unsupported_children = {"tendon", "deformable", "extension"},
                     .open_children = {"sensor"}};
  rules["compiler"] = {.used = {"angle", "eulerseq", "autolimits", "inertiafromgeom", "coordinate", "meshdir",
                                "assetdir", "strippath", "boundmass", "boundinertia", "settotalmass", "balanceinertia"},
                       .unused = {"texturedir", "discardvisual", "fusestatic", "usethread", "convexhull",
                                  "exactmeshinertia", "saveinertial", "fitaabb"},
                       .unsupported = {"inertiagrouprange", "alignfree"},
                       .unused_children = {"lengthrange"}};
  rules["default"] = {.used = {"class"},
                      .children = Words{"default", "geom", "joint", "site", "mesh"} + actuators,
                      .unused_children = {"material", "camera", "light", "pair", "equality", "tendon"}};
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
  rules["body"] = {.used = Words{"childclass"} + frame,
                   .unused = {"user"},
                   .unsupported = {"gravcomp", "mocap", "sleep"},
                   .children = {"body", "joint", "freejoint", "inertial", "geom", "site", "camera", "frame"},
                   .unused_children = {"light"},
                   .unsupported_children = unsupported_bodies};
  rules["frame"] = {.used = Words{"childclass"} + frame,
                    .children = {"body", "geom", "site", "camera", "frame"},
                    .unused_children = {"light"},
                    .unsupported_children = unsupported_bodies};
  rules["camera"] = {.used = frame,
                     .unused = {"mode", "target", "fovy", "ipd", "resolution", "focal", "focalpixel", "principal",
                                "principalpixel", "sensorsize", "orthographic", "projection", "output", "user"}};
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
  rules["inertial"] = {.used = Words{"mass", "diaginertia", "fullinertia"} + frame};
  rules["geom"] = {.used = Words{"type", "size", "fromto", "friction", "rgba", "mass", "density", "contype",
                                 "conaffinity", "mesh"} +
                           frame,
                   .unused = look + Words{"condim", "priority", "solmix", "solref", "solimp", "margin", "gap"},
                   .unsupported = {"hfield", "fitscale", "shellinertia", "fluidshape", "fluidcoef"},
                   .unsupported_children = {"plugin"}};
  rules["site"] = {.used = Words{"type", "size"} + frame, .unused = look + Words{"rgba"}, .unsupported = {"fromto"}};
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

bool contains(const Words& words, std::string_view word) { return std::ranges::find(words, word) != words.end(); }

class Checker {
 public:
  void check(const XmlElement& element, const std::string& parent = {}) {
    const auto special = rules_.find(parent + "/" + element.tag());
    const ElementRule& rule = special != rules_.end() ? special->second : rules_.at(element.tag());
    check_attributes(element, rule);
    for (const XmlElement& child : element.children()) {
      if (contains(rule.children, child.tag())) {
        check(child, element.tag());
      } else if (contains(rule.open_children, child.tag())) {
        continue;
      } else if (contains(rule.unused_children, child.tag())) {
        note(child, fmt::format("element '{}'", child.tag()));
      } else {
        refuse_child(child, element, rule);
      }
    }
  }

  VocabularyFindings findings;

 private:
  void check_attributes(const XmlElement& element, const ElementRule& rule) {
    for (const auto& [name, value] : element.attributes()) {
      if (contains(rule.used, name)) continue;
      if (contains(rule.unused, name)) {
        note(element, fmt::format("attribute '{}' of {}", name, element.tag()));
      } else if (contains(rule.unsupported, name)) {
        refuse(element, fmt::format("attribute '{}' of {} is not supported", name, element.tag()));
      } else {
        refuse(element, unknown_name(fmt::format("attribute of {}", element.tag()), name, rule.used + rule.unused));
      }
    }
  }

  void refuse_child(const XmlElement& child, const XmlElement& parent, const ElementRule& rule) {
    if (contains(rule.unsupported_children, child.tag())) {
      return refuse(child, fmt::format("element '{}' is not supported", child.tag()));
    }
    const auto kind = fmt::format("element in {}", parent.tag());
    refuse(child, unknown_name(kind, child.tag(), rule.children + rule.unused_children));
  }

  void note(const XmlElement& at, const std::string& what) {
    if (noted_.insert(what).second) findings.notes.push_back(fmt::format("{}: {} is not used", at.where(), what));
  }

  void refuse(const XmlElement& at, const std::string& what) {
    findings.refused.push_back(one_line(fmt::format("{}: {}", at.where(), what)));
  }

  std::map<std::string, ElementRule, std::less<>> rules_ = make_rules();
  std::set<std::string> noted_;
};

}  // namespace

bool is_actuator(std::string_view tag) { return contains(actuators, tag); }

VocabularyFindings check_vocabulary(const XmlElement& root) {
  Checker checker;
  checker.check(root);
  return checker.findings;
}

}  // namespace murosimf::io
