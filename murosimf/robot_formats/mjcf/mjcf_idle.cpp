#include "murosimf/robot_formats/mjcf/mjcf_idle.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/robot_formats/mjcf/mjcf_tendon_ties.h"

namespace murosimf::robot_formats::mjcf {
namespace {

bool has_positive(const MjcfAttributes& tendon, const char* name) {
  return std::ranges::any_of(tendon.numbers(name, 1, 10), [](double number) { return number > 0; });
}

/// Effects of a tendon besides measuring a length.
std::vector<std::string> effects_of(const MjcfAttributes& tendon, const MjcfCompiler& compiler) {
  std::vector<std::string> effects;
  if (has_positive(tendon, "stiffness")) effects.emplace_back("spring");
  if (has_positive(tendon, "damping")) effects.emplace_back("damper");
  if (has_positive(tendon, "frictionloss")) effects.emplace_back("friction");
  if (has_positive(tendon, "armature")) effects.emplace_back("rotor");
  if (is_limited(tendon, "limited", "range", compiler)) effects.emplace_back("limit");
  return effects;
}

bool has_actuator(const files::XmlElement& root, const std::string& tendon) {
  for (const files::XmlElement& section : root.children("actuator")) {
    for (const files::XmlElement& element : section.children()) {
      if (element.attribute("tendon") == tendon) return true;
    }
  }
  return false;
}

/// Names a tendon that only measures or does not act. `acts`: at a joint, with all of its effects.
void name_tendon(const files::XmlElement& element, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                 bool acts, robot_formats::RobotDescription& description) {
  const std::string name = files::one_line(fmt::format("tendon '{}'", element.attribute("name").value_or("")));
  const auto effects = effects_of(defaults.resolve(element), compiler);
  if (effects.empty()) {
    description.unused.push_back({name, fmt::format("{}: {} only measures a length", element.where(), name)});
  } else if (!acts) {
    description.warnings.push_back(
        fmt::format("{}: {} does not act: {}", element.where(), name, fmt::join(effects, ", ")));
  }
}

/// Text of the ends, "'a' and 'b'": bodies, sites or tendons.
std::string ends_of(const files::XmlElement& element) {
  std::vector<std::string> ends;
  for (const char* word : {"body1", "body2", "site1", "site2", "tendon1", "tendon2"}) {
    if (const auto name = element.attribute(word)) ends.push_back(fmt::format("'{}'", *name));
  }
  return fmt::format("{}", fmt::join(ends, " and "));
}

/// Number of ends of a `connect` or `weld` that are not part of the robot.
int ends_outside(const files::XmlElement& element, const MjcfNames& names) {
  const bool sites = element.attribute("site1") || element.attribute("site2");
  const std::string kind = sites ? "site" : "body";
  const auto outside = [&](const char* end) {
    // A missing body is the world; a missing site is an error that its reader reports.
    return names.is_elsewhere(kind, element.attribute((kind + end).c_str()).value_or(sites ? "" : world_name));
  };
  return static_cast<int>(outside("1")) + static_cast<int>(outside("2"));
}

void name_equality(const files::XmlElement& element, const MjcfNames& names,
                   robot_formats::RobotDescription& description) {
  const std::string what = files::one_line(fmt::format("{} of {}", element.tag(), ends_of(element)));
  if (element.attribute("active") == "false") {
    description.unused.push_back({what, fmt::format("{}: {} is not active", element.where(), what)});
  } else if (element.tag() == "tendon" || ends_outside(element, names) < 2) {
    description.warnings.push_back(
        fmt::format("{}: {} does not act: nothing holds them together", element.where(), what));
  }
}

}  // namespace

bool is_idle_equality(const files::XmlElement& element, const MjcfNames& names) {
  return element.attribute("active") == "false" || ends_outside(element, names) > 0;
}

void name_idle_relations(const files::XmlElement& root, const MjcfContext& context,
                         const std::map<std::string, MjcfTendon>& tendons,
                         robot_formats::RobotDescription& description) {
  for (const files::XmlElement& section : root.children("tendon")) {
    for (const files::XmlElement& element : section.children()) {
      const std::string name = element.attribute("name").value_or(element.where());
      const bool acts = tendons.contains(name);
      // in use: neither idle nor only a measurement
      if (acts && (has_actuator(root, name) || tendons.at(name).tied)) continue;
      name_tendon(element, context.defaults, context.compiler, acts, description);
    }
  }
  for (const files::XmlElement& section : root.children("equality")) {
    for (const files::XmlElement& element : section.children()) {
      const std::string tag = element.tag();
      const bool idle = tag == "tendon"                     ? is_idle_tie(element, tendons)
                        : tag == "connect" || tag == "weld" ? is_idle_equality(element, context.names)
                                                            : false;
      if (idle) name_equality(element, context.names, description);
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
