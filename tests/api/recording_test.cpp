// include/murosimf/recording.h: what is recorded is what was, and can be repeated.
#include "murosimf/recording.h"

#include <gtest/gtest.h>

#include <fstream>

#include "murosimf/recording/recorded_run.h"
#include "tests/temp_folder.h"

namespace murosimf::api {
namespace {

std::string file_of(const std::string& name) { return (fixtures::temp_folder() / (name + ".mcap")).string(); }

TEST(ApiRecording, HasTheNumbersOfTheRun) {
  const std::string file = file_of("numbers");
  Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
  const Robot walker = scene.robot();
  Recorder recorder(scene, file, 50);
  std::vector<double> x;
  for (int i = 0; i < 50; ++i) {
    x.push_back(walker.pose().position.x);
    scene.run(0.02);
  }
  recorder.finish();
  scene.run(0.5);  // not in the file
  const Recording recording(file);
  const std::vector<Series> found = recording.series("walker." + walker.objects()[0] + ".position.x");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].unit, "m");
  ASSERT_GE(found[0].values.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(found[0].times[i], 0.02 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(found[0].values[i], x[i], 1.6e-5);  // written in steps of 2^-15 m
  }
  EXPECT_LE(found[0].times.back(), 1.0 + 1e-9);
  EXPECT_GT(recording.names().size(), 20U);
  EXPECT_THROW((void)recording.series("runner"), InputError);
}

TEST(ApiRecording, IsRepeatedByTheProgram) {
  const std::string file = file_of("again");
  Scene scene("walk", {.seed = 5, .set = {"walker.level=simplified_dynamics"}});
  Recorder recorder(scene, file);
  scene.run(0.2);
  scene.change("walker.command=[0.1, 0, 0]");
  scene.run(0.3);
  recorder.finish();
  const recording::RecordedRun run(file);
  const auto again = run.build({});
  run.begin(*again, Duration{}, false);
  again->simulation().run(std::chrono::milliseconds(500));
  EXPECT_EQ(again->simulation().state_hash(), scene.state_hash());
}

TEST(ApiRecording, RepeatsWhatWasAdded) {
  const std::string file = file_of("added");
  Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
  scene.run(0.1);
  (void)scene.add(NewRobot{.name = "before", .model = "kid21", .position = {-1, 1, 0}});
  Recorder recorder(scene, file);
  scene.run(0.2);
  (void)scene.add(NewRobot{
      .name = "second", .model = "spark_nao0", .level = "full_dynamics", .controller = "walk", .position = {1, 1, 0}});
  (void)scene.add(
      NewBody{.name = "pole", .shape = NewBody::Shape::capsule, .size = {0.03, 0, 0.2}, .velocity = {1, 0, 0}});
  scene.run(0.3);
  recorder.finish();
  const recording::RecordedRun run(file);
  ASSERT_EQ(run.additions().size(), 3U);
  const auto again = run.build({.threads = 2});
  run.begin(*again, Duration{});
  again->simulation().run(std::chrono::milliseconds(500));
  EXPECT_EQ(again->simulation().state_hash(), scene.state_hash());
}

TEST(ApiRecording, BeginsInTheMiddle) {
  const std::string file = file_of("middle");
  Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
  scene.run(0.4);
  Recorder recorder(scene, file);
  scene.run(0.2);
  recorder.finish();
  const std::vector<Series> x = Recording(file).series("walker.j_head.joint_position");
  ASSERT_EQ(x.size(), 1U);
  EXPECT_NEAR(x[0].times.front(), 0.4, 1e-9);
  EXPECT_NEAR(x[0].times.back(), 0.6, 1e-9);
  EXPECT_EQ(x[0].times.size(), 21U);
  const recording::RecordedRun run(file);
  const auto again = run.build({});
  run.begin(*again, std::chrono::milliseconds(400));
  again->simulation().run(std::chrono::milliseconds(200));
  EXPECT_EQ(again->simulation().state_hash(), scene.state_hash());
}

TEST(ApiRecording, OfACopyIsRepeated) {
  const std::string file = file_of("copy");
  Scene first = Scene::of_text("[[robots]]\nname = \"a\"\nmodel = \"kid21\"\n");
  first.run(0.1);
  Scene scene = first.copy();
  Recorder recorder(scene, file);
  scene.run(0.1);
  recorder.finish();
  const recording::RecordedRun run(file);
  const auto again = run.build({});
  run.begin(*again, std::chrono::milliseconds(100));
  again->simulation().run(std::chrono::milliseconds(100));
  EXPECT_EQ(again->simulation().state_hash(), scene.state_hash());
}

TEST(ApiRecording, SaysWhatIsWrong) {
  Scene scene("walk");
  EXPECT_THROW(Recorder(scene, "/no/such/folder/a.mcap"), InputError);
  EXPECT_THROW(Recorder(scene, file_of("rate"), 0), InputError);
  EXPECT_THROW(Recording("/no/such/file.mcap"), InputError);
  const std::string text = file_of("text");
  std::ofstream(text) << "this is no recording";
  EXPECT_THROW((void)Recording{text}, InputError);
}

TEST(ApiRecording, IsWholeWithoutFinish) {
  const std::string file = file_of("dropped");
  {
    Scene scene("walk");
    const Recorder recorder(scene, file);
    scene.run(0.1);
  }
  EXPECT_TRUE(recording::McapReader(file).contents().damage.empty());
}

}  // namespace
}  // namespace murosimf::api
