/// sdf_tree.h - links and joints of an SDF model as a tree, and the joints that close its loops.
///
/// In SDF a link may be the child of several joints, and of none. The tree begins at the world if a joint holds the model there, else at
/// the first link that is no joint's child, and grows joint by joint: fixed joints first, ball joints last, so that loops are
/// closed by these where possible; joints in their own direction before reversed ones.
#pragma once

#include <vector>

namespace murosimf::robot_formats::sdf {

/// A joint between two links, by their numbers; -1 is the world.
struct SdfEdge {
  int parent = -1, child = -1;
  int rank = 0;  ///< those with a lower one are preferred in the tree
};

struct SdfNode {
  int link = -1;          ///< -1: the world
  int parent = -1;        ///< node; -1: the base
  int joint = -1;         ///< edge to the parent
  bool reversed = false;  ///< the joint's child is the parent here
};

struct SdfTree {
  std::vector<SdfNode> nodes;  ///< the base, then parents before children, branches in the order of joints
  std::vector<int> closers;    ///< joints that close loops
  std::vector<int> loose;      ///< links without a joint
};

/// `links`: their number; at least one unless a joint holds the world.
[[nodiscard]] SdfTree make_tree(int links, const std::vector<SdfEdge>& joints);

}  // namespace murosimf::robot_formats::sdf
