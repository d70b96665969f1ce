// Runs that are repeated, drawn, gone on with and made many of, as a user meets them.
#include <random>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  std::stringstream list(murosimf("list scenes").output);
  for (std::string line; std::getline(list, line);) names.push_back(line.substr(0, line.find(' ')));
  EXPECT_GT(names.size(), 10U);
  return names;
}

// A state at any instant, through a file and another process; and the whole run again from its recording.
TEST(Rerun, EverySceneGoesOnAndIsRepeatedBitForBit) {
  std::mt19937 random(22);
  const std::string state = scratch("a.state").string(), file = scratch("run.mcap").string();
  for (const std::string& name : scenes()) {
    const std::string scene = "run " + name + " --no-cameras --duration 0.6";
    const double time = std::uniform_int_distribution<int>(1, 599)(random) / 1000.0;
    const Result whole = murosimf(scene + " --record " + file + " --save-at " + std::to_string(time) + ":" + state);
    if (whole.exit_code == 2) continue;  // it needs another program, or control software that is not here
    EXPECT_EQ(state_hash_in(murosimf(scene + " --from " + state).output), state_hash_in(whole.output))
        << name << " at " << time;
    const Result again = murosimf("rerun " + file);
    EXPECT_EQ(again.exit_code, 0) << name << ": " << again.output << again.errors;
    EXPECT_NE(again.output.find("no difference"), std::string::npos) << name;
  }
}

TEST(Rerun, AgainstAnotherProgramNamesWhatDiffers) {
  const std::string file = scratch("run.mcap").string(), other = scratch("other.mcap").string();
  EXPECT_EQ(murosimf("run walk --duration 1.2 --record " + file).exit_code, 0);
  EXPECT_EQ(murosimf("rerun " + file + " --against " + MUROSIMF_PROGRAM).exit_code, 0);
  EXPECT_EQ(murosimf("run walk --duration 1.2 --set walker.command.0=0.25 --record " + other).exit_code, 0);
  // a program that takes another command for the same one
  const fs::path folder = scratch("bin");
  path_with_program(folder, "other", "shift 2; exec " + std::string(MUROSIMF_PROGRAM) + " rerun " + other + " \"$@\"");
  const Result result = murosimf("rerun " + file + " --against " + (folder / "other").string());
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_NE(result.output.find("walk_command[0]: 0.25 and 0.2"), std::string::npos) << result.output;
  expect_mistake("rerun " + file + " --against /no/such/program", {"/no/such/program", "no such program"});
}

TEST(Rerun, MistakesAreOneLine) {
  const std::string file = scratch("run.mcap").string();
  expect_mistake("run walk --duration 0.1 --record-ticks 1..2", {"--record-ticks", "--record"});
  for (const std::string ticks : {"1", "2..1", "a..b", "1..", "-1..2"}) {
    expect_mistake("run walk --duration 0.1 --record " + file + " --record-ticks=" + ticks, {"--record-ticks", ticks});
  }
  expect_mistake("run walk --duration 0.1 --record " + file + " --record-states 0", {"--record-states 0"});
  expect_mistake("run walk --duration 0.1 --save-at 1", {"--save-at '1'", "TIME:FILE"});
  expect_mistake("run walk --duration 0.1 --save-at 1:/nowhere/a.state", {"/nowhere/a.state"});
  expect_mistake("rerun " + write("text.mcap", "no recording").string(), {"text.mcap", "no MCAP file"});
  EXPECT_EQ(murosimf("run walk --duration 0.1 --record " + file + " --record-what poses").exit_code, 0);
  expect_mistake("rerun " + file, {file, "no state hashes"});
}

TEST(Rerun, SaysThatAStateCouldNotBeSaved) {
  const Result late = murosimf("run walk --duration 0.1 --save-at 3:" + scratch("late.state").string());
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_NE(late.errors.find("there is no such state"), std::string::npos) << late.errors;
}

// A picture of the recording is the live one, byte for byte.
TEST(Rerun, PicturesAreThoseOfTheLiveRun) {
  const std::string file = scratch("run.mcap").string(), of_file = scratch("a.png").string(),
                    live = scratch("b.png").string();
  const std::string state = scratch("a.state").string();
  EXPECT_EQ(murosimf("run three_on_three --no-cameras --duration 1 --save-at 0.7:" + state + " --record " + file +
                     " --record-states 0.3")
                .exit_code,
            0);
  const Result drawn = murosimf("render " + file + " --time 0.7 --out " + of_file);
  if (drawn.exit_code != 0 && drawn.errors.find("draw") != std::string::npos) GTEST_SKIP() << drawn.errors;
  for (const std::string how : {"--time 0.7", "--time 0.7 --view top --size 320x200", "--time 0.7 --light night",
                                "--time 0.7 --camera blue1.camera", "--time 0 --layer depth"}) {
    EXPECT_EQ(murosimf("render three_on_three " + how + " --out " + live).exit_code, 0) << how;
    EXPECT_EQ(murosimf("render " + file + " " + how + " --out " + of_file).exit_code, 0) << how;
    EXPECT_EQ(read_file(of_file), read_file(live)) << how;
  }
  EXPECT_EQ(murosimf("render three_on_three --time 0.7 --out " + live).exit_code, 0);
  EXPECT_EQ(murosimf("render " + state + " --time 0.7 --out " + of_file).exit_code, 0);
  EXPECT_EQ(read_file(of_file), read_file(live));
  expect_mistake("render " + file + " --time 3 --out " + live, {"--time 3", "ends at 1 s"});
  expect_mistake("render " + file + " --seed 3 --out " + live, {"is a recording"});
}

