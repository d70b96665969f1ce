// Robots and bodies that come to a run while it is recorded are in its recording, which shows and repeats them.
#include "murosimf/recording/recorded_addition.h"

#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/mcap/mcap_repair.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/recorded_source.h"
#include "murosimf/recording/state_file.h"
#include "murosimf/world/drawing.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using fixtures::expect_repeatable;
using fixtures::record;
using fixtures::RepeatableRun;
using recording::RecordedAddition;
using recording::RecordedRun;

/// In the air, with a posture that does not stand for long.
scene_file::RobotSpec guest(const std::string& model = "kid21") {
  return {.name = "guest",
          .model = model,
          .where = "test",
          .level = "articulated_dynamics",
          .controller = "none",
          .position = {-1, 1, 0.1},
          .heading = 0.5};
}

scene_file::BodySpec crate() {
  scene_file::BodySpec body{.name = "crate", .where = "test", .shape = Box{{0.05, 0.06, 0.07}}};
  body.mass = 0.3;
  body.position = {1, -1, 0.2};
  body.velocity = {0.1, 0, 0};
  return body;
}

/// A guest comes at 500 ms, absent, and is let in there; a crate at 1100 ms.
void play(scene::Scene& scene, const std::string& model = "kid21") {
  Simulation& simulation = scene.simulation();
  simulation.run(500ms);
  scene_file::RobotSpec absent = guest(model);
  absent.present = false;
  (void)scene.add(absent);
  scene.change({"guest.present = true", "guest.place = [-1, 0.5, 0.1, 0.3]"});
  simulation.run(600ms);
  (void)scene.add(crate());
  simulation.run(900ms);
}

RepeatableRun run_with(std::function<void(scene::Scene&, recording::Recorder&)> play) {
  RepeatableRun run{.scene = "nudge", .time = 2s, .play = std::move(play)};
  run.options.state_period = 300ms;
  run.options.what = {"poses", "scene", "joints", "contacts", "sensors", "events", "hashes", "states"};
  return run;
}
RepeatableRun usual_run() {
  return run_with([](scene::Scene& scene, recording::Recorder&) { play(scene); });
}

std::uint64_t last_hash(const std::filesystem::path& file) { return RecordedRun(file).states().all().back().hash; }

TEST(RecordedAddition, IsRepeatedFromAnyStateAndChangesNoResult) {
  const auto file = record("additions.mcap", usual_run());
  ASSERT_EQ(RecordedRun(file).additions().size(), 2U);
  expect_repeatable(file);
  scene::Scene unrecorded("nudge", {.threads = 2, .cameras = false});
  play(unrecorded);
  EXPECT_EQ(unrecorded.simulation().state_hash(), last_hash(file));
}

// Frames, hashes and states of the instant at which something comes may be taken before it and after it.
TEST(RecordedAddition, IsRepeatedAtTheInstantOfAState) {
  for (const bool before : {true, false}) {
    const auto file = record("at_a_state.mcap", run_with([&](scene::Scene& scene, recording::Recorder&) {
                               scene.simulation().run(600ms);
                               if (before) scene.simulation().carry_out_commands();  // the state of 600 ms is taken
                               (void)scene.add(crate());
                               scene.simulation().run(400ms);
                             }));
    EXPECT_EQ(RecordedRun(file).additions().at(0).in_state, !before);
    expect_repeatable(file);
  }
}

TEST(RecordedAddition, IsRepeatedWhereTheRunEndsWithIt) {
  const auto file = record("at_the_end.mcap", run_with([](scene::Scene& scene, recording::Recorder&) {
                             scene.simulation().run(450ms);
                             (void)scene.add(crate());
                           }));
  const RecordedRun recorded(file);
  const recording::RerunResult result = recording::rerun(recorded, {});
  EXPECT_FALSE(result.difference) << to_text(result);
  EXPECT_EQ(result.end, 450ms);
  EXPECT_EQ(recorded.additions().size(), 1U);
}

