// A recorded run is repeated from its file alone, and what is not the same is found and named.
#include "murosimf/recording/rerun.h"

#include <bit>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene_file/field.h"
#include "tests/recording/repeatable_run.h"
#include "tests/sanitizer.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;
using fixtures::record;
using fixtures::RepeatableRun;

RerunResult repeated(const std::filesystem::path& file) { return rerun(RecordedRun(file), {}); }

std::string refusal_of(const std::filesystem::path& file) {
  try {
    (void)repeated(file);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "none";
}

TEST(Rerun, FindsNoDifferenceWhereThereIsNone) {
  for (const std::string scene : {"walk", "nudge", "four_levels", "three_on_three"}) {
    const RerunResult result = repeated(record("same.mcap", {.scene = scene, .time = 2500ms}));
    EXPECT_FALSE(result.difference) << scene << ": " << to_text(result);
    EXPECT_EQ(result.compared, 4U) << "0, 1, 2 and 2.5 s";
    EXPECT_EQ(result.end, 2500ms);
  }
}

TEST(Rerun, RepeatsSeedOptionsAndCommands) {
  const RepeatableRun run{.scene = "nudge",
                          .time = 1500ms,
                          .how = {.seed = 77, .events = {"0.4:robot.level=simplified_dynamics"}, .cameras = false},
                          .when_initialized = [](scene::Scene& scene) {
                            scene.simulation().at(700ms, [&] { (void)scene.post("robot.level=full_dynamics"); });
                            scene.simulation().at(1s, [&] {
                              (void)scene.post("ball.position=[1, 1, 0.1]");
                            });  // refused, or not: the same again
                          }};
  const RecordedRun recorded(record("commands.mcap", run));
  EXPECT_EQ(recorded.description().seed, 77U);
  ASSERT_FALSE(recorded.states().commands().empty());
  EXPECT_EQ(recorded.states().commands().front().time, 700ms);
  EXPECT_FALSE(rerun(recorded, {}).difference) << to_text(rerun(recorded, {}));
}

// As viewers and supervisors do: everything that moves can be pushed, and pushes and places are commands like others.
TEST(Rerun, RepeatsWhatWasTouched) {
  RepeatableRun run{.scene = "walk",
                    .time = 1500ms,
                    .how = {.overrides = {"walker.level=simplified_dynamics"}, .cameras = false, .pushable = true}};
  const auto untouched = record("untouched.mcap", run);
  run.when_initialized = [](scene::Scene& scene) {
    scene.simulation().at(500ms, [&] { (void)scene.post("walker.push = [12, 8, 0, 0.2]"); });
    scene.simulation().at(1s, [&] { (void)scene.post("walker.level = full_dynamics"); });
    scene.simulation().at(1200ms, [&] { (void)scene.post("walker.place = [1, 1, 0.3, 0.5]"); });
  };
  const auto touched = record("touched.mcap", run);
  for (const auto& file : {untouched, touched}) EXPECT_FALSE(repeated(file).difference) << to_text(repeated(file));
  const McapReader other(untouched);
  const RecordedStates without(other);
  const RerunResult result = rerun(RecordedRun(touched), {.reference = &without});
  ASSERT_TRUE(result.difference) << "touches change nothing";
  EXPECT_EQ(result.difference->same, 0s);
}

// One bit of one joint at one tick, which the repetition does not have.
TEST(Rerun, NamesTheOneBitThatDiffers) {
  std::string joint;
  double then = 0;
  const auto flip = [&](scene::Scene& scene) {
    scene.simulation().at(500ms, [&] {
      Entity& robot = scene.simulation().world().entity("robot");
      const int row = robot.model().joints()[3];
      joint = robot.model().objects()[static_cast<std::size_t>(row)].name;
      double& angle = robot.view("joint_position")(static_cast<std::size_t>(row), 0);
      angle = std::bit_cast<double>(std::bit_cast<std::uint64_t>(angle) ^ 1U);
      then = angle;
    });
  };
  RepeatableRun run{.scene = "nudge", .time = 1200ms, .when_initialized = flip};
  run.options.ticks = TimeSpan{450ms, 550ms};
  const RerunResult result = repeated(record("bit.mcap", run));
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->same, 499ms);
  EXPECT_EQ(result.difference->differs, 500ms);
  EXPECT_TRUE(result.difference->is_one_step());
  ASSERT_TRUE(result.difference->what) << result.difference->unlike;
  EXPECT_EQ(result.difference->what->entity, "robot");
  EXPECT_EQ(result.difference->what->object, joint);
  EXPECT_EQ(result.difference->what->property, "joint_position");
  EXPECT_EQ(result.difference->what->first, fmt::format("{}", then));
  EXPECT_EQ(result.difference->what->others, 0U) << to_text(result);
}