TEST(Branch, IsATableOfContinuations) {
  const std::string state = scratch("one.state").string(), table = scratch("table.csv").string();
  EXPECT_EQ(murosimf("run walk --duration 1 --save-at 0.5:" + state).exit_code, 0);
  const Result result = murosimf("branch " + state + " --duration 0.5 --set 'walker.command=[0,0,0]' --csv " + table);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read_file(table).substr(0, read_file(table).find('\n')),
            "branch,walker.distance [m],walker.falls,state hash");
  EXPECT_NE(result.output.find("as it was"), std::string::npos) << result.output;
  EXPECT_NE(murosimf("branch " + state + " --json -").output.find("murosimf/branch/1"), std::string::npos);
  expect_mistake("branch " + state + " --set walker.comand=1", {"walker.comand"});
  expect_mistake("branch " + state + " --time 7", {state, "7 s"});
}

// A thousand runs, killed four times as soon as so many of them are done.
TEST(Sweep, GoesOnAfterItWasKilled) {
  const std::string sweep = "sweep walk --seeds 1..500 --grid walker.command.0=0.1,0.2 --duration 0.1 --threads 2";
  const fs::path whole = scratch("whole.csv"), table = scratch("table.csv"), runs = scratch("runs.txt");
  EXPECT_EQ(murosimf(sweep + " --csv " + whole.string()).exit_code, 0);
  const fs::path script =
      write("script.sh", std::string(MUROSIMF_PROGRAM) + " " + sweep + " --runs " + runs.string() +
                             " >/dev/null 2>&1 &\n"
                             "while kill -0 $! && ! [[ $(wc -l <" +
                             runs.string() + ") -ge $1 ]]; do sleep 0.002; done 2>/dev/null\nkill -9 $!; wait\n");
  std::mt19937 random(4);
  for (int i = 0; i < 4; ++i) {
    const int done = 200 * i + 50 + static_cast<int>(random() % 100);
    (void)!std::system(("bash " + script.string() + " " + std::to_string(done) + " 2>/dev/null").c_str());
    const std::string lines = read_file(runs);
    EXPECT_GE(std::count(lines.begin(), lines.end(), '\n'), done);
  }
  const Result last = murosimf(sweep + " --runs " + runs.string() + " --csv " + table.string());
  EXPECT_EQ(last.exit_code, 0) << last.errors;
  const std::string rows = read_file(table);
  EXPECT_EQ(rows, read_file(whole));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1001) << "a line for each, and the head";
}

TEST(Sweep, MistakesAreOneLine) {
  expect_mistake("sweep walk --seeds 5..1", {"--seeds '5..1'"});
  expect_mistake("sweep walk --grid walker.command.0", {"--grid", "PATH=VALUE"});
  expect_mistake("sweep walk --grid walker.command.7=1", {"walker.command.7"});
  expect_mistake("sweep walk --result walker.distanse", {"distanse"});
  expect_mistake("sweep walk --duration nan", {"--duration"});
  expect_mistake("sweep walk --runs " + write("runs.txt", "poems\n").string(), {"runs.txt", "no file of a sweep"});
}

TEST(Sweep, RunsAManifestInShards) {
  const std::string manifest = scratch("walks.json").string(), table = scratch("shards.csv").string();
  const std::string runs = "sweep walk --seeds 1..3 --grid walker.command.0=0.1,0.2 --duration 0.1";
  EXPECT_EQ(murosimf(runs + " --manifest " + manifest).exit_code, 0);
  EXPECT_EQ(murosimf("sweep " + manifest + " --shard 2/2").output,
            "shard 2/2: 3 of all 6 runs are done, 3 are missing\n");
  const Result part = murosimf("sweep " + manifest + " --merge");
  EXPECT_EQ(part.exit_code, 1);
  EXPECT_NE(part.errors.find("3 of 6 runs are missing"), std::string::npos) << part.errors;
  EXPECT_EQ(murosimf("sweep " + manifest + " --shard any/2").exit_code, 0);
  EXPECT_EQ(murosimf("sweep " + manifest + " --merge --csv " + table).exit_code, 0);
  EXPECT_EQ(murosimf(runs + " --csv " + scratch("at_once.csv").string()).exit_code, 0);
  EXPECT_EQ(read_file(table), read_file(scratch("at_once.csv")));
  expect_mistake("sweep " + manifest + " --seeds 1", {"--seeds", "part of the manifest"});
  expect_mistake("sweep " + manifest + " --shard 5/2", {"--shard '5/2'", "K/N"});
  expect_mistake("sweep " + manifest + " --shard 1/2 --csv " + table, {"--shard", "--merge"});
  expect_mistake("sweep " + manifest + " --shard 1/2 --merge", {"--merge", "--shard"});
  expect_mistake("sweep walk --shard 1/2", {"--shard", "--manifest"});
  expect_mistake("sweep walk --manifest walks.txt", {"walks.txt", ".json"});
  expect_mistake("sweep " + write("poem.json", "poems").string(), {"poem.json", "no manifest"});
}

}  // namespace
}  // namespace murosimf::test
