/// murosimf_peer_murosimf - our own program in a race: levels of detail are its settings. Its own controllers run in the steps; targets
/// of the description are those that they gave before.
#include "benchmarks/peers/peer.h"
#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;

class Ours final : public peers::Engine {
 public:
  explicit Ours(const peers::Options& options)
      : scene_(options.folder / "scene.toml",
               {.threads = options.threads, .overrides = {"*.level=" + options.setting}, .cameras = false}) {
    scene_.simulation().initialize();
    for (const auto& robot : scene_.spec().robots) robots_.push_back(&scene_.simulation().world().entity(robot.name));
  }

  void set_targets(std::span<const double> /*targets*/) override {}
  void step() override { scene_.simulation().step(); }

  peers::View view() override {
    peers::View view;
    for (Entity* robot : robots_) {
      const Vec3d r = robot->base().get(properties::position);
      peers::View::Robot shown{{r.x, r.y, r.z}, robot->base().get(properties::orientation).z.z, {}};
      const auto& joints = robot->find(properties::joint_position)->values;
      const auto& links = robot->model().tree().links;
      for (std::size_t i = 1; i < links.size(); ++i)
        shown.joints.push_back(joints[static_cast<std::size_t>(links[i].object)]);
      view.robots.push_back(std::move(shown));
      if (const auto* contacts = robot->find(collision::contacts)) count(contacts->values[0].points, view);
    }
    if (const auto* pairs = scene_.simulation().world().common().find(collision::pair_contacts)) {
      count(pairs->values[0].points, view);
    }
    return view;
  }

 private:
  static void count(const auto& points, peers::View& view) {
    view.contacts += static_cast<int>(points.size());
    for (const auto& point : points) view.depth = std::max(view.depth, point.depth);
  }

  scene::Scene scene_;
  std::vector<Entity*> robots_;
};

}  // namespace

int main(int count, char** arguments) {
  return peers::race(count, arguments, "MuRoSimF",
                     {"articulated_dynamics", "full_dynamics", "simplified_dynamics", "kinematic_walking"},
                     [](const peers::Description&, const peers::Options& options) {
                       return std::make_unique<Ours>(options);
                     });
}
