/// object.h - the seven basic objects of which every model is made (paper 3.1, table 1).
#pragma once

#include <string>

#include "murosimf/math/mat3.h"

namespace murosimf {

enum class Kind { base, translation, rotation, revolute, prismatic, fork, endpoint };

[[nodiscard]] constexpr const char* kind_name(Kind kind) {
  constexpr const char* names[] = {"base", "translation", "rotation", "revolute", "prismatic", "fork", "endpoint"};
  return names[static_cast<int>(kind)];
}

/// One element of a model's tree: a transformation relative to the object before it.
struct Object {
  Kind kind = Kind::base;
  int parent = -1;   ///< index of the object before it, -1 for the base; parents come first
  Vec3d vector;      ///< translation: shift [m]; joints: unit axis; both in the parent's frame
  Mat3d turn;        ///< rotation: this object's axes to the parent's
  std::string name;  ///< unique in the model
  /// Only gives the tree its shape and carries nothing: its pose is not updated in every step but computed when it
  /// is requested by name.
  bool structural = false;

  [[nodiscard]] bool is_joint() const { return kind == Kind::revolute || kind == Kind::prismatic; }
};

}  // namespace murosimf
