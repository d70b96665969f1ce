#include "murosimf/robot/mesh_up_axis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot_formats/mesh/dae_file.h"

namespace murosimf::robot {
namespace {

using robot_formats::BodyDescription;
using robot_formats::MeshDescription;
using robot_formats::RobotDescription;
using robot_formats::ShapeDescription;

constexpr double plain = 0.01;     // [m] more than masses and places of symmetric robots differ
constexpr std::size_t better = 4;  // turned meshes must leave at most a quarter of the asymmetric pairs

constexpr Mat3d y_to_z{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};  // a quarter about x

using Names = std::set<std::string>;

bool is_dae(const MeshDescription& mesh) { return files::lower_case(mesh.file.extension().string()) == ".dae"; }

/// Names of meshes for which `belongs` is true.
template <class Rule>
Names meshes_of(const RobotDescription& description, const Rule& belongs) {
  Names names;
  for (const MeshDescription& mesh : description.meshes) {
    if (belongs(mesh)) names.insert(mesh.name);
  }
  return names;
}

/// The mesh frame of a shape in the body.
Transformd mesh_place(const ShapeDescription& shape) {
  return shape.placed.place() * Transformd{-1.0 * shape.middle, {}};
}

/// A left part and its right one.
struct Pair {
  const ShapeDescription *left, *right;
  Transformd left_body, right_body;  ///< in the frame of the base
};

std::vector<Pair> pairs_of(const RobotDescription& description, const Names& meshes) {
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) numbers.emplace(description.bodies[i].name, i);
  const auto places = body_places(description);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const auto other = numbers.find(right_name(description.bodies[i].name));
    if (other == numbers.end() || other->second == i) continue;
    const auto &left = description.bodies[i].shapes, &right = description.bodies[other->second].shapes;
    if (left.size() != right.size()) continue;
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (!meshes.contains(left[k].mesh) || !meshes.contains(right[k].mesh)) continue;
      MUROSIMF_ASSERT(i < places.size() && other->second < places.size());
      pairs.push_back({&left[k], &right[k], places[i], places[other->second]});
    }
  }
  return pairs;
}

/// The plane between left and right: across the axis of the base along which their bodies stand apart.
class Mirror {
 public:
  explicit Mirror(const std::vector<Pair>& pairs) {
    MUROSIMF_ASSERT(!pairs.empty());
    Vec3d apart;
    for (const Pair& pair : pairs) apart += pair.left_body.position - pair.right_body.position;
    along_x_ = std::abs(apart.x) > std::abs(apart.y);
    std::vector<double> middles;  // their median: one misplaced part does not move the plane
    for (const Pair& pair : pairs) {
      const Vec3d middle = 0.5 * (pair.left_body.position + pair.right_body.position);
      middles.push_back(along_x_ ? middle.x : middle.y);
    }
    std::ranges::sort(middles);
    at_ = middles[middles.size() / 2];
  }
  [[nodiscard]] Vec3d operator()(const Vec3d& v) const {
    return along_x_ ? Vec3d{2 * at_ - v.x, v.y, v.z} : Vec3d{v.x, 2 * at_ - v.y, v.z};
  }

 private:
  bool along_x_ = false;
  double at_ = 0;  // [m]
};

struct Asymmetry {
  std::size_t pairs = 0;  ///< that are clearly no mirror images
  double most = 0;        ///< [m]
};

/// With the meshes named `turned`.
Asymmetry asymmetry(const std::vector<Pair>& pairs, const Names& turned) {
  const Mirror mirror(pairs);
  const auto middle = [&](const ShapeDescription& shape, const Transformd& body) {
    const Mat3d turn = turned.contains(shape.mesh) ? y_to_z : Mat3d{};
    return (body * mesh_place(shape) * Transformd{turn * shape.middle, {}}).position;
  };
  Asymmetry all;
  for (const Pair& pair : pairs) {
    const double d = norm(mirror(middle(*pair.left, pair.left_body)) - middle(*pair.right, pair.right_body));
    if (d > plain) ++all.pairs;
    all.most = std::max(all.most, d);
  }
  return all;
}

/// False for a mesh that cannot be read: drawing it reports the error.
bool is_y_up(const MeshDescription& mesh) {
  try {
    return is_dae(mesh) && robot_formats::mesh::has_y_up(mesh.file);
  } catch (const SetupError&) {
    return false;
  }
}

void turn(RobotDescription& description, const Names& meshes) {
  const Transformd up{{}, y_to_z};
  for (BodyDescription& body : description.bodies) {
    for (ShapeDescription& shape : body.shapes) {
      if (!meshes.contains(shape.mesh)) continue;
      const Transformd there = mesh_place(shape) * up * Transformd{shape.middle, {}};
      shape.placed.position = there.position;
      shape.placed.orientation = there.orientation;
    }
    for (robot_formats::VisualDescription& visual : body.visuals) {
      if (meshes.contains(visual.mesh)) visual.place = visual.place * up;
    }
  }
}

}  // namespace

void turn_meshes_up(RobotDescription& description) {
  const auto pairs = pairs_of(description, meshes_of(description, is_dae));
  if (pairs.empty()) return;
  const Asymmetry before = asymmetry(pairs, {});
  if (before.pairs == 0) return;
  const Names turned = meshes_of(description, is_y_up);
  const bool uneven = std::ranges::any_of(description.meshes, [&](const MeshDescription& mesh) {
    // An uneven scale would apply to other axes after the turn.
    return turned.contains(mesh.name) && (mesh.scale.x != mesh.scale.y || mesh.scale.x != mesh.scale.z);
  });
  if (uneven || better * asymmetry(pairs, turned).pairs > before.pairs) return;
  turn(description, turned);
  description.notes.push_back(
      fmt::format("{}: {} COLLADA meshes with y up are turned, so that z is: else left and right would be {:.2g} m "
                  "from being mirror images",
                  description.bodies[0].where, turned.size(), before.most));
}

}  // namespace murosimf::robot
