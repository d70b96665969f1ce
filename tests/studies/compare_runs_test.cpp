// The comparison of levels on real scenes: what the observer sees, three experiments with three verdicts, errors.
#include "murosimf/studies/compare_runs.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/compare_verdict.h"
#include "tests/temp_folder.h"

namespace murosimf::studies {
namespace {

namespace fs = std::filesystem;

CompareOptions experiment(const std::string& scene, const std::string& entity) {
  CompareOptions options;
  options.scene = scene;
  options.entity = entity;
  options.repeat = 1;
  return options;
}

/// [standing robot] in a file of its own.
class StandingRobot {
 public:
  explicit StandingRobot(const std::string& keys) {
    std::ofstream(file_) << "duration = 1\n[[materials]]\npair = [\"rubber\", \"carpet\"]\nfriction = 0.05\n"
                         << "[[robots]]\nname = \"r\"\nmodel = \"kid21\"\nlevel = \"simplified_dynamics\"\n" + keys;
  }
  ~StandingRobot() { fs::remove(file_); }
  StandingRobot(const StandingRobot&) = delete;
  StandingRobot& operator=(const StandingRobot&) = delete;

  [[nodiscard]] dynamics::MotionRecord record(const std::vector<std::string>& overrides, double seconds) const {
    scene::Scene scene(file_, {.overrides = overrides});
    auto& simulation = scene.simulation();
    const auto& recorder =
        simulation.attach<dynamics::MotionRecorder>("motion_recorder", simulation.world().entity("r"), 1000,
                                                    dynamics::MotionRecorderOptions{.longest = seconds});
    simulation.run(from_seconds(seconds));
    return recorder.record();
  }
  [[nodiscard]] std::uint64_t hash(bool observed) const {
    scene::Scene scene(file_);
    auto& simulation = scene.simulation();
    if (observed) {
      simulation.attach<dynamics::MotionRecorder>("motion_recorder", simulation.world().entity("r"), 1000);
    }
    simulation.run(from_seconds(0.5));
    return simulation.state_hash();
  }

