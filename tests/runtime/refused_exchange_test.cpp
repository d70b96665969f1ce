// A level that cannot take over leaves the one before in charge, which goes on with the momentum that it handed over.
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

/// Glides with the momentum that it has been given; lets go of it when it hands over.
class Glide final : public MotionLevel {
 public:
  Glide(Setup& setup, bool refuses) : refuses_(refuses), place_(setup.write(properties::position)[0]) {}
  [[nodiscard]] LevelTraits traits() const override { return {}; }
  void initialize() override {
    place_ = {};
    speed_ = {0.5, -2, 1};
  }
  void step(const Instant& instant) noexcept override { place_ += seconds(instant.period) * speed_; }
  [[nodiscard]] Momentum hand_over() noexcept override {
    const Momentum momentum{speed_, {7, 8, 9}};
    speed_ = {};
    return momentum;
  }
  void take_over(const Momentum& momentum) override {
    if (refuses_) throw SetupError("impossible");
    speed_ = momentum.linear;
    spin = momentum.angular;
  }
  Vec3d spin;

 private:
  bool refuses_;
  Vec3d& place_;
  Vec3d speed_;  // [m/s]
};

TEST(RefusedExchange, LevelBeforeGoesOnWithItsMomentum) {
  Simulation simulation;
  Entity& body = simulation.world().add("body", std::make_shared<const Model>("dot", Chain{}.base("base")));
  auto& level = simulation.attach<Glide>("glide", body, 1000, false);
  for (int i = 0; i < 100; ++i) simulation.step();
  EXPECT_EQ(fixtures::error_of([&] { simulation.exchange<Glide>("other", body, true); }).find("no error"),
            std::string::npos);
  for (int i = 0; i < 100; ++i) simulation.step();
  EXPECT_LT(fixtures::difference(body.base().get(properties::position), {0.1, -0.4, 0.2}), 1e-12);
  EXPECT_LT(fixtures::difference(level.spin, {7, 8, 9}), 1e-15);
}

TEST(RefusedExchange, TheOtherTakesOverIfItCan) {
  Simulation simulation;
  Entity& body = simulation.world().add("body", std::make_shared<const Model>("dot", Chain{}.base("base")));
  simulation.attach<Glide>("glide", body, 1000, false);
  for (int i = 0; i < 100; ++i) simulation.step();
  auto& other = simulation.exchange<Glide>("other", body, false);
  for (int i = 0; i < 100; ++i) simulation.step();
  EXPECT_LT(fixtures::difference(body.base().get(properties::position), {0.1, -0.4, 0.2}), 1e-12);
  EXPECT_LT(fixtures::difference(other.spin, {7, 8, 9}), 1e-15);
}

}  // namespace
}  // namespace murosimf
