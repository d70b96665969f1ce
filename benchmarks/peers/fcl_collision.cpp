/// murosimf_peer_fcl FOLDER --setting "tree per robot" --warm 3 --seconds 2 - what it costs FCL to find the contacts of FOLDER's scene, among
/// robots and with the ground, in every step while our program moves them: transforms, trees, exact tests; and what it costs ours, by the probe
/// of `murosimf bench collision`. Prints medians [us], and how many pairs of bodies touched, as FCL and as our program found them.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "apps/collision_probe.h"
#include "benchmarks/peers/fcl_world.h"
#include "benchmarks/peers/options.h"
#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

using peers::FclWorld;

using Robots = std::vector<const Entity*>;

Robots robots_of(scene::Scene& scene) {
  Robots robots;
  for (const auto& robot : scene.spec().robots) robots.push_back(&scene.simulation().world().entity(robot.name));
  return robots;
}

const app::CollisionProbe& attach_probe(scene::Scene& scene) {
  World& world = scene.simulation().world();
  std::vector<Entity*> robots;
  for (const auto& robot : scene.spec().robots) robots.push_back(&world.entity(robot.name));
  return scene.simulation().attach<app::CollisionProbe>("collision_probe", world.entity("field"), scene.spec().rate,
                                                        robots, scene.spec().materials);
}

/// The same of ours: pairs of bodies of different robots that touch; bodies on the ground.
int our_pairs(const World& world) {
  std::set<std::tuple<int, int, int, int>> pairs;
  if (const auto* set = world.common().find(collision::pair_contacts)) {
    for (const auto& point : set->values[0].points) pairs.emplace(point.a, point.b, point.object, point.object_b);
  }
  return static_cast<int>(pairs.size());
}
int our_ground(const Robots& robots) {
  std::size_t bodies = 0;
  for (const Entity* robot : robots) {
    std::set<int> touching;
    for (const auto& point : robot->find(collision::contacts)->values[0].points) touching.insert(point.object);
    bodies += touching.size();
  }
  return static_cast<int>(bodies);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// [us] of processor time that `work` takes; its result goes to `sum`.
template <class Work>
double time_of(const Work& work, double& sum) {
  const double begin = peers::processor_seconds();
  sum += work();
  return 1e6 * (peers::processor_seconds() - begin);
}

nlohmann::json measure(const peers::Options& options) {
  scene::Scene scene(options.folder / "scene.toml", {.cameras = false});
  FclWorld fcl(peers::read_description(options.folder / "description.json"), options.setting == "tree per robot");
  scene.simulation().run(from_seconds(options.warm));
  const Robots robots = robots_of(scene);
  const auto& probe = attach_probe(scene);
  std::vector<double> pairs_us, ground_us, ours_pairs_us, ours_ground_us;
  double touching = 0, standing = 0, ours_touching = 0, ours_standing = 0;
  const auto steps = static_cast<int>(options.seconds * scene.spec().rate + 0.5);
  for (int i = 0; i < steps; ++i) {
    scene.simulation()
        .step();  // its contacts are those of the poses before, one step earlier than the probe's and FCL's
    ours_touching += our_pairs(scene.simulation().world());
    ours_standing += our_ground(robots);
    pairs_us.push_back(time_of([&] { return fcl.robots(robots); }, touching));
    ground_us.push_back(time_of([&] { return fcl.ground(); }, standing));
    ours_pairs_us.push_back(probe.samples().back().pairs_us);
    ours_ground_us.push_back(probe.samples().back().ground_us);
  }
  return {{"engine", "FCL"},
          {"setting", options.setting},
          {"pairs_us", median(pairs_us)},
          {"ground_us", median(ground_us)},
          {"ours_pairs_us", median(ours_pairs_us)},
          {"ours_ground_us", median(ours_ground_us)},
          {"touching", touching / steps},
          {"on_ground", standing / steps},
          {"ours_touching", ours_touching / steps},
          {"ours_on_ground", ours_standing / steps}};
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const peers::Options options =
        peers::read_options({arguments, static_cast<std::size_t>(count)}, {"tree per robot", "one tree"});
    std::printf("%s\n", measure(options).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "murosimf_peer_fcl: %s\n", error.what());
    return 1;
  }
}
