#include "murosimf/robot_formats/mjcf/mjcf_names.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"

namespace murosimf::robot_formats::mjcf {

MjcfNames::MjcfNames(const files::XmlElement& root, const MjcfTrees& trees) {
  for (const files::XmlElement& world : root.children("worldbody")) name_world(world, trees.bolted);
  // All names before anything is built: elements may refer to later ones.
  for (const MjcfTree& tree : trees.all) tree.of_robot ? walk(tree.body) : walk_elsewhere(tree.body);
}

void MjcfNames::name_world(const files::XmlElement& world, bool bolted) {
  if (bolted && bodies_.names.empty()) add(world, bodies_, world_name);
  if (!bolted) elsewhere_.insert({"body", world_name});
  for (const files::XmlElement& site : elements_in(world, "site")) {
    const auto name = site.attribute("name");
    if (name && bolted) add(site, sites_, *name);
    if (name && !bolted) elsewhere_.insert({"site", *name});
  }
  for (const files::XmlElement& geom : elements_in(world, "geom")) {
    if (const auto name = geom.attribute("name")) elsewhere_.insert({"geom", *name});
  }
}

void MjcfNames::walk_elsewhere(const files::XmlElement& body) {
  if (const auto name = body.attribute("name")) elsewhere_.insert({"body", *name});
  for (const char* tag : {"joint", "freejoint", "site", "geom"}) {
    for (const files::XmlElement& element : elements_in(body, tag)) {
      const auto name = element.attribute("name");
      if (name) elsewhere_.insert({tag == std::string_view("freejoint") ? "joint" : tag, *name});
    }
  }
  for (const files::XmlElement& child : elements_in(body, "body")) walk_elsewhere(child);
}

void MjcfNames::walk(const files::XmlElement& body) {
  add(body, bodies_, fmt::format("body_{}", bodies_.names.size() + 1));
  name_all(body, "joint", joints_);
  // A free joint is not a joint of a Model: only its given name is taken.
  for (const files::XmlElement& joint : elements_in(body, "freejoint")) {
    if (joint.attribute("name")) add(joint, joints_, {});
  }
  name_all(body, "site", sites_);
  name_all(body, "geom", geoms_);
  for (const files::XmlElement& child : elements_in(body, "body")) walk(child);
}

void MjcfNames::name_all(const files::XmlElement& body, const char* tag, Names& names) {
  int unnamed = 0;
  for (const files::XmlElement& element : elements_in(body, tag)) {
    std::string otherwise = fmt::format("{}.{}", of(body), tag);
    if (!element.attribute("name") && ++unnamed > 1) otherwise += fmt::format("{}", unnamed);
    add(element, names, otherwise);
  }
}

void MjcfNames::add(const files::XmlElement& element, Names& names, const std::string& otherwise) {
  const std::string name = element.attribute("name").value_or(otherwise);
  if (name.empty()) element.fail(fmt::format("the name of this {} is empty; give it one", element.tag()));
  const auto [first, fresh] = names.lines.emplace(name, element.line());
  if (!fresh) {
    element.fail(
        fmt::format("{} '{}' appears twice, first in line {}; rename one", element.tag(), name, first->second));
  }
  names.names.push_back(name);
  MUROSIMF_ASSERT(names.names.size() == names.lines.size());
  names_.emplace(element.id(), name);
}

}  // namespace murosimf::robot_formats::mjcf
