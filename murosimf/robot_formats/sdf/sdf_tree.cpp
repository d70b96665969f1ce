#include "murosimf/robot_formats/sdf/sdf_tree.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats::sdf {
namespace {

/// Index of a link; the world has the number after the last link.
int index_of(int link, int links) {
  MUROSIMF_ASSERT(link < links);
  return link < 0 ? links : link;
}

int base_of(int links, const std::vector<SdfEdge>& joints) {
  std::vector<bool> held(static_cast<std::size_t>(links));
  for (const SdfEdge& joint : joints) {
    if (joint.parent < 0 || joint.child < 0) return links;
    held[static_cast<std::size_t>(joint.child)] = true;
  }
  const auto free = std::ranges::find(held, false);
  // A ring of links, each the child of the next: the first one is as good as any.
  return free == held.end() ? 0 : static_cast<int>(free - held.begin());
}

struct Held {
  int joint = -1;
  bool reversed = false;
};

/// Grows the tree from the base, and finds the joint that holds each link.
class Growth {
 public:
  Growth(int links, const std::vector<SdfEdge>& joints, int base)
      : links_(links),
        joints_(joints),
        reached_(static_cast<std::size_t>(links) + 1),
        used_(joints.size()),
        held(reached_.size()) {
    reached_[static_cast<std::size_t>(base)] = true;
    // Each round adds a link, so there are at most as many rounds as links.
    while (grow()) {
    }
  }

  [[nodiscard]] bool is_reached(int index) const { return reached_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool is_used(std::size_t joint) const { return used_[joint]; }

 private:
  /// Adds the best joint from a link in the tree to one outside. False if there is none.
  bool grow() {
    int best = -1;
    std::tuple<int, bool, std::size_t> order{};
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const bool parent = is_reached(index_of(joints_[i].parent, links_)),
                 child = is_reached(index_of(joints_[i].child, links_));
      if (parent == child) continue;  // inside of the tree it would close a loop; outside it is not reached yet
      // Lexicographic: rank, then joints as they are before reversed ones, then the order of the file, so that the tree is unique.
      const std::tuple candidate{joints_[i].rank, child, i};
      if (best >= 0 && order <= candidate) continue;
      best = static_cast<int>(i);
      order = candidate;
    }
    if (best < 0) return false;
    const SdfEdge& joint = joints_[static_cast<std::size_t>(best)];
    const bool reversed = std::get<1>(order);
    const auto next = static_cast<std::size_t>(index_of(reversed ? joint.parent : joint.child, links_));
    MUROSIMF_ASSERT(!reached_[next]);
    reached_[next] = true;
    used_[static_cast<std::size_t>(best)] = true;
    held[next] = {best, reversed};
    return true;
  }

  int links_;
  const std::vector<SdfEdge>& joints_;
  std::vector<bool> reached_, used_;

 public:
  std::vector<Held> held;  ///< by link, then the world
};

}  // namespace

SdfTree make_tree(int links, const std::vector<SdfEdge>& joints) {
  const int base = base_of(links, joints);
  const Growth growth(links, joints, base);
  SdfTree tree;
  // Children of each link, as in the file; the stack below takes the last first.
  std::vector<std::vector<int>> below(static_cast<std::size_t>(links) + 1);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!growth.is_used(i)) {
      if (growth.is_reached(index_of(joints[i].parent, links))) tree.closers.push_back(static_cast<int>(i));
      continue;
    }
    const int child = index_of(joints[i].child, links), parent = index_of(joints[i].parent, links);
    const bool reversed = growth.held[static_cast<std::size_t>(child)].joint != static_cast<int>(i);
    below[static_cast<std::size_t>(reversed ? child : parent)].push_back(reversed ? parent : child);
  }
  std::vector<std::pair<int, int>> open{{base, -1}};
  // An explicit stack: chains of thousands of links must not exhaust that of the program.
  while (!open.empty()) {
    const auto [index, parent] = open.back();
    open.pop_back();
    const Held& held = growth.held[static_cast<std::size_t>(index)];
    MUROSIMF_ASSERT(parent < static_cast<int>(tree.nodes.size()));
    const int node = static_cast<int>(tree.nodes.size());
    tree.nodes.push_back({index == links ? -1 : index, parent, held.joint, held.reversed});
    const auto& children = below[static_cast<std::size_t>(index)];
    for (auto child = children.rbegin(); child != children.rend(); ++child) open.emplace_back(*child, node);
  }
  for (int link = 0; link < links; ++link) {
    if (!growth.is_reached(link)) tree.loose.push_back(link);
  }
  return tree;
}

}  // namespace murosimf::robot_formats::sdf
