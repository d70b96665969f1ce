#include "murosimf/robot_formats/mjcf/mjcf_references.h"

#include <algorithm>

#include "murosimf/robot_formats/mjcf/mjcf_schema.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// Kind of an element's tag: a motor is an actuator, a freejoint a joint, a spatial tendon a tendon.
std::string kind_of_element(const std::string& tag) {
  if (is_actuator(tag)) return "actuator";
  if (tag == "fixed" || tag == "spatial") return "tendon";
  return tag == "freejoint" ? "joint" : tag;
}

/// Kind of the object that an attribute refers to; empty: none.
std::string kind_of_reference(const files::XmlTree& tree, const std::string& attribute) {
  for (const char* kind : {"joint", "body", "geom", "site", "camera", "actuator", "tendon"}) {
    if (attribute == kind || attribute == std::string(kind) + "1" || attribute == std::string(kind) + "2") return kind;
  }
  if (attribute == "refsite" || attribute == "sidesite") return "site";
  if (attribute == "mesh" || attribute == "material" || attribute == "texture") return attribute;
  if (attribute != "objname" && attribute != "refname") return {};
  const std::string type = attribute == "objname" ? "objtype" : "reftype";
  const auto found = std::ranges::find(tree.attributes, type, &files::XmlAttribute::name);
  if (found == tree.attributes.end()) return {};
  return found->value == "xbody" ? "body" : found->value;  // two frames of the same body
}

}  // namespace

void MjcfReferences::add(const files::XmlTree& tree) {
  for (const auto& [name, value] : tree.attributes) {
    if (name == "name") names_[kind_of_element(tree.tag)].insert(value);
  }
}

void MjcfReferences::add_all(const files::XmlTree& tree) {
  add(tree);
  for (const files::XmlTree& child : tree.children) add_all(child);
}

bool MjcfReferences::refers(const files::XmlTree& tree, const files::XmlAttribute& attribute) const {
  const auto known = names_.find(kind_of_reference(tree, attribute.name));
  return known != names_.end() && known->second.contains(attribute.value);
}

bool MjcfReferences::mentioned_in(const files::XmlTree& tree) const {
  return std::ranges::any_of(tree.attributes, [&](const auto& attribute) { return refers(tree, attribute); }) ||
         std::ranges::any_of(tree.children, [&](const files::XmlTree& child) { return mentioned_in(child); });
}

void MjcfReferences::rename(files::XmlTree& tree, const std::string& prefix, const std::string& suffix) const {
  for (files::XmlAttribute& attribute : tree.attributes) {
    // Names and references together: a copy refers to its own parts.
    if (attribute.name == "name" || refers(tree, attribute)) attribute.value = prefix + attribute.value + suffix;
  }
  for (files::XmlTree& child : tree.children) rename(child, prefix, suffix);
}

}  // namespace murosimf::robot_formats::mjcf
