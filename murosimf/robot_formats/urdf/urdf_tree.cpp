#include "murosimf/robot_formats/urdf/urdf_tree.h"

#include <map>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

using Index = std::map<std::string, int, std::less<>>;

void add_name(Index& index, const std::string& name, const files::XmlElement& element) {
  const int number = static_cast<int>(index.size());
  if (index.emplace(name, number).second) return;
  element.fail(fmt::format("{} '{}' is already there; choose another name", element.tag(), name));
}

int known_link(const Index& links, const files::XmlElement& joint, const char* end) {
  const files::XmlElement element = needed_child(joint, end);
  const std::string name = needed_text(element, "link");
  if (const auto found = links.find(name); found != links.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [link, number] : links) known.push_back(link);
  element.fail(unknown_name("link", name, known));
}

std::string read_type(const files::XmlElement& joint, const std::string& name) {
  std::string type = needed_text(joint, "type");
  if (type == "planar") {
    joint.fail(fmt::format("planar joint '{}' is not supported; use two prismatic joints and a revolute one", name));
  }
  for (const char* known : {"revolute", "continuous", "prismatic", "fixed", "floating"}) {
    if (type == known) return type;
  }
  joint.fail(unknown_name("type of joint", type, {"revolute", "continuous", "prismatic", "fixed", "floating"}));
}

void read_links(const files::XmlElement& robot, UrdfTree& tree, Index& names) {
  for (const files::XmlElement& element : robot.children("link")) {
    const std::string name = needed_text(element, "name");
    add_name(names, name, element);
    tree.links.push_back({name, element});
  }
  if (tree.links.empty()) robot.fail("there is no link; a robot needs one");
}

void connect(UrdfTree& tree, int number) {
  MUROSIMF_ASSERT(number >= 0 && static_cast<std::size_t>(number) < tree.joints.size());
  const UrdfJoint& joint = tree.joints[number];
  UrdfLink& child = tree.links[joint.child];
  if (joint.parent == joint.child) {
    joint.element.fail(fmt::format("joint '{}' joins link '{}' to itself; correct it", joint.name, child.name));
  }
  if (child.joint >= 0) {
    joint.element.fail(fmt::format("link '{}' has two parents, by joints '{}' and '{}'; remove one", child.name,
                                   tree.joints[child.joint].name, joint.name));
  }
  child.joint = number;
  tree.links[joint.parent].children.push_back(number);
}

/// Makes a joint fixed if its limits hold it at one position.
void fix_held(UrdfJoint& joint, UrdfLog& log) {
  if (joint.type != "revolute" && joint.type != "prismatic") return;
  const auto limit = only_child(joint.element, "limit");
  if (!limit) return;
  const double lower = number_or(*limit, "lower", 0), upper = number_or(*limit, "upper", 0);
  const bool is_written = limit->attribute("lower") || limit->attribute("upper");
  if (lower != upper || !is_written) return;
  joint.type = "fixed";
  joint.held_at = lower;
  log.warn(*limit, fmt::format("joint '{}' cannot move: lower and upper limit are both {}; it is read as fixed",
                               joint.name, lower));
}

/// Makes a joint fixed if it follows one that cannot move. True if it does.
bool fix_follower(UrdfJoint& joint, const std::vector<UrdfJoint>& joints, const Index& names, UrdfLog& log) {
  const auto mimic =
      joint.type == "fixed" || joint.type == "floating" ? std::nullopt : only_child(joint.element, "mimic");
  const auto leader = mimic ? names.find(needed_text(*mimic, "joint")) : names.end();
  if (leader == names.end() || joints[leader->second].type != "fixed") return false;
  joint.type = "fixed";
  joint.held_at = number_or(*mimic, "offset", 0) + number_or(*mimic, "multiplier", 1) * joints[leader->second].held_at;
  log.warn(*mimic, fmt::format("joint '{}' cannot move: it mimics '{}', which is fixed; it is read as fixed at {}",
                               joint.name, leader->first, joint.held_at));
  return true;
}

/// Repeats until there are no more: followers may be followed. Each round fixes a joint, so it ends.
void fix_followers(UrdfTree& tree, const Index& names, UrdfLog& log) {
  bool more = true;
  while (more) {
    more = false;
    for (UrdfJoint& joint : tree.joints) more = fix_follower(joint, tree.joints, names, log) || more;
  }
}