TEST(RecordedAddition, IsShownFromThenOn) {
  const auto run = std::make_shared<const RecordedRun>(record("shown.mcap", usual_run()));
  recording::RecordedSource source(run);
  source.begin();
  const auto is_there = [&](const char* name) { return source.scene().simulation().world().entity(name).present(); };
  for (const Duration time : {1900ms, 400ms, 600ms, 1050ms, 1200ms, 0ms}) {
    source.seek(time, {}, [] { return false; });
    EXPECT_EQ(is_there("guest"), time >= 500ms) << seconds(time);
    EXPECT_EQ(is_there("crate"), time >= 1100ms) << seconds(time);
    EXPECT_TRUE(is_there("robot"));
  }
  source.seek(1500ms, {}, [] { return false; });
  scene::Scene live("nudge", {.cameras = false});
  live.simulation().run(500ms);
  (void)live.add(guest());
  const Vec3d start = live.simulation().world().entity("guest").base().get(properties::position);
  const Vec3d shown = source.scene().simulation().world().entity("guest").base().get(properties::position);
  EXPECT_GT(norm(shown - start), 0.1) << "it was placed elsewhere, and falls";
}

TEST(RecordedAddition, IsShownWithWhatItDraws) {
  RepeatableRun drawn = run_with([](scene::Scene& scene, recording::Recorder&) {
    scene_file::RobotSpec robot = guest();
    robot.controller = "ros2";
    robot.options["walk"] = false;
    scene.simulation().run(100ms);
    Entity& added = scene.add(robot);
    Drawings& drawings = added.column(properties::drawings).values[0];
    drawings.groups = {
        {.name = "way", .shapes = {{.kind = DrawnShape::line, .points = {{0, 0, 0}, {1, 1, 0}}, .size = 0.01}}}};
    ++drawings.changes;
    scene.simulation().run(100ms);
  });
  drawn.options.what.insert("drawings");
  recording::RecordedSource source(std::make_shared<const RecordedRun>(record("drawn.mcap", drawn)));
  source.begin();
  source.seek(200ms, {}, [] { return false; });
  Entity& robot = source.scene().simulation().world().entity("guest");
  ASSERT_NE(robot.find(properties::drawings), nullptr);
  ASSERT_EQ(robot.base().get(properties::drawings).groups.size(), 1U);
  EXPECT_EQ(robot.base().get(properties::drawings).groups[0].name, "way");
}

TEST(RecordedAddition, HasNumbersFromThenOn) {
  const recording::McapReader file(record("numbers.mcap", usual_run()));
  const auto first = [&](const std::string& name) {
    const auto series = recording::series_of(file, {name});
    EXPECT_FALSE(series.empty() || series[0].times.empty()) << name;
    return series[0].times.front();
  };
  EXPECT_EQ(first("robot.j_torso.position.x"), 0ms);
  EXPECT_EQ(first("crate.crate.position.x"), 1100ms);
  EXPECT_EQ(first("guest.j_neck.joint_position"), 510ms) << "it was let in after the frame of 500 ms";
  EXPECT_GT(first("guest.imu.gyroscope.x"), 500ms);
}

/// A model with a table of its own beside it, in a folder that the scene does not know.
std::filesystem::path own_model(const std::string& name) {
  const auto folder = fixtures::temp_folder() / name;
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "pole.xml") << R"(<mujoco model="pole"><worldbody><body name="foot"><freejoint/>
    <geom type="box" size="0.1 0.1 0.02" mass="1"/><body name="pole" pos="0 0 0.03">
    <joint name="hinge" axis="0 1 0" range="-1 1" limited="true"/>
    <geom type="capsule" size="0.02 0.1" pos="0 0 0.15" mass="0.2"/></body></body></worldbody></mujoco>)";
  return folder / "pole.xml";
}

TEST(RecordedAddition, NeedsNoFilesBesideTheRecording) {
  const auto model = own_model("own_model");
  const auto file = record("own_model.mcap",
                           run_with([&](scene::Scene& scene, recording::Recorder&) { play(scene, model.string()); }));
  std::filesystem::remove_all(model.parent_path());
  expect_repeatable(file);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(bytes.find(fixtures::temp_folder().string()), std::string::npos) << "it names no folder of its maker";
}

TEST(RecordedAddition, IsInAFileThatIsCutOff) {
  std::filesystem::path cut = fixtures::temp_folder() / "cut.mcap";
  (void)record("whole.mcap", run_with([&](scene::Scene& scene, recording::Recorder& recorder) {
                 play(scene);
                 scene.simulation().run(700ms);
                 std::filesystem::copy_file(recorder.file().grows_at(), cut,
                                            std::filesystem::copy_options::overwrite_existing);
               }));
  const RecordedRun cut_off(cut);
  ASSERT_EQ(cut_off.additions().size(), 2U);
  EXPECT_GT(cut_off.end(), 1500ms);
  EXPECT_FALSE(recording::rerun(cut_off, {}).difference);
  const auto mended = fixtures::temp_folder() / "mended.mcap";
  (void)recording::repair(cut, mended);
  expect_repeatable(mended);
}