// Without every step there are two instants between which it lies.
TEST(Rerun, SaysBetweenWhichSecondsItDiffers) {
  const auto push = [](scene::Scene& scene) {
    scene.simulation().at(1300ms, [&] { scene.simulation().world().entity("ball").view("position")(0, 0) += 1e-9; });
  };
  RepeatableRun run{.scene = "three_on_three", .time = 4s, .when_initialized = push};
  run.options.state_period = 3s;
  const RerunResult result = repeated(record("second.mcap", run));
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->same, 1s);
  EXPECT_EQ(result.difference->differs, 2s);
  EXPECT_FALSE(result.difference->is_one_step());
  EXPECT_EQ(result.difference->looked, 3s);
  EXPECT_TRUE(result.difference->what);
}

TEST(Rerun, NeedsNoFileBesidesTheRecording) {
  const auto folder = fixtures::temp_folder() / "gone";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "scenes/walk.toml", folder / "mine.toml");
  const auto file = record("alone.mcap", {.scene = (folder / "mine.toml").string(), .time = 1s});
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(repeated(file).difference);
}

TEST(Rerun, SaysWhichLargeFileIsMissingOrAnother) {
  const auto large = fixtures::temp_folder() / "large.toml";
  std::ofstream(large) << std::ifstream(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "scenes/walk.toml").rdbuf()
                       << "\n# " << std::string(300'000, 'x') << "\n";
  const auto file = record("large.mcap", {.scene = large.string(), .time = 1s});
  EXPECT_FALSE(repeated(file).difference);
  std::ofstream(large, std::ios::app) << "# more\n";
  EXPECT_NE(refusal_of(file).find(large.string() + "' is another one now"), std::string::npos) << refusal_of(file);
  std::filesystem::remove(large);
  EXPECT_NE(refusal_of(file).find("'user/large.toml' ("), std::string::npos) << refusal_of(file);
  EXPECT_NE(refusal_of(file).find("there is no such file here"), std::string::npos) << refusal_of(file);
}

TEST(Rerun, RefusesARunThatSomebodyElseMoved) {
  RepeatableRun run{.scene = "walk", .time = 100ms};
  const auto file = record("plain.mcap", run);
  const McapReader reader(file);
  RunDescription description = parse_run_description(attached_text(reader, "run.json"));
  EXPECT_EQ(description.scene, "walk");
  EXPECT_THROW((void)parse_run_description("{\"schema\": 3}"), SetupError);
  EXPECT_THROW((void)parse_run_description("no json"), SetupError);
  EXPECT_THROW((void)parse_run_description("{\"schema\": \"murosimf/run_description/1\", \"scene\": 7}"), SetupError);
}

// A recording that was cut off is repeated as far as it goes.
TEST(Rerun, RepeatsWhatIsLeftOfACutOffFile) {
  const auto file = record("cut.mcap", {.scene = "walk", .time = 5s});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
  const RerunResult result = repeated(file);
  EXPECT_FALSE(result.difference) << to_text(result);
  EXPECT_GE(result.compared, 3U);
}

// Only what is around a fall is kept, and can be repeated from there.
TEST(RecordOn, KeepsWhatWasBeforeAFall) {
  RepeatableRun run{.scene = "nudge", .time = 6s, .how = {.overrides = {"robot.controller=walk"}, .cameras = false}};
  run.options.record_on = {"fall"};
  run.options.keep = 500ms;
  run.options.state_period = 200ms;
  const RecordedRun recorded(record("fall.mcap", run));
  ASSERT_FALSE(recorded.states().all().empty()) << "it falls";
  const Duration begin = recorded.description().start;
  EXPECT_GT(begin, 0ms);
  EXPECT_EQ(recorded.states().all().front().time, begin);
  EXPECT_LT(recorded.end(), 6s);
  EXPECT_GE(recorded.end() - begin, 2500ms);
  EXPECT_LE(recorded.end() - begin, 2500ms + 200ms + 200ms) << "a state before, and a batch behind";
  EXPECT_FALSE(rerun(recorded, {}).difference) << to_text(rerun(recorded, {}));
}

// It is recorded as long as it is asked for, again and again; what is there can be repeated, over the gap.
TEST(RecordOn, KeepsWhatIsAskedFor) {
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  scene::Scene scene("walk", {.cameras = false, .pushable = true});
  RecorderOptions options{.file = fixtures::temp_folder() / "asked.mcap", .record_on = {"asked"}, .keep = 200ms};
  options.run = RunDescription{.scene = "walk", .seed = scene.spec().seed, .cameras = false, .pushable = true};
  options.files = read.get();
  Recorder recorder(scene, options);
  const auto run = [&](Duration time) { scene.simulation().run(time); };
  scene.simulation().initialize();
  run(1s);
  recorder.ask(true);
  recorder.ask(false);  // nothing between
  run(1s);
  recorder.ask(true);
  run(500ms);
  recorder.ask(false);
  scene.post("walker.torso.push = [0, 1, 0, 0.1]");
  run(1500ms);
  recorder.ask(true);
  recorder.ask(true);
  run(300ms);
  recorder.ask(false);
  run(1s);
  recorder.finish(make_report(scene));
  EXPECT_EQ(recorder.happened(), 2U);
  const McapReader reader(options.file);
  std::vector<double> times;
  for (const ChunkIndex& chunk : reader.contents().chunks) {
    reader.visit_messages(chunk, [&](const Message& message) {
      times.push_back(1e-9 * static_cast<double>(message.log_time));
    });
  }
  ASSERT_FALSE(times.empty());
  EXPECT_GE(times.front(), 2 - 0.2 - 0.2) << "a state before";
  EXPECT_LE(times.front(), 2 - 0.2);
  EXPECT_GE(times.back(), 4.3);
  EXPECT_LE(times.back(), 4.3 + 0.2) << "a batch behind";
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] - times[i - 1] < 0.015) continue;
    EXPECT_LE(times[i - 1], 2.5 + 0.2);
    EXPECT_GE(times[i - 1], 2.5 - 0.02);
    gaps.push_back(times[i] - times[i - 1]);
  }
  EXPECT_EQ(gaps.size(), 1U);
  const RerunResult result = repeated(options.file);
  EXPECT_FALSE(result.difference) << to_text(result);
}

