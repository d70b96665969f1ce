#include "murosimf/robot_formats/mjcf/mjcf_children.h"

namespace murosimf::robot_formats::mjcf {
namespace {

void collect(const files::XmlElement& parent, const MjcfChild& around, const MjcfDefaults& defaults,
             const MjcfCompiler& compiler, std::vector<MjcfChild>& children) {
  for (const files::XmlElement& element : parent.children()) {
    if (element.tag() != "frame") {
      children.push_back({element, around.child_class, around.frame});
      continue;
    }
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    // Frames nest: each is relative to the one around it.
    const Transformd own{attributes.vector("pos", {}), read_orientation(attributes, compiler)};
    const MjcfChild frame{element, defaults.child_class(element, around.child_class), around.frame * own};
    collect(element, frame, defaults, compiler, children);
  }
}

void collect(const files::XmlElement& parent, std::string_view tag, std::vector<files::XmlElement>& elements) {
  for (const files::XmlElement& element : parent.children()) {
    if (element.tag() == "frame") collect(element, tag, elements);
    if (element.tag() == tag) elements.push_back(element);
  }
}

}  // namespace

std::vector<MjcfChild> children_in(const files::XmlElement& body, const std::string& child_class,
                                   const MjcfDefaults& defaults, const MjcfCompiler& compiler) {
  std::vector<MjcfChild> children;
  collect(body, {body, child_class, {}}, defaults, compiler, children);
  return children;
}

std::vector<files::XmlElement> elements_in(const files::XmlElement& body, std::string_view tag) {
  std::vector<files::XmlElement> elements;
  collect(body, tag, elements);
  return elements;
}

}  // namespace murosimf::robot_formats::mjcf
