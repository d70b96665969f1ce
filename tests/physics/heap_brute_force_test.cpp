// Through the whole fall of a heap: trees, margins and remembered neighbors find what testing all shapes finds.
#include <gtest/gtest.h>

#include <set>

#include "murosimf/collision/pair_finder.h"
#include "murosimf/scene/scene.h"

namespace murosimf::test {
namespace {

/// Two entities and a shape of each, in one number as in PairContact::shapes.
using Touching = std::set<std::uint64_t>;

/// Algorithm: finds contacts in every step, and compares them with those of all shapes in every twentieth.
class Judge final : public Algorithm {
 public:
  Judge(Setup& setup, const std::vector<Entity*>& entities)
      : moving_entities_(make_moving_entities(setup, entities)), finder_(MaterialTable::standard(), {}, {}) {
    for (const collision::MovingEntity& moving_entity : moving_entities_) finder_.add(moving_entity);
    set_.parameters = finder_.parameters();
  }

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override {
    for (collision::MovingEntity& moving_entity : moving_entities_) moving_entity.start_step();
    finder_.find(moving_entities_, set_);
    if (++steps_ % 20 != 0) return;
    Touching found;
    for (const auto& c : set_.points) found.insert(c.shapes);
    const Touching all = brute_force();
    EXPECT_EQ(found, all) << "step " << steps_;
    most_ = std::max(most_, all.size());
  }

  [[nodiscard]] std::size_t most() const { return most_; }

 private:
  static std::vector<collision::MovingEntity> make_moving_entities(Setup& setup, const std::vector<Entity*>& entities) {
    std::vector<collision::MovingEntity> moving_entities;
    for (Entity* entity : entities) moving_entities.emplace_back(setup.of(*entity));
    return moving_entities;
  }
  Touching brute_force() {
    Touching touching;
    for (std::size_t a = 0; a < moving_entities_.size(); ++a) {
      for (std::size_t b = a + 1; b < moving_entities_.size(); ++b) test_all(a, b, touching);
    }
    return touching;
  }
  void test_all(std::size_t a, std::size_t b, Touching& touching) {
    geometry::Manifold manifold;
    const auto &first = moving_entities_[a].compound.shapes(), &second = moving_entities_[b].compound.shapes();
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t j = 0; j < second.size(); ++j) {
        if (geometry::collide(first[i].placed.shape, moving_entities_[a].pose(static_cast<int>(i)),
                              second[j].placed.shape, moving_entities_[b].pose(static_cast<int>(j)), manifold)) {
          touching.insert(a << 48 | b << 32 | i << 16 | j);
        }
      }
    }
  }

  std::vector<collision::MovingEntity> moving_entities_;
  collision::PairFinder finder_;
  collision::PairSet set_;
  int steps_ = 0;
  std::size_t most_ = 0;
};

TEST(HeapOfRobots, HasTheContactsThatTestingAllShapesFinds) {
  for (const char* volume : {"sphere", "obb"}) {
    scene::Scene scene("heap",
                       {.overrides = {"r*.level=simplified_dynamics", std::string("r*.volume=") + volume, "rate=500"}});
    World& world = scene.simulation().world();
    std::vector<Entity*> robots;
    for (const auto& entity : world.entities()) {
      if (entity->name() != "field") robots.push_back(entity.get());
    }
    const Judge& judge = scene.simulation().attach<Judge>("judge", world.entity("field"), 500, robots);
    scene.simulation().run(from_seconds(2.0));
    EXPECT_GT(judge.most(), 20u);
  }
}

}  // namespace
}  // namespace murosimf::test
