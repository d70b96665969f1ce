#include "apps/collision_probe.h"

#include <chrono>

namespace murosimf::app {
namespace {

std::vector<collision::MovingEntity> make_moving_entities(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<collision::MovingEntity> moving_entities;
  for (Entity* entity : entities) moving_entities.emplace_back(setup.of(*entity));
  return moving_entities;
}

std::int64_t count_naive_tests(const std::vector<collision::MovingEntity>& moving_entities, const Entity& environment) {
  const auto still = collision::StaticCompound(&environment).compound().shapes().size() +
                     collision::ground_planes(&environment).size();
  std::size_t tests = 0, before = 0;
  for (const collision::MovingEntity& moving_entity : moving_entities) {
    const std::size_t shapes = moving_entity.compound.shapes().size();
    tests += shapes * (before + still);
    before += shapes;
  }
  return static_cast<std::int64_t>(tests);
}

}  // namespace

CollisionProbe::CollisionProbe(Setup& setup, const std::vector<Entity*>& moving_entities,
                               const MaterialTable& materials)
    : moving_entities_(make_moving_entities(setup, moving_entities)),
      pair_finder_(materials, {seconds(setup.period())}, setup.world().gravity),
      naive_(count_naive_tests(moving_entities_, setup.entity())) {
  for (const collision::MovingEntity& moving_entity : moving_entities_) pair_finder_.add(moving_entity);
  pairs_.parameters = pair_finder_.parameters();
  for (const Entity* entity : moving_entities) ground_finders_.emplace_back(*entity, &setup.entity());
}

/// Leaves the points in points_.
collision::TestCounts CollisionProbe::find_on_ground() noexcept {
  collision::TestCounts counts;
  points_.clear();
  for (std::size_t i = 0; i < moving_entities_.size(); ++i) {
    ground_finders_[i].find(moving_entities_[i].r, moving_entities_[i].R, points_, counts);
  }
  return counts;
}

void CollisionProbe::step(const Instant&) noexcept {
  using Clock = std::chrono::steady_clock;
  for (collision::MovingEntity& moving_entity : moving_entities_) moving_entity.start_step();
  const auto start = Clock::now();
  const collision::TestCounts ground = find_on_ground();
  const auto middle = Clock::now();
  pair_finder_.find(moving_entities_, pairs_);
  const std::chrono::duration<double, std::micro> on_ground = middle - start, among = Clock::now() - middle;
  const collision::TestCounts pairs = pairs_.tests;
  const std::size_t contacts = points_.size() + pairs_.points.size();
  for (collision::GroundFinder& finder : ground_finders_) finder.forget_nearness();
  pair_finder_.forget_neighbors();
  const std::int64_t anew_on_ground = find_on_ground().volumes;
  pair_finder_.find(moving_entities_, pairs_);
  samples_.push_back({ground.volumes + pairs.volumes, ground.objects + pairs.objects,
                      anew_on_ground + pairs_.tests.volumes, contacts, among.count(), on_ground.count()});
}

}  // namespace murosimf::app
