// What is outside of a run is asked for no instant twice: going back answers from what it had said, and says what goes on otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/session/live_source.h"
#include "tests/fixtures.h"

namespace murosimf::session {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

/// Software that nods as its calls are counted; `saves`: the count is a part of states.
class Counting final : public control_software::ControlSoftware {
 public:
  Counting(control_software::RobotPort& port, std::vector<Duration>& asked, bool saves)
      : target_(port.command("joint.target")), asked_(&asked), saves_(saves) {}
  control_software::CallOutcome start() override {
    ++starts;
    count_ = 0;
    target_->values[0] = 0.1 * starts;
    return {};
  }
  control_software::CallOutcome step(Duration now) noexcept override {
    asked_->push_back(now);
    target_->values[0] = 0.3 * std::sin(0.05 * ++count_);
    return {};
  }
  void state(StateArchive& archive) override {
    if (saves_) archive(count_);
  }
  [[nodiscard]] bool keeps_state() const override { return !saves_; }

  int starts = 0;

 private:
  murosimf_command* target_;
  std::vector<Duration>* asked_;
  bool saves_;
  int count_ = 0;
};

struct SteeredRun {
  explicit SteeredRun(bool saves = false, const TimelineOptions& timeline = {})
      : scene("walk", {.overrides = {"walker.controller=none", "walker.level=simplified_dynamics"}, .cameras = false}),
        source(scene, {.timeline = timeline}) {
    const auto make = [this, saves](Setup&, control_software::RobotPort& port, const control_software::SayLine&) {
      auto made = std::make_unique<Counting>(port, asked, saves);
      software = made.get();
      return made;
    };
    scene.simulation().attach<control_software::ControllerTask>(
        "program", scene.simulation().world().entity("walker"), 100, make,
        control_software::ControllerTaskOptions{.software = "program", .memory = scene.parts().outside.memory});
    source.begin();
  }
  void go_to(Duration time) {
    while (scene.simulation().now() < time) source.step();
  }
  void seek(Duration time, std::optional<int> branch = {}) {
    source.seek(time, branch, [] { return false; });
  }
  [[nodiscard]] std::uint64_t hash() const { return scene.simulation().state_hash(); }

  std::vector<Duration> asked;
  Counting* software = nullptr;
  scene::Scene scene;
  LiveSource source;
};

TEST(Outside, IsNotAskedAgainAndTheStateIsThatOfThen) {
  SteeredRun run;
  run.go_to(1300ms);
  const std::vector<std::byte> state = run.scene.save();
  run.go_to(3300ms);
  const std::vector<std::byte> last = run.scene.save();
  const std::size_t calls = run.asked.size();
  run.seek(1300ms);
  EXPECT_TRUE(run.scene.save() == state) << "bit for bit";
  EXPECT_EQ(run.asked.size(), calls);
  EXPECT_EQ(run.source.diagnostic(),
            "software of walker keeps its own state: from 1.3 s on this is not the run that was there before");
  run.seek(3300ms);
  EXPECT_TRUE(run.scene.save() == last);
  EXPECT_EQ(run.source.diagnostic(), "") << "there it is as it was then";
  run.seek(0ms);
  EXPECT_EQ(run.asked.size(), calls);
}

TEST(Outside, GoesOnLiveAsItIsInABranchOfItsOwn) {
  SteeredRun run;
  run.go_to(3300ms);
  const std::uint64_t last = run.hash();
  run.seek(1300ms);
  run.go_to(2000ms);
  EXPECT_EQ(run.asked.back(), 1990ms);
  const std::vector<std::string> warnings = run.scene.simulation().warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(says(warnings[0], {"walker keeps its own state: from 1.3 s on"}));
  const std::vector<std::byte> other = run.scene.save();
  run.seek(3300ms, 0);
  EXPECT_EQ(run.hash(), last);
  EXPECT_EQ(run.scene.simulation().warnings().size(), 0U);
  EXPECT_NE(run.source.diagnostic(), "");
  run.seek(2000ms, 1);
  EXPECT_TRUE(run.scene.save() == other) << "with what was said of it";
  EXPECT_EQ(run.source.diagnostic(), "");
}

TEST(Outside, SoftwareThatSavesItsStateIsTheSameAgain) {
  SteeredRun run(true), straight(true);
  run.go_to(3300ms);
  run.seek(1300ms);
  EXPECT_EQ(run.source.diagnostic(), "");
  run.go_to(2s);
  straight.go_to(2s);
  EXPECT_EQ(run.hash(), straight.hash());
}

TEST(Outside, WhoLeavesAndComesBackOnTheWayIsNotStartedAgain) {
  SteeredRun run;
  run.go_to(700ms);
  run.source.change({"walker.present = false"});
  run.go_to(900ms);
  run.source.change({"walker.present = true"});
  run.go_to(950ms);
  const std::vector<std::byte> state = run.scene.save();
  run.go_to(1400ms);
  const int starts = run.software->starts;
  EXPECT_EQ(starts, 2);
  run.seek(950ms);
  EXPECT_TRUE(run.scene.save() == state);
  EXPECT_EQ(run.software->starts, starts);
}

TEST(Outside, IsKeptInABoundedMemory) {
  SteeredRun run(false, {.most_note_bytes = 20'000});
  run.go_to(1300ms);
  run.go_to(4s);
  run.seek(3900ms);
  EXPECT_TRUE(says(error_of([&] { run.seek(1300ms); }),
                   {"what came from outside before", "is not kept any more", "the states that are kept (1.000 s)"}));
  run.seek(1s);
  EXPECT_EQ(run.scene.simulation().now(), 1s);
}

TEST(Outside, AResetThatCannotBeLeavesTheRunAsItIs) {
  SteeredRun run;
  run.go_to(300ms);
  const std::vector<std::byte> state = run.scene.save();
  run.source.change({"walker.contact = kelvin_voigt"});
  bool refuses = true;
  run.scene.simulation().before_start([&] {
    if (refuses) throw SetupError("not now");
  });
  const std::vector<std::byte> changed = run.scene.save();
  EXPECT_EQ(error_of([&] { run.source.reset({}); }), "not now");
  EXPECT_TRUE(run.scene.save() == changed);
  EXPECT_EQ(run.scene.simulation().commands().size(), 1U);
  run.seek(300ms);
  EXPECT_TRUE(run.scene.save() == state);
}

}  // namespace
}  // namespace murosimf::session