void read_joints(const files::XmlElement& robot, UrdfTree& tree, const Index& links, UrdfLog& log) {
  Index names;
  for (const files::XmlElement& element : robot.children("joint")) {
    const std::string name = needed_text(element, "name");
    add_name(names, name, element);
    const std::string type = read_type(element, name);
    const int number = static_cast<int>(tree.joints.size());
    tree.joints.push_back(
        {name, type, element, known_link(links, element, "parent"), known_link(links, element, "child")});
    fix_held(tree.joints.back(), log);
    connect(tree, number);
  }
  fix_followers(tree, names, log);
}

int find_root(const UrdfTree& tree) {
  int root = -1;
  for (int i = 0; i < static_cast<int>(tree.links.size()); ++i) {
    if (tree.links[i].joint >= 0) continue;
    if (root >= 0) {
      tree.links[i].element.fail(fmt::format("link '{}' is a second root beside '{}'; add a joint that holds it",
                                             tree.links[i].name, tree.links[root].name));
    }
    root = i;
  }
  MUROSIMF_ASSERT(!tree.links.empty());
  if (root < 0) {
    const UrdfJoint& joint = tree.joints[tree.links[0].joint];
    joint.element.fail(fmt::format("joint '{}' is part of a circle: no link is without parent; open it", joint.name));
  }
  return root;
}

/// The links below `root`, parents first, branches in the order of the file.
std::vector<int> below(const UrdfTree& tree, int root) {
  // An explicit stack takes the last child first.
  std::vector<int> order, open{root};
  while (!open.empty()) {
    const int link = open.back();
    open.pop_back();
    order.push_back(link);
    const auto& children = tree.links[link].children;
    for (auto joint = children.rbegin(); joint != children.rend(); ++joint) open.push_back(tree.joints[*joint].child);
  }
  MUROSIMF_ASSERT(order.front() == root && order.size() <= tree.links.size());
  return order;
}

void check_reached(const UrdfTree& tree, const std::vector<int>& order) {
  std::vector<bool> reached(tree.links.size());
  for (const int link : order) reached[link] = true;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) continue;
    const UrdfJoint& joint = tree.joints[tree.links[i].joint];
    // Such links have parents, so find_root() did not count them.
    joint.element.fail(fmt::format("joint '{}' is part of a circle that the root '{}' does not reach; open it",
                                   joint.name, tree.links[order[0]].name));
  }
}

bool is_empty(const UrdfLink& link) { return link.element.children().empty(); }

/// The robot's base: the root, or the floating link below it. An empty root called "world" is the world, as in Gazebo.
int find_base(UrdfTree& tree, int root, UrdfLog& log) {
  const UrdfLink& link = tree.links[root];
  if (link.children.empty() || !is_empty(link)) return root;
  const UrdfJoint& joint = tree.joints[link.children[0]];
  if (joint.type == "floating" && link.children.size() == 1) {
    log.note(joint.element,
             fmt::format("link '{}' stands for the world and is left out; the scene places the robot", link.name));
    return joint.child;
  }
  if (link.name == "world") {
    tree.bolted = true;
    log.note(link.element, "the robot is bolted to the world, since its root is an empty link 'world'");
  }
  return root;
}

void refuse_floating(const UrdfTree& tree, int base) {
  for (const UrdfJoint& joint : tree.joints) {
    if (joint.type != "floating" || joint.child == base) continue;
    joint.element.fail(fmt::format("floating joint '{}' inside the robot; only its base may float", joint.name));
  }
}

template <class Entries>
int find(const Entries& entries, std::string_view name) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

int UrdfTree::find_link(std::string_view name) const { return find(links, name); }
int UrdfTree::find_joint(std::string_view name) const { return find(joints, name); }

UrdfTree read_tree(const files::XmlElement& robot, UrdfLog& log) {
  UrdfTree tree;
  Index names;
  read_links(robot, tree, names);
  read_joints(robot, tree, names, log);
  const int root = find_root(tree);
  check_reached(tree, below(tree, root));
  const int base = find_base(tree, root, log);
  refuse_floating(tree, base);
  MUROSIMF_ASSERT(base >= 0);
  tree.order = below(tree, base);
  return tree;
}

}  // namespace murosimf::robot_formats::urdf