 private:
  fs::path file_ = fixtures::temp_folder() / ("compare_runs_test." + std::to_string(::getpid()) + ".toml");
};

TEST(MotionRecorder, TakesAHundredSamplesASecondAndTheStart) {
  const auto record = StandingRobot("").record({}, 1);
  ASSERT_EQ(record.samples.size(), 101U);
  for (std::size_t i = 0; i < record.samples.size(); ++i) {
    EXPECT_NEAR(record.samples[i].time, 0.01 * static_cast<double>(i), 1e-12);
  }
  EXPECT_EQ(record.soles, 2U);
  EXPECT_NEAR(record.samples[0].clearance[0], 0, 1e-3) << "it stands";
}

TEST(MotionRecorder, SeesPitchAndRollAtAnyHeading) {
  const double degree = pi / 180;
  const auto lying =
      StandingRobot("controller = \"none\"\npitch_deg = -90\nheading_deg = 70\n").record({}, 0.01).samples[0];
  EXPECT_NEAR(lying.pitch, -90 * degree, 1e-9);
  EXPECT_NEAR(lying.roll, 0, 1e-7);
  const auto leaning =
      StandingRobot("controller = \"none\"\nroll_deg = 30\nheading_deg = -40\n").record({}, 0.01).samples[0];
  EXPECT_NEAR(leaning.roll, 30 * degree, 1e-9);
  EXPECT_NEAR(leaning.pitch, 0, 1e-9);
}

// On ice 6 N overcome friction of 2.1 N and pull the robot forward; both soles slip as far as it goes.
TEST(MotionRecorder, SeesBothFeetSlip) {
  const auto record = StandingRobot("").record({"r.pelvis.applied_force=[6,0,0,0,0,0]"}, 1);
  const double moved = record.samples.back().base.x - record.samples.front().base.x;
  ASSERT_GT(moved, 0.1);
  EXPECT_NEAR(record.samples.back().slip, 2 * moved, 0.1 * moved);
  EXPECT_LT(StandingRobot("").record({}, 1).samples.back().slip, 1e-3);
}

TEST(MotionRecorder, SeesTheTorqueOfServosThatHoldTheRobot) {
  const auto record = StandingRobot("").record({"r.level=articulated_dynamics"}, 1);
  ASSERT_EQ(record.joints.size(), 21U);
  ASSERT_EQ(record.torques.size(), record.joints.size() * record.samples.size());
  EXPECT_EQ(record.torques[0], 0) << "nothing has moved at the start";
  EXPECT_TRUE(StandingRobot("").record({}, 0.1).joints.empty()) << "simplified dynamics knows no torques";
}

TEST(MotionRecorder, ChangesNothing) {
  const StandingRobot robot("");
  EXPECT_EQ(robot.hash(true), robot.hash(false));
}

struct Verdicts {
  const char *scene, *entity;
  std::vector<bool> adequate;  // kinematic, simplified, full, articulated
};
void PrintTo(const Verdicts& of, std::ostream* out) { *out << of.scene; }

class Experiments : public testing::TestWithParam<Verdicts> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Experiments,
                         testing::Values(Verdicts{"slow_walk_past_obstacle", "walker", {true, true, true, true}},
                                         Verdicts{"push", "robot", {false, true, true, true}},
                                         Verdicts{"arm_swing", "robot", {false, false, true, true}},
                                         Verdicts{"get_up", "robot", {false, false, false, true}},
                                         Verdicts{"kick", "robot", {false, false, false, true}}),
                         [](const auto& param) { return std::string(param.param.scene); });

TEST_P(Experiments, NeedTheLevelThatTheirPhysicsNeeds) {
  const Verdicts& wanted = GetParam();
  const Comparison c = compare(experiment(wanted.scene, wanted.entity));
  const Recommendation r = recommend(c, {});
  ASSERT_EQ(c.entries.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(r.verdicts[i].adequate, wanted.adequate[i]) << c.entries[i].level << ": " << r.sentence;
    EXPECT_GT(c.entries[i].cost, 0);
  }
  EXPECT_EQ(c.entries[c.reference].level, "articulated_dynamics");
}

TEST(Compare, OtherRobotsStayAsTheyAre) {
  CompareOptions options = experiment("duel", "blue1");
  options.end = 0.5;
  options.levels = {"simplified_dynamics", "kinematic_walking"};
  const Comparison c = compare(options);
  ASSERT_EQ(c.entries.size(), 2U);
  EXPECT_EQ(c.entries[0].level, "kinematic_walking") << "from simple to detailed, whatever the order asked for";
  EXPECT_EQ(c.reference, 1U);
  EXPECT_EQ(c.entries[1].record.samples.size(), 51U);
}

TEST(Compare, AsksEveryLawButOnlyWhereThereIsContact) {
  CompareOptions options = experiment("walk", "walker");
  options.end = 0.2;
  options.contacts = {"implicit_stick", "paper"};
  const Comparison c = compare(options);
  ASSERT_EQ(c.entries.size(), 7U);
  EXPECT_EQ(c.entries[0].contact, "");
  EXPECT_EQ(c.entries[2].contact, "paper");
  EXPECT_EQ(label(c, c.entries[c.reference]), "articulated_dynamics with implicit_stick");
}

TEST(Compare, LevelsThatTheModelCannotHaveAreListed) {
  CompareOptions options = experiment("car_crash", "car");
  options.end = 0.1;
  const Comparison c = compare(options);
  EXPECT_NE(c.entries[0].refusal.find("0 soles"), std::string::npos);
  EXPECT_TRUE(c.entries[1].ran());
}

TEST(Compare, TheSameSeedGivesTheSameRecord) {
  CompareOptions options = experiment("three_on_three", "red1");
  options.end = 0.5;
  options.levels = {"full_dynamics"};
  options.seed = 7;
  const auto end = [&] { return compare(options).entries[0].measures.end; };
  const Vec3d first = end(), again = end();
  options.seed = 8;
  const Vec3d other = end();
  EXPECT_EQ(first.x, again.x);
  EXPECT_NE(first.x, other.x);
}

/// Of scene push when the ball is on its way, and which samples the robot's level gives from there to the end at 1 s.
struct Thrown {
  static constexpr double start = 0.15;