TEST(RecordedAddition, IsPartOfWhatIsKeptUntilSomethingHappens) {
  auto run = run_with([](scene::Scene& scene, recording::Recorder& recorder) {
    play(scene);  // of which the beginning is forgotten
    recorder.ask(true);
    scene.simulation().run(500ms);
    recorder.ask(false);
  });
  run.options.record_on = {"asked"};
  run.options.keep = 300ms;
  const auto file = record("kept.mcap", run);
  EXPECT_GT(RecordedRun(file).description().start, 1100ms);
  expect_repeatable(file);
}

TEST(RecordedAddition, CameBeforeTheRecording) {
  RepeatableRun run = run_with([](scene::Scene& scene, recording::Recorder&) { scene.simulation().run(1s); });
  run.options.in_the_middle = true;
  run.when_built = [](scene::Scene& scene) { play(scene); };
  expect_repeatable(record("before.mcap", run));
}

// A repetition is recorded like any run, and can be repeated.
TEST(RecordedAddition, IsRecordedAgain) {
  const RecordedRun first(record("first.mcap", usual_run()));
  const auto again = fixtures::temp_folder() / "again.mcap";
  std::unique_ptr<recording::Recorder> recorder;
  const auto prepare = [&](scene::Scene& scene) {
    recording::RecorderOptions options{.file = again};
    options.run = first.description();
    options.files_of = &first.file();
    recorder = std::make_unique<recording::Recorder>(scene, options);
  };
  const auto finish = [&](scene::Scene& scene) { recorder->finish(make_report(scene)); };
  EXPECT_FALSE(recording::rerun(first, {.prepare = prepare, .finish = finish}).difference);
  EXPECT_EQ(last_hash(again), first.states().all().back().hash);
  expect_repeatable(again);
}

/// The state of a run of `nudge` at its end, as a file.
std::string saved(const std::function<void(scene::Scene&)>& play) {
  const auto read = std::make_shared<files::FilesRead>();
  scene::Scene scene("nudge", {.cameras = false, .files = {.noted = read}});
  scene.simulation().initialize();
  const recording::RecordedPaths paths(read->list(), read->names());
  play(scene);
  recording::RunDescription run{.scene = "nudge"};
  run.names = read->names();
  return recording::state_bytes(scene, {.run = paths.in_description(std::move(run)),
                                        .files = recording::files_now(read->list(), paths),
                                        .paths = paths});
}

// Law: a state is of all that was there, so a scene as it was started goes on from it as the run did.
TEST(RecordedAddition, IsPartOfASavedState) {
  std::uint64_t there = 0, later = 0;
  const std::string bytes = saved([&](scene::Scene& scene) { play(scene); });
  {
    scene::Scene scene("nudge", {.cameras = false});
    play(scene);
    there = scene.simulation().state_hash();
    scene.simulation().run(500ms);
    later = scene.simulation().state_hash();
  }
  const auto file = fixtures::temp_folder() / "additions.state";
  files::write_file(file, bytes);
  scene::Scene scene("nudge", {.cameras = false});
  recording::load_state(scene, file);
  EXPECT_EQ(scene.simulation().state_hash(), there);
  EXPECT_EQ(scene.parts().additions.size(), 2U);
  scene.simulation().run(500ms);
  EXPECT_EQ(scene.simulation().state_hash(), later);
  const RecordedRun branch(file);
  const auto other = branch.build({});
  branch.begin(*other, branch.end());
  EXPECT_EQ(other->simulation().state_hash(), there) << "from the file alone";
  recording::load_state(scene, file);  // back: all of them are there
  EXPECT_EQ(scene.simulation().state_hash(), there);
  EXPECT_EQ(scene.parts().additions.size(), 2U);
}

TEST(RecordedAddition, OfAStateNeedsNoFilesBesideIt) {
  const auto model = own_model("model_of_a_state");
  const auto file = fixtures::temp_folder() / "moved.state";
  files::write_file(file, saved([&](scene::Scene& scene) { play(scene, model.string()); }));
  std::filesystem::remove_all(model.parent_path());
  scene::Scene scene("nudge", {.cameras = false});
  recording::load_state(scene, file);
  const recording::McapReader reader(file);
  EXPECT_EQ(scene.simulation().state_hash(), recording::RecordedStates(reader).all().back().hash);
}

