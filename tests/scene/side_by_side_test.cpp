// Scenes that step side by side (runtime/simulation_lanes.h), and their packed states (runtime/state_packer.h).
#include <gtest/gtest.h>

#include "murosimf/runtime/simulation_lanes.h"
#include "murosimf/runtime/state_packer.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
namespace {

/// Copies of one scene with seeds of their own.
class SideBySide {
 public:
  explicit SideBySide(const std::vector<std::string>& overrides, std::size_t count = 4) {
    const auto assets = std::make_shared<Assets>();
    for (std::size_t i = 0; i < count; ++i) {
      const SceneOptions options{.seed = i + 1, .overrides = overrides, .cameras = false, .assets = assets};
      scenes.push_back(std::make_unique<Scene>("walk", options));
      simulations.push_back(&scenes.back()->simulation());
    }
  }
  std::vector<std::unique_ptr<Scene>> scenes;
  std::vector<Simulation*> simulations;
};

const std::vector<std::string> articulated = {"walker.level=articulated_dynamics", "walker.sensors=false",
                                              "start.jitter_heading_deg=30"};

TEST(SideBySide, MotionAndContactAreInLanes) {
  SideBySide four(articulated);
  EXPECT_EQ(SimulationLanes(four.simulations).algorithms_in_lanes(), 2U);
  SideBySide one(articulated, 1);
  EXPECT_EQ(SimulationLanes(one.simulations).algorithms_in_lanes(), 0U);
}

TEST(SideBySide, EachStepsAsAlone) {
  SideBySide together(articulated), alone(articulated);
  SimulationLanes lanes(together.simulations);
  lanes.step(0b1111, 37);
  lanes.step(0b0101, 11);  // from now on at different times
  lanes.step(0b1111, 200);
  lanes.step(0b1000, 5);
  const int steps[] = {248, 237, 248, 242};
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < steps[i]; ++k) alone.simulations[i]->step();
    EXPECT_EQ(together.simulations[i]->state_hash(), alone.simulations[i]->state_hash()) << i;
    EXPECT_EQ(together.simulations[i]->now(), alone.simulations[i]->now());
    EXPECT_EQ(together.scenes[i]->save(), alone.scenes[i]->save());
  }
}

TEST(SideBySide, OneOfAnotherLevelStepsByItself) {
  SideBySide together(articulated), alone(articulated);
  SimulationLanes lanes(together.simulations);
  for (Simulation* simulation : alone.simulations) simulation->initialize();
  for (SideBySide* each : {&together, &alone}) each->scenes[2]->exchange_level("walker", "simplified_dynamics");
  together.simulations[1]->at(std::chrono::milliseconds(20), [&] { together.scenes[1]->leave("walker"); });
  alone.simulations[1]->at(std::chrono::milliseconds(20), [&] { alone.scenes[1]->leave("walker"); });
  lanes.step(0b1111, 50);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 50; ++k) alone.simulations[i]->step();
    EXPECT_EQ(together.simulations[i]->state_hash(), alone.simulations[i]->state_hash()) << i;
  }
}

TEST(SideBySide, OthersAreRefused) {
  SideBySide walking(articulated, 2), simplified({"walker.level=simplified_dynamics"}, 1);
  walking.simulations.push_back(simplified.simulations[0]);
  EXPECT_THROW(SimulationLanes{walking.simulations}, SetupError);
}

TEST(StatePacker, AnotherGoesOnFromThere) {
  SideBySide two({"walker.level=articulated_dynamics"}, 2);  // with sensors
  Simulation &from = *two.simulations[0], &to = *two.simulations[1];
  two.scenes[1]->reset(1);
  for (int i = 0; i < 333; ++i) from.step();
  std::vector<StatePacker::Word> packed;
  StatePacker(from).save(packed);
  StatePacker(to).load(packed);
  EXPECT_EQ(two.scenes[0]->save(), two.scenes[1]->save());
  EXPECT_LT(8 * packed.size(), two.scenes[0]->save().size() / 2);
  for (Simulation* simulation : {&from, &to}) {
    for (int i = 0; i < 200; ++i) simulation->step();
  }
  EXPECT_EQ(two.scenes[0]->save(), two.scenes[1]->save());
}

/// Robots of loaded states get their links in lanes if enough of them do: beside others that have stepped, and those that start.
TEST(StatePacker, LoadedOnesGoOnInLanesAsAlone) {
  SideBySide together(articulated), alone(articulated);
  SimulationLanes lanes(together.simulations);
  lanes.step(0b1111, 20);
  for (Simulation* simulation : alone.simulations) simulation->run(std::chrono::milliseconds(45));
  alone.scenes[3]->reset(4);
  for (const LaneMask loaded : {0b1111U, 0b1010U, 0b0111U}) {
    for_lanes(loaded, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      std::vector<StatePacker::Word> packed;
      StatePacker(*alone.simulations[i]).save(packed);
      StatePacker(*together.simulations[i]).load(packed);
    });
    lanes.step(0b1111, 30);
    for_lanes(loaded, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      for (int k = 0; k < 30; ++k) alone.simulations[i]->step();
      EXPECT_EQ(together.scenes[i]->save(), alone.scenes[i]->save()) << lane;
    });
  }
}

/// Two simulations take turns in one place: what one has and the other has not is zero in between.
TEST(StatePacker, StatesComeOneAfterTheOther) {
  SideBySide alone(articulated, 2), shared(articulated, 1);
  Simulation& place = *shared.simulations[0];
  place.initialize();
  StatePacker packer(place);
  std::vector<StatePacker::Word> packed[2];
  for (std::size_t i = 0; i < 2; ++i) {
    for (int k = 0; k < 40; ++k) alone.simulations[i]->step();
    if (i == 1) alone.scenes[i]->change({"walker.place=[0, 0, 0.6, 1]"});
    StatePacker(*alone.simulations[i]).save(packed[i]);
  }
  for (int turn = 0; turn < 6; ++turn) {
    for (std::size_t i = 0; i < 2; ++i) {
      packer.load(packed[i]);
      for (int k = 0; k < 30; ++k) place.step(), alone.simulations[i]->step();
      EXPECT_EQ(place.state_hash(), alone.simulations[i]->state_hash()) << turn << ", " << i;
      packer.save(packed[i]);
    }
    if (turn != 2) continue;
    place.step();  // without being saved
    packer.forget();
  }
}

TEST(StatePacker, WhatIsNotAllThereIsRefused) {
  SideBySide one(articulated, 1);
  StatePacker packer((one.simulations[0]->initialize(), *one.simulations[0]));
  std::vector<StatePacker::Word> packed;
  packer.save(packed);
  EXPECT_THROW(packer.load({}), SetupError);
  EXPECT_THROW(packer.load(std::span(packed).first(packed.size() / 2)), SetupError);
  std::vector<StatePacker::Word> longer = packed;
  longer.push_back(1);
  EXPECT_THROW(packer.load(longer), SetupError);
  packer.load(packed);
}

}  // namespace
}  // namespace murosimf::scene
