#include "murosimf/robot_formats/mjcf/mjcf_trees.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_body.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"

namespace murosimf::robot_formats::mjcf {
namespace {

void count(const files::XmlElement& body, MjcfTree& tree) {
  ++tree.bodies;
  tree.joints += elements_in(body, "joint").size();
  for (const files::XmlElement& child : elements_in(body, "body")) count(child, tree);
}

MjcfTree tree_of(const MjcfChild& child, const MjcfDefaults& defaults) {
  MjcfTree tree{child.element, child.child_class, child.frame};
  tree.mocap = child.element.attribute("mocap").value_or("false") == "true";
  tree.floats = has_free_joint(child.element, child.child_class, defaults);
  count(child.element, tree);
  if (tree.floats && elements_in(child.element, "freejoint").empty())
    --tree.joints;  // a joint of type free is none of the robot's
  return tree;
}

std::vector<MjcfTree> trees_in(const files::XmlElement& root, const MjcfDefaults& defaults,
                               const MjcfCompiler& compiler) {
  std::vector<MjcfTree> trees;
  for (const files::XmlElement& world : root.children("worldbody")) {
    for (const MjcfChild& child : children_in(world, defaults.child_class(world, {}), defaults, compiler)) {
      if (child.element.tag() == "body") trees.push_back(tree_of(child, defaults));
    }
  }
  return trees;
}

/// The largest floating tree; null: there is none.
MjcfTree* largest_floating(std::vector<MjcfTree>& trees) {
  MjcfTree* best = nullptr;
  for (MjcfTree& tree : trees) {
    if (!tree.floats) continue;
    const bool larger =
        best && (tree.joints > best->joints || (tree.joints == best->joints && tree.bodies > best->bodies));
    if (!best || larger) best = &tree;
  }
  return best;
}

bool has_body(const files::XmlElement& body, const std::string& name) {
  const auto children = elements_in(body, "body");
  return body.attribute("name") == name ||
         std::ranges::any_of(children, [&](const files::XmlElement& child) { return has_body(child, name); });
}

/// The tree with a body that the user names.
MjcfTree& tree_with(std::vector<MjcfTree>& trees, const std::string& name, const files::XmlElement& root) {
  const bool is_world = name == world_name;
  const auto found = std::ranges::find_if(trees, [&](const MjcfTree& tree) {
    return is_world ? !tree.floats && !tree.mocap : has_body(tree.body, name);
  });
  if (found == trees.end() && is_world) root.fail("body 'world': nothing is bolted to the world");
  if (found == trees.end()) {
    std::vector<std::string> names;
    for (const MjcfTree& tree : trees) names.push_back(tree.body.attribute("name").value_or(""));
    root.fail(unknown_name("body", name, {names.begin(), names.end()}));
  }
  if (found->mocap) root.fail(fmt::format("body '{}' is no robot: software moves it (mocap)", files::one_line(name)));
  return *found;
}

std::string name_of(const MjcfTree& tree) {
  return files::one_line(fmt::format("body '{}'", tree.body.attribute("name").value_or("")));
}

const char* why_left_out(const MjcfTree& tree) {
  if (tree.mocap) return "software moves it (mocap)";
  return tree.floats ? "it floats beside the robot: give it a file of its own"
                     : "it stands in the world and is no part of the robot";
}

void name_the_rest(const MjcfTrees& trees, robot_formats::RobotDescription& description) {
  const auto& all = trees.all;
  for (const MjcfTree& tree : all) {
    if (tree.of_robot) continue;
    const std::string what = name_of(tree);
    description.unused.push_back(
        {what, fmt::format("{}: {} is left out: {}", tree.body.where(), what, why_left_out(tree))});
  }
  if (!trees.bolted) return;
  const auto first = std::ranges::find_if(all, &MjcfTree::of_robot);
  MUROSIMF_ASSERT(first != all.end());
  description.notes.push_back(
      fmt::format("{}: {} is bolted to the world, since it has no free joint; for a robot that moves freely "
                  "add <freejoint/> to it",
                  first->body.where(), name_of(*first)));
}

}  // namespace

MjcfTrees find_trees(const files::XmlElement& root, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                     const std::string& wanted, robot_formats::RobotDescription& description) {
  MjcfTrees trees{trees_in(root, defaults, compiler)};
  std::size_t bolted_joints = 0;
  bool any_bolted = false;
  for (const MjcfTree& tree : trees.all) {
    if (tree.floats || tree.mocap) continue;
    bolted_joints += tree.joints;
    any_bolted = true;
  }
  MjcfTree* chosen = largest_floating(trees.all);
  if (!chosen && !any_bolted) root.fail("there is no body in worldbody; a robot needs one");
  // Everything that is bolted is one robot, and is compared by all of its joints.
  trees.bolted = !chosen || bolted_joints > chosen->joints;
  if (!wanted.empty()) {
    chosen = &tree_with(trees.all, wanted, root);
    trees.bolted = !chosen->floats;
  }
  for (MjcfTree& tree : trees.all) tree.of_robot = trees.bolted ? !tree.floats && !tree.mocap : &tree == chosen;
  name_the_rest(trees, description);
  return trees;
}

}  // namespace murosimf::robot_formats::mjcf
