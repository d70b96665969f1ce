/// spatial_tendon.h - a tendon that runs through points of a robot's bodies, and around spheres and cylinders on them: a slider at the base
/// that stands at its length, as that of a tendon over joints (joint_tendon.h).
///
/// A branch with the divisor d counts with 1/d of its length (a pulley: half of it, where two ends of a string hang from one wheel):
///
///     L(q) = sum_branches 1/d (straight pieces + pieces on obstacles)
///     dL/dq_i = sum_straight pieces 1/d u . (dx_b/dq_i - dx_a/dq_i),   u = (x_b - x_a) / |x_b - x_a|
///
/// with x_a, x_b as points of the bodies at the ends of a piece. Pieces on obstacles add nothing to the slope, as where a shortest path
/// touches moves, to first order, at no cost of length. A force F along the tendon is a torque dL/dq_i F at joint i.
/// Source: first variation of length (do Carmo, Differential Geometry of Curves and Surfaces, sec. 5-4); MuJoCo documentation, "Tendon".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/math/taut_string.h"
#include "murosimf/model/model.h"
#include "murosimf/multibody/joint_tendon.h"

namespace murosimf {

struct SpatialTendon {
  struct Place {
    std::string object;  ///< name in the same model
    Transformd place{};  ///< in the object's frame
  };
  struct Part {
    Place at;                   ///< of a point its position
    double radius = 0;          ///< [m] 0: a point, else an obstacle
    bool cylinder = false;      ///< of an obstacle, about z; else it is a sphere
    std::optional<Place> side;  ///< of an obstacle: its position is where the string is
  };
  struct Branch {
    double divisor = 1;       ///< [1] more than 0
    std::vector<Part> parts;  ///< ends are points, obstacles stand between two points
  };
  std::vector<Branch> branches;
};

}  // namespace murosimf

namespace murosimf::properties {

inline constexpr Property<SpatialTendon> spatial_tendon{
    {"spatial_tendon", "-", "joint", "the points whose string this one is as long as"}};

}  // namespace murosimf::properties

namespace murosimf::multibody {

/// Whether a joint (an object) is the slider of a tendon, which moves nothing by itself.
[[nodiscard]] inline bool is_tendon(const Model& model, int joint) {
  return model.find(properties::joint_tendon, joint) || model.find(properties::spatial_tendon, joint);
}

/// Length and slopes of a tendon.
class TendonPath {
 public:
  /// Throws SetupError if an object does not exist, or a number or the order of the parts is impossible.
  TendonPath(const Model& model, const SpatialTendon& tendon);

  /// Joints (objects) between the bodies of the tendon.
  [[nodiscard]] std::span<const int> joints() const { return joints_; }
  /// For the positions q [rad | m] by object. `slopes`: dL/dq [m/rad | 1] of joints(), in their order. Returns L [m].
  double look(std::span<const double> q, std::span<double> slopes) const noexcept;

 private:
  struct Part {
    int link = 0;
    Transformd place;         // in the link's frame
    StringObstacle obstacle;  // radius 0: a point
    int side_link = -1;       // -1: the obstacle has no side
    Vec3d side;               // [m] in that link's frame
  };
  struct Branch {
    double share = 1;  // [1] of its length
    std::vector<Part> parts;
  };
  [[nodiscard]] Part part(const Model& model, const SpatialTendon::Part& given);
  void find_joints();
  void place_links(std::span<const double> q) const noexcept;
  void lay(const Branch& branch) const noexcept;

  const Tree* tree_;
  std::vector<Branch> branches_;
  std::vector<int> links_;   // all that have to be placed, parents first
  std::vector<int> joints_;  // objects
  std::vector<int> column_;  // [links] in joints_; -1: none
  // Working memory.
  mutable std::vector<Transformd> places_;  // [links] seen from the base
  mutable std::vector<Vec3d> axes_;         // [links]
  mutable std::vector<StringPart> string_;  // of the branch at hand
};

}  // namespace murosimf::multibody
