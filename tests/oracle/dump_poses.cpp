/// dump_poses - poses of kid21 in random joint positions, as JSON, for kid21_against_mujoco.py.
///
/// The base stands at `base` with axes parallel to the world's. Per state: joint positions q [rad]; position [m] and
/// orientation (rotation matrix, row by row) of every joint and sole; the common center of mass [m]; world frame.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/random.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "murosimf/robot/robot_reader.h"

namespace {

using namespace murosimf;

constexpr int states = 50;
constexpr Vec3d base{0.1, -0.2, 0.5};  // [m] anywhere but the origin

std::string list(const Vec3d& v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z); }

std::string rows(const Mat3d& m) {
  const Mat3d t = transpose(m);
  return fmt::format("[{}, {}, {}]", list(t.x), list(t.y), list(t.z));
}

std::vector<int> shown_objects(const Model& model) {
  std::vector<int> objects(model.joints().begin(), model.joints().end());
  for (const int sole : model.having(properties::sole)) objects.push_back(sole);
  return objects;
}

std::string state(const Model& model, const RandomStream& random, int number) {
  const auto size = static_cast<std::size_t>(model.size());
  std::vector<double> q(size);
  std::vector<Vec3d> r(size), zero(size);
  std::vector<Mat3d> R(size);
  std::vector<std::string> positions, objects;
  for (const int joint : model.joints()) {
    q[joint] = random.uniform(static_cast<std::uint64_t>(number) * size + static_cast<std::uint64_t>(joint), -1.5, 1.5);
    positions.push_back(fmt::format("\"{}\": {:.17g}", model.objects()[joint].name, q[joint]));
  }
  r[0] = base;
  multibody::poses<double>(model.tree(), q, r, R);
  const auto body = multibody::common_body<double>(model.tree(), r, R, zero, zero);
  for (const int i : shown_objects(model)) {
    objects.push_back(fmt::format("\"{}\": {{\"position\": {}, \"orientation\": {}}}", model.objects()[i].name,
                                  list(r[i]), rows(R[i])));
  }
  return fmt::format("{{\"q\": {{{}}},\n \"objects\": {{{}}},\n \"center_of_mass\": {}}}", fmt::join(positions, ", "),
                     fmt::join(objects, ",\n  "), list(body.center));
}

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path file =
      count > 1 ? std::filesystem::path(arguments[1]) : std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml";
  try {
    const auto model = robot::read_robot(file, {.guess = false}).model;
    const RandomStream random(1, "kid21_against_mujoco");
    std::vector<std::string> all;
    for (int i = 0; i < states; ++i) all.push_back(state(*model, random, i));
    fmt::print("{{\"base\": {}, \"total_mass\": {:.17g},\n\"states\": [{}]}}\n", list(base), model->tree().mass,
               fmt::join(all, ",\n"));
  } catch (const SetupError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
