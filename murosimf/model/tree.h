/// tree.h - a model's tree reduced to its moving links: the form that kernels use.
///
/// A link is the base or a joint together with everything rigidly fixed to it. Links are in topological order,
/// parents first; masses that sit on fixed objects are merged into their link.
#pragma once

#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/model/constants.h"
#include "murosimf/model/object.h"

namespace murosimf {

enum class LinkKind { base, revolute, prismatic };

/// Joints along a coordinate axis, the common case, cost less: kernels branch on this.
enum class AxisKind { x, y, z, general };

struct Link {
  int object = 0;   ///< index of the base or joint object: its frame is the link's frame
  int parent = -1;  ///< index of the parent link
  LinkKind kind = LinkKind::base;
  AxisKind axis_kind = AxisKind::general;
  Vec3d axis;                     ///< unit joint axis, link frame
  Vec3d offset;                   ///< [m] joint origin in the parent link's frame
  Mat3d turn;                     ///< joint axes at joint position zero to the parent link's axes
  bool turned = false;            ///< turn is not the identity
  double mass = 0;                ///< [kg]
  Vec3d com;                      ///< [m] center of mass, link frame
  SymMat3d inertia;               ///< [kg m^2] at the center of mass, link frame
  bool diagonal_inertia = false;  ///< its products of inertia are zero
};

/// An object that is fixed to its link.
struct FixedObject {
  int object = 0;
  int link = 0;
  Vec3d offset;  ///< [m] its origin in the link's frame
  Mat3d turn;    ///< its axes to the link's axes
  bool turned = false;
};

struct Tree {
  Tree() = default;
  Tree(const std::vector<Object>& objects, const ConstantTable& constants);

  std::vector<Link> links;
  std::vector<FixedObject> fixed;      ///< all of them
  std::vector<FixedObject> followers;  ///< those whose poses are kept in every step: all but the structural ones
  std::vector<int> link_of;            ///< [objects] the link that an object moves with
  double mass = 0;                     ///< [kg] of all links
};

}  // namespace murosimf