  Thrown() {
    scene::Scene scene("push");
    auto& simulation = scene.simulation();
    simulation.run(from_seconds(start));
    state = scene.save();
    const auto& recorder =
        simulation.attach<dynamics::MotionRecorder>("motion_recorder", simulation.world().entity("robot"), 1000,
                                                    dynamics::MotionRecorderOptions{.longest = 1, .start = start});
    simulation.run(from_seconds(1 - start));
    samples = recorder.record().samples;
  }

  std::vector<std::byte> state;
  std::vector<dynamics::MotionSample> samples;
};

TEST(Compare, FromAStateAllLevelsBeginThere) {
  const Thrown thrown;
  CompareOptions options = experiment("push", "robot");
  options.end = 1;
  options.go_to_start = [&](scene::Scene& scene) { scene.load(thrown.state); };
  const Comparison c = compare(options);
  EXPECT_DOUBLE_EQ(c.start, Thrown::start);
  ASSERT_EQ(c.entries.size(), 4U);
  for (const CompareEntry& entry : c.entries) {
    ASSERT_TRUE(entry.ran()) << entry.level << ": " << entry.refusal;
    const auto& samples = entry.record.samples;
    ASSERT_EQ(samples.size(), thrown.samples.size()) << entry.level;
    EXPECT_DOUBLE_EQ(samples.front().time, thrown.start);
    EXPECT_DOUBLE_EQ(samples.back().time, 1);
    EXPECT_EQ(norm(samples.front().base - thrown.samples.front().base), 0) << entry.level;
  }
  const auto& same = c.entries[c.reference].record.samples;
  ASSERT_EQ(c.entries[c.reference].level, "articulated_dynamics") << "as in the scene";
  for (std::size_t i = 0; i < same.size(); ++i) EXPECT_EQ(norm(same[i].base - thrown.samples[i].base), 0) << i;
  EXPECT_EQ(falls_in(c.entries[c.reference].measures.events), 1) << "it is hit after the start";
  EXPECT_EQ(falls_in(c.entries[0].measures.events), 0) << "no push throws a robot over at kinematic_walking";
}

TEST(Compare, FromAStateItEndsLater) {
  const Thrown thrown;
  CompareOptions options = experiment("push", "robot");
  options.end = 0.1;
  options.go_to_start = [&](scene::Scene& scene) { scene.load(thrown.state); };
  EXPECT_THROW((void)compare(options), SetupError);
}

std::string refusal(const CompareOptions& options) {
  try {
    static_cast<void>(compare(options));
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(Compare, SaysWhatIsWrong) {
  EXPECT_NE(refusal(experiment("push", "robt")).find("did you mean 'robot'?"), std::string::npos);
  EXPECT_NE(refusal(experiment("push", "ball")).find("a ball has one level"), std::string::npos);
  EXPECT_NE(refusal(experiment("push", "field")).find("does not move"), std::string::npos);
  EXPECT_NE(refusal(experiment("pusj", "robot")).find("no file 'pusj'"), std::string::npos);
  const auto with = [](const auto& change) {
    CompareOptions options = experiment("push", "robot");
    change(options);
    return refusal(options);
  };
  EXPECT_NE(with([](auto& o) { o.levels = {"full"}; }).find("did you mean 'full_dynamics'?"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.contacts = {"papr"}; }).find("did you mean 'paper'?"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.overrides = {"robot.levl=x"}; }).find("did you mean 'level'?"), std::string::npos);
  for (const double end : {0.0, -1.0, std::nan(""), 1e9}) {
    EXPECT_NE(with([&](auto& o) { o.end = end; }).find("--duration"), std::string::npos) << end;
  }
  EXPECT_NE(with([](auto& o) { o.repeat = -1; }).find("--repeat -1"), std::string::npos);
  EXPECT_NE(refusal(experiment("changing_levels", "walker")).find("changes on the way"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.outcomes = {"bal.end"}; }).find("nothing that moves is called 'bal'"),
            std::string::npos);
  CompareOptions car = experiment("car_crash", "car");
  car.levels = {"kinematic_walking"};
  EXPECT_NE(refusal(car).find("no level of 'car' can start; kinematic_walking: "), std::string::npos);
}

}  // namespace
}  // namespace murosimf::studies
