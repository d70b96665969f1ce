// An algorithm of one's own: it watches how far a walking robot's head nods (docs/add_an_algorithm.md).
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>

using namespace murosimf;

namespace {

/// A property of one's own: typed, with unit and meaning, visible by name like all others.
constexpr Property<double> largest_nod{
    {"largest_nod", "rad", "world", "largest pitch of the head so far", Scope::base}};

class NodWatcher final : public Algorithm {
 public:
  explicit NodWatcher(Setup& setup)
      : head_(setup.model().object_index("head")),
        orientation_(setup.read(properties::orientation)),  // taking a span declares the access
        largest_(setup.write(largest_nod)[0]) {}

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override { largest_ = 0; }
  void step(const Instant&) noexcept override {
    largest_ = std::max(largest_, std::abs(std::asin(orientation_[head_].x.z)));
  }

 private:
  int head_;
  std::span<const Mat3d> orientation_;
  double& largest_;
};

}  // namespace

int main() {
  for (const char* level : {"kinematic_walking", "simplified_dynamics"}) {
    scene::Scene scene("walk", {.overrides = {std::string("walker.level=") + level}});
    Simulation& simulation = scene.simulation();
    Entity& walker = simulation.world().entity("walker");
    simulation.attach<NodWatcher>("nod_watcher", walker, 100);
    simulation.run(std::chrono::seconds(10));
    const Quantity nod = walker.base().get("largest_nod");
    std::printf("%-20s the head nods by up to %.2f degrees\n", level, nod.numbers[0] * 180 / pi);
  }
}