TEST(RecordOn, KeepsNothingOfARunWithoutEvent) {
  RepeatableRun run{.scene = "walk", .time = 2s};
  run.options.record_on = {"fall", "goal", "freeze"};
  EXPECT_EQ(McapReader(record("nothing.mcap", run)).contents().statistics.message_count, 0U);
}

TEST(RecordOn, SeesTheBallInTheGoal) {
  scene::Scene scene("three_on_three", {.cameras = false});
  RunWatch watch(scene, {"goal"});
  scene.simulation().initialize();
  EXPECT_TRUE(watch.look().empty());
  const ColumnView place = scene.simulation().world().entity("ball").view("position");
  const scene_file::FieldSize& field = scene_file::field_size(scene.spec().field.size);
  const double radius = scene.spec().ball->radius;
  place(0, 1) = 0;
  place(0, 2) = radius;
  place(0, 0) = field.length / 2 + radius - 1e-6;
  EXPECT_TRUE(watch.look().empty()) << "a part of it is on the line";
  place(0, 0) = field.length / 2 + radius + 1e-6;
  EXPECT_EQ(watch.look(), std::vector<std::string>{"goal"});
  EXPECT_TRUE(watch.look().empty()) << "once";
  place(0, 1) = field.goal_width / 2 + 0.1;
  EXPECT_TRUE(watch.look().empty());
  place(0, 0) = -field.length / 2 - 2 * radius;
  place(0, 1) = 0;
  EXPECT_EQ(watch.look().size(), 1U) << "the other one";
}

// Whatever a byte of it has become: it is repeated, or refused in one line.
TEST(RecordedRun, OfAMutatedFileIsBuiltOrRefused) {
  const auto file = record("whole.mcap", {.scene = "walk", .time = 300ms}),
             mutated = fixtures::temp_folder() / "mutated.mcap";
  std::stringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < fixtures::tries(1000); ++i) {
    std::string bytes = content.str();
    const std::size_t place = std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random);
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << i % 8));
    std::ofstream(mutated, std::ios::binary) << bytes;
    try {
      const RecordedRun run(mutated);
      const auto scene = run.build({});
      run.begin(*scene, 200ms);
      scene->simulation().run(10ms);
    } catch (const SetupError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, fixtures::tries(50));
}

TEST(RecordedRun, GoesOnFromEveryStateAsTheRunDid) {
  RepeatableRun run{.scene = "four_levels", .time = 3s};
  run.options.state_period = 700ms;
  const RecordedRun recorded(record("states.mcap", run));
  const std::uint64_t end = recorded.states().all().back().hash;
  for (const Duration time : {0ms, 700ms, 1650ms, 2999ms}) {
    const auto scene = recorded.build({});
    recorded.begin(*scene, time);
    EXPECT_LE(scene->simulation().now(), time);
    EXPECT_GT(scene->simulation().now() + 700ms, time);
    scene->simulation().run(3s - scene->simulation().now());
    EXPECT_EQ(scene->simulation().state_hash(), end) << seconds(time);
  }
}

}  // namespace
}  // namespace murosimf
