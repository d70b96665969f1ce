/// loops.h - loops of a tree: pairs of its frames that coincide although links are between them (linkages).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "murosimf/model/model.h"

namespace murosimf {

/// The origin of the object with this property coincides with that of another one, and if `welded` the axes as well.
struct LoopClosure {
  std::string other;  ///< name of an object of the same model
  bool welded = false;
};

}  // namespace murosimf

namespace murosimf::properties {

inline constexpr Property<LoopClosure> loop_closure{
    {"loop_closure", "-", "-", "the frame in whose place this one is held, which closes a loop"}};
inline constexpr Property<double> loop_commanded{
    {"loop_commanded", "1", "joint", "it takes targets, and servos of its loops' other joints follow them"}};

}  // namespace murosimf::properties

namespace murosimf::multibody {

struct Loop {
  struct End {
    FixedObject frame;
    std::vector<int> path;  ///< links from the last common link of both ends (excluded) to the frame's link
  };
  int object = 0;           ///< object with the closure: the frame of ends[1]
  std::array<End, 2> ends;  ///< the other object's frame, the object's
  bool welded = false;

  [[nodiscard]] int rows() const { return welded ? 6 : 3; }
};

/// All loops in the order of their objects. Throws SetupError if an object does not exist, or both are on the same link.
[[nodiscard]] std::vector<Loop> loops_of(const Model& model);

/// Whether a joint (an object) is a part of a loop.
[[nodiscard]] bool is_in(const Model& model, const Loop& loop, int joint);
/// Whether a joint (an object) is a part of any of the loops.
[[nodiscard]] bool is_in_loop(const Model& model, const std::vector<Loop>& loops, int joint);

}  // namespace murosimf::multibody
