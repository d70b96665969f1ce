#include "murosimf/robot_formats/mjcf/mjcf_tendon_ties.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mjcf {
namespace {

std::vector<files::XmlElement> ties_of(const files::XmlElement& root) {
  std::vector<files::XmlElement> ties;
  for (const files::XmlElement& section : root.children("equality")) {
    for (const files::XmlElement& element : section.children("tendon")) ties.push_back(element);
  }
  return ties;
}

void check_name(const files::XmlElement& root, const files::XmlElement& tie, const std::string& name) {
  std::vector<std::string> known;
  for (const files::XmlElement& section : root.children("tendon")) {
    for (const files::XmlElement& element : section.children()) known.push_back(element.attribute("name").value_or(""));
  }
  if (std::ranges::find(known, name) == known.end()) {
    tie.fail(unknown_name("tendon", name, {known.begin(), known.end()}));
  }
}

}  // namespace

std::set<std::string> tied_tendons(const files::XmlElement& root) {
  std::set<std::string> names;
  for (const files::XmlElement& tie : ties_of(root)) {
    if (tie.attribute("active") == "false") continue;
    for (const char* end : {"tendon1", "tendon2"}) {
      if (const auto name = tie.attribute(end)) names.insert(*name);
    }
  }
  return names;
}

bool is_idle_tie(const files::XmlElement& element, const std::map<std::string, MjcfTendon>& tendons) {
  const auto second = element.attribute("tendon2");
  return element.attribute("active") == "false" || !tendons.contains(element.attribute("tendon1").value_or("")) ||
         (second && !tendons.contains(*second));
}

void read_ties(const files::XmlElement& root, const std::map<std::string, MjcfTendon>& tendons,
               robot_formats::RobotDescription& description) {
  for (const files::XmlElement& element : ties_of(root)) {
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    const std::string first = attributes.text("tendon1"), second = attributes.text("tendon2");
    check_name(root, element, first);
    if (!second.empty()) check_name(root, element, second);
    if (is_idle_tie(element, tendons)) continue;
    robot_formats::TieDescription tie;
    if (!second.empty()) tie.other = tendons.at(second).joint;
    const auto polynomial = attributes.numbers("polycoef", 1, 5);
    std::ranges::copy(polynomial, tie.polynomial.begin());
    const auto slider = std::ranges::find(description.tendons, tendons.at(first).joint,
                                          [](const auto& tendon) { return tendon.joint.name; });
    MUROSIMF_ASSERT(slider != description.tendons.end());
    if (slider->tie) element.fail(fmt::format("tendon '{}' is held by two equalities; remove one", first));
    if (first == second) element.fail(fmt::format("tendon '{}' is held to itself; name another tendon2", first));
    slider->tie = tie;
  }
}

}  // namespace murosimf::robot_formats::mjcf