// A run that goes on from such a state is recorded with what came before it.
TEST(RecordedAddition, OfAStateIsInTheRecordingThatGoesOnFromIt) {
  const auto model = own_model("model_of_before");
  const auto state = fixtures::temp_folder() / "before.state";
  files::write_file(state, saved([&](scene::Scene& scene) { play(scene, model.string()); }));
  std::filesystem::remove_all(model.parent_path());
  RepeatableRun run = run_with([](scene::Scene& scene, recording::Recorder&) { scene.simulation().run(1s); });
  run.when_initialized = [state](scene::Scene& scene) { recording::load_state(scene, state); };
  const auto file = record("goes_on.mcap", run);
  EXPECT_EQ(RecordedRun(file).additions().size(), 2U);
  expect_repeatable(file);
}

// What a supervisor sends names no files, so it brings nobody.
TEST(RecordedAddition, IsRefusedInAStateThatComesFromElsewhere) {
  const std::string bytes = saved([&](scene::Scene& scene) { play(scene); });
  scene::Scene scene("nudge", {.cameras = false});
  scene.simulation().initialize();
  const std::uint64_t before = scene.simulation().state_hash();
  try {
    recording::load_state_bytes(scene, bytes, "sent.state");
    ADD_FAILURE() << "it was loaded";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("2 robots and bodies came to that run"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(scene.simulation().state_hash(), before);
  play(scene);
  const std::uint64_t there = scene.simulation().state_hash();
  scene.simulation().run(100ms);
  recording::load_state_bytes(scene, bytes, "sent.state");
  EXPECT_EQ(scene.simulation().state_hash(), there) << "of a scene that has them";
}

// Law: a state that does not fit leaves what it brought, absent.
TEST(RecordedAddition, IsAbsentWhereTheStateDoesNotFit) {
  const auto file = fixtures::temp_folder() / "other.state";
  files::write_file(file, saved([&](scene::Scene& scene) { play(scene); }));
  scene::Scene scene("walk", {.cameras = false});
  EXPECT_THROW(recording::load_state(scene, file), SetupError);
  for (const char* name : {"guest", "crate"}) EXPECT_FALSE(scene.simulation().world().entity(name).present());
  EXPECT_EQ(scene.simulation().now(), 0ns);
}

TEST(RecordedAddition, IsWrittenWithAllDigits) {
  scene_file::RobotSpec robot = guest();
  robot.options = {{"walk", false}, {"speed", 0.1}, {"way", std::string("left")}, {"to", Vec3d{1, 2, 1.0 / 3}}};
  robot.integrator = dynamics::Integrator::rk4;
  robot.position.x = 1.0 / 3;
  RecordedAddition addition{.time = 123456789ns, .in_state = false, .channels = {"dds:guest"}, .what = robot};
  addition.names["a\nmodels\n.xml\n"] = "/program/models/a.xml";
  const std::string text = to_json(addition);
  const RecordedAddition read = recording::parse_addition(text);
  EXPECT_EQ(to_json(read), text);
  EXPECT_EQ(read.time, addition.time);
  EXPECT_EQ(read.names, addition.names);
  const auto& same = std::get<scene_file::RobotSpec>(read.what);
  EXPECT_EQ(same.position.x, 1.0 / 3);
  EXPECT_EQ(std::get<std::string>(same.options.at("way")), "left");
  EXPECT_EQ(same.integrator, robot.integrator);
  const auto body = std::get<scene_file::BodySpec>(
      recording::parse_addition(recording::to_json(RecordedAddition{.what = crate()})).what);
  EXPECT_EQ(std::get<Box>(body.shape.value()).half_size.z, 0.07);
}

TEST(RecordedAddition, RefusesWhatIsDamaged) {
  for (const std::string text : {"", "{", "{}", "[]", R"({"schema": "murosimf/addition/9"})",
                                 R"({"schema": "murosimf/addition/1", "robot": {"name": 3}})"}) {
    EXPECT_THROW((void)recording::parse_addition(text), SetupError) << text;
  }
}

}  // namespace
}  // namespace murosimf
