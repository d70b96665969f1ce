// `murosimf tune` from outside: ended in the middle it goes on as if it had not been, and it says in one line what is wrong.
#include "tests/apps/program.h"
#include "tests/hasty_motion.h"

namespace murosimf::test {
namespace {

/// Of the file of the running test; two generations.
std::string small_search() {
  return "tune " + write("hasty.toml", fixtures::hasty_motion).string() +
         " --model kid21 --from back --levels full_dynamics --evaluations 34 --threads 2";
}

/// What stands below the head.
std::string motion_in(const fs::path& file) {
  const std::string text = read_file(file);
  return text.substr(std::min(text.find("columns"), text.size()));
}

/// Sends the signal as soon as there is a state. Its exit code, as shells have it.
std::string end_by(const std::string& signal, const fs::path& out) {
  const fs::path errors = scratch("err"), code = scratch("code"), state = out.string() + ".state";
  const std::string command = std::string(MUROSIMF_PROGRAM) + " " + small_search() + " --out " + out.string() + " >" +
                              scratch("shown").string() + " 2>" + errors.string();
  const std::string script = command + " & pid=$!; while [ ! -s " + state.string() +
                             " ] && kill -0 $pid; do sleep 0.02; done; kill -" + signal +
                             " $pid; wait $pid; echo $? >" + code.string();
  (void)std::system(("sh -c '" + script + "' 2>/dev/null").c_str());
  return read_file(code);
}

TEST(Tune, GoesOnAfterItWasEnded) {
  const fs::path through = scratch("through.toml"), killed = scratch("killed.toml"), ended = scratch("ended.toml");
  ASSERT_EQ(murosimf(small_search() + " --out " + through.string()).exit_code, 0);
  EXPECT_FALSE(fs::exists(through.string() + ".state")) << "it is at its end";
  EXPECT_NE(read_file(through).find("# found by: murosimf tune "), std::string::npos);

  EXPECT_EQ(end_by("KILL", killed), "137\n");
  EXPECT_FALSE(fs::exists(killed));
  const Result on = murosimf(small_search() + " --out " + killed.string());
  EXPECT_EQ(on.exit_code, 0) << on.errors;
  EXPECT_NE(on.errors.find("went on after "), std::string::npos) << on.errors;
  EXPECT_EQ(motion_in(killed), motion_in(through));

  EXPECT_EQ(end_by("TERM", ended), "143\n");
  EXPECT_NE(read_file(ended).find("not yet at its end"), std::string::npos) << "the best so far";
  EXPECT_TRUE(fs::exists(ended.string() + ".state"));
  EXPECT_EQ(murosimf(small_search() + " --out " + ended.string()).exit_code, 0);
  EXPECT_EQ(motion_in(ended), motion_in(through));
}

// The obvious name for the result of `tune walk` is that of a scene, too.
TEST(Tune, IsFollowedByFitStepsWhereAFileIsCalledWalk) {
  const fs::path folder = scratch("folder"), before = fs::current_path();
  fs::create_directories(folder);
  std::ofstream(folder / "walk.toml") << "[walk]\nlift = 0.03\n";
  fs::current_path(folder);
  const Result result = murosimf("fit-steps --model kid21 --rounds 1 --duration 3 --out steps.csv");
  fs::current_path(before);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

TEST(Tune, SaysWhatIsWrong) {
  expect_mistake("tune get_up_frond --model kid21 --from front", {"get_up_frond", "did you mean 'get_up_front'?"});
  expect_mistake("tune get_up_front --model quadruped --from front", {"j_l_sh_pitch"});
  expect_mistake("tune get_up_front --model kid21 --from front --levels half_dynamics",
                 {"unknown level 'half_dynamics'"});
  expect_mistake("tune get_up_front --model kid21 --from front --levels kinematic_walking",
                 {"kinematic_walking", "always stand"});
  expect_mistake("tune get_up_front --model kid21", {"--from is missing"});
  expect_mistake("tune get_up_front --model kid21 --from front --speed 0.1", {"--speed", "a motion"});
  expect_mistake("tune get_up_front --model kid21 --from front --ball 1,2", {"--ball", "does not kick"});
  expect_mistake("tune kick --model kid21 --goal kicks --ball 1x2", {"--ball '1x2'"});
  expect_mistake("tune walk --model kid21 --goal stands", {"--goal", "a walk"});
  expect_mistake("tune walk --model kid21 --fastest 6", {"--fastest", "a walk"});
  expect_mistake("tune walk --model kid21 --impulse 3", {"--impulse", "without pushes"});
  expect_mistake("tune balance --model kid21 --from front", {"--from", "a walk"});
  expect_mistake("tune balance --model kid21 --levels kinematic_walking", {"kinematic_walking", "pushes move nothing"});
  expect_mistake("tune walk --model car", {"car"});
  const fs::path out = scratch("other.toml");
  write("other.toml.state", "{}");
  expect_mistake(small_search() + " --out " + out.string(), {"other.toml.state", "it is no state of a search"});
}

}  // namespace
}  // namespace murosimf::test
