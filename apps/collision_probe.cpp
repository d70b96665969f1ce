#include "apps/collision_probe.h"

#include <chrono>

namespace murosimf::app {
namespace {

std::vector<collision::Mover> make_movers(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<collision::Mover> movers;
  for (Entity* entity : entities) movers.emplace_back(setup.of(*entity));
  return movers;
}

std::int64_t count_naive_tests(const std::vector<collision::Mover>& movers, const Entity& environment) {
  const auto still = collision::StaticCompound(&environment).compound().shapes().size() +
                     collision::ground_planes(&environment).size();
  std::size_t tests = 0, before = 0;
  for (const collision::Mover& mover : movers) {
    const std::size_t shapes = mover.compound.shapes().size();
    tests += shapes * (before + still);
    before += shapes;
  }
  return static_cast<std::int64_t>(tests);
}

}  // namespace

CollisionProbe::CollisionProbe(Setup& setup, const std::vector<Entity*>& movers, const MaterialTable& materials)
    : movers_(make_movers(setup, movers)),
      pair_finder_(movers_, materials, norm(setup.world().gravity), seconds(setup.period())),
      naive_(count_naive_tests(movers_, setup.entity())) {
  for (const Entity* entity : movers) ground_finders_.emplace_back(*entity, &setup.entity());
}

void CollisionProbe::step(const Instant&) noexcept {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  collision::TestCounts ground;
  std::size_t contacts = 0;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    movers_[i].start_step();
    points_.clear();
    ground_finders_[i].find(movers_[i].r, movers_[i].R, points_, ground);
    contacts += points_.size();
  }
  const auto middle = Clock::now();
  pair_finder_.find(movers_, pairs_);
  const std::chrono::duration<double, std::micro> on_ground = middle - start, among = Clock::now() - middle;
  samples_.push_back({ground.volumes + pairs_.tests.volumes, ground.objects + pairs_.tests.objects,
                      contacts + pairs_.points.size(), among.count(), on_ground.count()});
}

}  // namespace murosimf::app
