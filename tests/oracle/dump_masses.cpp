/// dump_masses - mass and shapes of the base of robots, as JSON, for meshes_against_mujoco.py.
///
/// For each MJCF file given: mass [kg], center [m], inertia at the center [kg m^2] (xx yy zz xy xz yz), and for each
/// hull the lowest and the highest corner of its box [m]; body frame.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"

namespace {

using namespace murosimf;

std::string list(const Vec3d& v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z); }

std::string box(const PlacedShape& placed) {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Vec3d& vertex : std::get<Convex>(placed.shape).hull->vertices) {
    const Vec3d v = placed.position + placed.orientation * vertex;
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return fmt::format("[{}, {}]", list(low), list(high));
}

std::string base(const Model& model) {
  const SymMat3d& I = *model.find(properties::inertia, 0);
  std::vector<std::string> boxes;
  for (const PlacedShape& shape : *model.find(properties::shapes, 0)) boxes.push_back(box(shape));
  return fmt::format(
      "{{\"mass\": {:.17g}, \"center\": {}, \"inertia\": [{:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}],\n"
      " \"boxes\": [{}]}}",
      *model.find(properties::mass, 0), list(*model.find(properties::center_of_mass, 0)), I.xx, I.yy, I.zz, I.xy, I.xz,
      I.yz, fmt::join(boxes, ", "));
}

}  // namespace

int main(int count, char** arguments) {
  try {
    std::vector<std::string> all;
    for (int i = 1; i < count; ++i) all.push_back(base(*robot::read_robot(arguments[i], {.guess = false}).model));
    fmt::print("[{}]\n", fmt::join(all, ",\n"));
  } catch (const SetupError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
