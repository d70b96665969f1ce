#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// Kind of elements that share their settings.
std::string kind_of(const std::string& tag) {
  if (tag == "spatial" || tag == "fixed") return "tendon";
  return is_actuator(tag) ? "actuator" : tag;
}

constexpr std::array orientations{"quat", "axisangle", "xyaxes", "zaxis", "euler"};

}  // namespace

void MjcfAttributes::overlay(const files::XmlElement& element) {
  const auto attributes = element.attributes();
  // An orientation replaces one of another kind.
  const auto is_orientation = [](const files::XmlAttribute& a) {
    return std::ranges::find(orientations, a.name) != orientations.end();
  };
  if (std::ranges::any_of(attributes, is_orientation)) {
    for (const char* name : orientations) values_.erase(name);
  }
  for (const auto& [name, value] : attributes) values_.insert_or_assign(name, Value{value, element});
}

const files::XmlElement& MjcfAttributes::source(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? element_ : found->second.source;
}

std::string MjcfAttributes::text(std::string_view name, std::string_view otherwise) const {
  const auto found = values_.find(name);
  return std::string(found == values_.end() ? otherwise : std::string_view(found->second.text));
}

double MjcfAttributes::number(std::string_view name, double otherwise) const {
  return has(name) ? numbers(name, 1, 1)[0] : otherwise;
}

Vec3d MjcfAttributes::vector(std::string_view name, const Vec3d& otherwise) const {
  if (!has(name)) return otherwise;
  const auto row = numbers(name, 3, 3);
  MUROSIMF_ASSERT(row.size() == 3);
  return {row[0], row[1], row[2]};
}

std::vector<double> MjcfAttributes::numbers(std::string_view name, std::size_t least, std::size_t most) const {
  const auto found = values_.find(name);
  if (found == values_.end()) return {};
  const auto& [text, source] = found->second;
  MUROSIMF_ASSERT(least <= most);
  const auto row = files::parse_numbers(text);
  if (!row) source.fail(fmt::format("{} of {} is '{}'; write finite numbers there", name, source.tag(), text));
  if (row->size() < least || row->size() > most) {
    const auto range = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    source.fail(fmt::format("{} of {} needs {} numbers, '{}' has {}", name, source.tag(), range, text, row->size()));
  }
  return *row;
}

std::string MjcfAttributes::choice(std::string_view name, const std::vector<std::string_view>& choices) const {
  MUROSIMF_ASSERT(!choices.empty());
  const auto value = text(name, choices.front());
  if (std::ranges::find(choices, value) == choices.end()) {
    source(name).fail(unknown_name(fmt::format("{} of {}", name, element_.tag()), value, choices));
  }
  return value;
}

MjcfDefaults::MjcfDefaults(const files::XmlElement& root) {
  classes_[outermost_] = {};
  for (const files::XmlElement& element : root.children("default")) read(element, classes_[outermost_], true);
  for (const files::XmlElement& element : root.children(attached_defaults)) {
    for (const files::XmlElement& child : element.children("default")) read(child, {}, false);
  }
}

void MjcfDefaults::read(const files::XmlElement& element, const Class& outer, bool outermost) {
  const auto name = element.attribute("class");
  if (!name && !outermost) element.fail("a default inside a default needs a class; add class=\"...\"");
  if (outermost && name && *name != outermost_) {
    // A name of the outermost class is an alias: elements may refer to it by "main" as well.
    classes_[*name] = classes_[outermost_];
    outermost_ = *name;
  } else if (!outermost && classes_.contains(*name)) {
    element.fail(fmt::format("default class '{}' is already there; choose another name", *name));
  }
  Class mine = outer;
  // Its own settings first: inner classes inherit them, wherever in the element they are written.
  for (const files::XmlElement& child : element.children()) {
    if (child.tag() != "default") mine[kind_of(child.tag())].push_back(child);
  }
  classes_[outermost ? outermost_ : *name] = mine;
  for (const files::XmlElement& child : element.children("default")) read(child, mine, false);
}

std::vector<files::XmlElement> MjcfDefaults::settings(const files::XmlElement& element,
                                                      const std::string& child_class) const {
  std::string name = child_class.empty() ? outermost_ : child_class;
  if (const auto own = element.attribute("class")) {
    check_known(element, *own);
    name = *own;
  }
  MUROSIMF_ASSERT(classes_.contains(name));
  const Class& all = classes_.at(name);
  const auto found = all.find(kind_of(element.tag()));
  return found == all.end() ? std::vector<files::XmlElement>{} : found->second;
}

MjcfAttributes MjcfDefaults::resolve(const files::XmlElement& element, const std::string& child_class) const {
  MjcfAttributes attributes(element);
  // Later ones replace earlier ones: outermost class first, the element itself last.
  for (const files::XmlElement& setting : settings(element, child_class)) attributes.overlay(setting);
  /// that has the attribute (MuJoCo has one default actuator per class).
  /// A class inherits all settings of the class around it. An element follows, in this order: its own attributes, its
  /// `class`, or else the nearest `childclass` of a body around it, or else the outermost class.
  /// Element of the root with the classes of attached models, which inherit nothing from those of the file.
  attributes.overlay(element);
  return attributes;
}

std::string MjcfDefaults::child_class(const files::XmlElement& body, const std::string& outer) const {
  const auto own = body.attribute("childclass");
  if (!own) return outer;
  check_known(body, *own);
  return *own;
}

void MjcfDefaults::check_known(const files::XmlElement& element, const std::string& name) const {
  if (classes_.contains(name)) return;
  std::vector<std::string_view> known;
  for (const auto& [key, settings] : classes_) known.push_back(key);
  element.fail(unknown_name("default class", name, known));
}

}  // namespace murosimf::robot_formats::mjcf
