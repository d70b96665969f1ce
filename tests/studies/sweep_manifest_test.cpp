// Experiments in shards: the same table for any number of shards, whatever was killed, and for nothing but the files of the manifest.
#include "murosimf/studies/sweep_manifest.h"

#include <atomic>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/studies/sweep_file.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace studies;

SweepOptions walks() {
  SweepOptions options{.scene = "walk",
                       .axes = {parse_axis("walker.command.0=0.1,0.2")},
                       .seeds = parse_seeds("1..4"),
                       .duration = 0.1,
                       .results = {"walker.distance", "walker.falls"}};
  options.common.cameras = false;
  return options;
}

ShardOptions one_thread() { return {.common = {.threads = 1}}; }

std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

SweepManifest written(const std::string& name, const SweepOptions& options = walks()) {
  const std::filesystem::path file = fixtures::temp_folder() / name;
  write_manifest(file, options);
  return read_manifest(file);
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

/// Lines of all files of finished runs: a run that was done twice is there twice.
std::multiset<std::string> noted_runs(const SweepManifest& manifest) {
  std::multiset<std::string> runs;
  for (const auto& entry : std::filesystem::directory_iterator(manifest.folder())) {
    std::ifstream lines(entry.path());
    std::string line;
    for (int i = 0; std::getline(lines, line); ++i) {
      if (i >= 2) runs.insert(line.substr(0, line.find(' ')));
    }
  }
  return runs;
}

TEST(Shard, IsEveryNthRun) {
  const Shard shard = parse_shard("2/3");
  EXPECT_EQ(shard.number, 2U);
  EXPECT_EQ(shard.of, 3U);
  EXPECT_FALSE(shard.has(0));
  EXPECT_TRUE(shard.has(1));
  EXPECT_FALSE(shard.has(2));
  EXPECT_TRUE(shard.has(4));
  EXPECT_EQ(parse_shard("any/7").number, 0U);
  EXPECT_EQ(parse_shard("any/7").of, 7U);
  for (const char* bad : {"", "3", "0/3", "4/3", "1/0", "any", "any/", "any/0", "1/2/3", "-1/3", "1/1000001", "1/ 2"}) {
    EXPECT_THROW((void)parse_shard(bad), SetupError) << bad;
  }
}

TEST(SweepManifest, HasTheTableOfASweepForAnyNumberOfShards) {
  SweepOptions alone = walks();
  alone.common.threads = 2;
  const Sweep expected = sweep(alone);
  for (const std::size_t shards : {1, 2, 7}) {
    const SweepManifest manifest = written("shards_" + std::to_string(shards) + ".json");
    EXPECT_EQ(missing_runs(merged(manifest)), 8U);
    for (std::size_t k = shards; k >= 1; --k) (void)run_shard(manifest, {k, shards}, one_thread());
    const Sweep result = merged(manifest);
    EXPECT_EQ(missing_runs(result), 0U);
    EXPECT_EQ(to_csv(result), to_csv(expected)) << shards;
    EXPECT_EQ(to_json(result), to_json(expected)) << shards;
    EXPECT_EQ(noted_runs(manifest).size(), 8U);
  }
}

TEST(SweepManifest, TakesOverWhatOtherShardsHaveDone) {
  const SweepManifest manifest = written("others.json");
  (void)run_shard(manifest, {1, 2}, one_thread());
  const Sweep rest = run_shard(manifest, {}, one_thread());
  EXPECT_EQ(rest.taken_over, 4U);
  EXPECT_EQ(noted_runs(manifest).size(), 8U);
  EXPECT_EQ(to_csv(rest), to_csv(merged(manifest)));
}

// Four workers claim shards of one experiment at once; each run is done by one of them.
TEST(SweepManifest, IsClaimedByWorkers) {
  const SweepManifest manifest = written("claimed.json");
  std::vector<std::thread> workers;
  workers.reserve(4);
  for (int i = 0; i < 4; ++i) workers.emplace_back([&] { (void)run_shard(manifest, {0, 5}, one_thread()); });
  for (std::thread& worker : workers) worker.join();
  EXPECT_EQ(missing_runs(merged(manifest)), 0U);
  EXPECT_EQ(noted_runs(manifest), (std::multiset<std::string>{"0", "1", "2", "3", "4", "5", "6", "7"}));
}

TEST(SweepManifest, WaitsForWhoWorksOnTheShard) {
  const SweepManifest manifest = written("waits.json");
  std::filesystem::create_directories(manifest.folder());
  auto held = std::make_unique<SweepFile>(manifest.folder() / "1_of_2.txt", manifest.description, 2);
  const Sweep free_ones = run_shard(manifest, {0, 2}, one_thread());
  EXPECT_EQ(missing_runs(free_ones), 4U) << "shards that are held are left alone";
  ShardOptions options = one_thread();
  int waits = 0;
  options.waits = [&](const std::string& writer) {
    EXPECT_NE(writer.find("process"), std::string::npos);
    ++waits;
    held->add(0, {1, 2});
    held.reset();
  };
  const Sweep result = run_shard(manifest, {1, 2}, options);
  EXPECT_EQ(waits, 1);
  EXPECT_EQ(result.runs[0].values, (std::vector<double>{1, 2})) << "what the other had done stays";
  EXPECT_EQ(missing_runs(result), 0U);
}

TEST(SweepManifest, IsFoundFromAnyFolder) {
  const std::filesystem::path folder = fixtures::temp_folder() / "experiment";
  std::filesystem::create_directories(folder / "scenes");
  std::ofstream(folder / "scenes/mine.toml") << "[[robots]]\nname = \"walker\"\nmodel = \"kid21\"\n";
  SweepOptions options = walks();
  options.scene = (folder / "scenes/mine.toml").string();
  options.axes = {};
  write_manifest(folder / "all.json", options);
  std::filesystem::rename(folder, fixtures::temp_folder() / "moved");
  const SweepManifest manifest = read_manifest(fixtures::temp_folder() / "moved/all.json");
  EXPECT_EQ(manifest.options.scene_name, "scenes/mine.toml");
  EXPECT_EQ(missing_runs(run_shard(manifest, {}, one_thread())), 0U);
}

TEST(SweepManifest, RefusesFilesThatAreNotItsOwn) {
  const std::filesystem::path scene = fixtures::temp_folder() / "changes.toml";
  std::ofstream(scene) << "[[robots]]\nname = \"walker\"\nmodel = \"kid21\"\n";
  SweepOptions options = walks();
  options.scene = scene.string();
  options.axes = {};
  const SweepManifest manifest = written("changes.json", options);
  (void)run_shard(manifest, {1, 2}, one_thread());
  std::ofstream(scene, std::ios::app) << "# changed\n";
  const std::string message = message_of([&] { (void)run_shard(manifest, {2, 2}, one_thread()); });
  EXPECT_NE(message.find("changes.json"), std::string::npos) << message;
  EXPECT_NE(message.find("changes.toml' has changed"), std::string::npos) << message;
  EXPECT_EQ(missing_runs(merged(manifest)), 2U) << "what is done stays";

  ShardOptions newer = one_thread();
  newer.program = "another program";
  EXPECT_NE(message_of([&] { (void)run_shard(written("program.json"), {}, newer); }).find("another program"),
            std::string::npos);
}

// Files that only the second value of an axis reads belong to the experiment, too.
TEST(SweepManifest, KnowsFilesOfAllValues) {
  SweepOptions options = walks();
  options.axes = {parse_axis("walker.model=kid21,booster_k1")};
  const SweepManifest manifest = written("values.json", options);
  EXPECT_NE(manifest.description.find("booster_k1"), manifest.description.rfind("booster_k1"))
      << "as a value, and as a file";
}

TEST(SweepManifest, RefusesRunsOfAnotherOne) {
  const SweepManifest manifest = written("mixed.json");
  (void)run_shard(manifest, {1, 4}, one_thread());
  SweepOptions options = walks();
  options.duration = 0.2;
  const SweepManifest longer = written("longer.json", options);
  std::filesystem::create_directories(longer.folder());
  std::filesystem::copy_file(manifest.folder() / "1_of_4.txt", longer.folder() / "1_of_4.txt");
  EXPECT_NE(message_of([&] { (void)merged(longer); }).find("1_of_4.txt: it is of another sweep"), std::string::npos);

  std::string other = text_of(manifest.folder() / "1_of_4.txt");
  other.insert(other.size() - 1, "1");  // another last digit of its last run
  std::ofstream(manifest.folder() / "1_of_1.txt") << other;
  EXPECT_NE(message_of([&] { (void)merged(manifest); }).find("run 4: its results are"), std::string::npos);
}

TEST(SweepManifest, RefusesWhatWasChangedByHand) {
  const SweepManifest manifest = written("hand.json");
  const std::string good = text_of(manifest.file);
  for (const auto& [from, to] :
       {std::pair{"\"seed\": 2", "\"seed\": 9"}, std::pair{"\"lenient\": false", "\"lenient\": true"},
        std::pair{"walker.command.0=0.2", "walker.command.0=0.3"}}) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), std::string(from).size(), to);
    std::ofstream(manifest.file) << bad;
    EXPECT_NE(message_of([&] { (void)read_manifest(manifest.file); }).find("was changed"), std::string::npos) << from;
  }
  for (const auto& [from, to] : {std::pair{"\"duration_ns\": 100000000", "\"duration_ns\": -1"},
                                 std::pair{"\"seeds\": [", "\"seeds\": [], \"other\": ["}}) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), std::string(from).size(), to);
    std::ofstream(manifest.file) << bad;
    const std::string message = message_of([&] { (void)read_manifest(manifest.file); });
    EXPECT_TRUE(message.find("no runs") != std::string::npos || message.find("duration_ns") != std::string::npos)
        << message;
  }
  for (const char* bad : {"", "{}", "[1]", "{\"schema\": \"murosimf/sweep_manifest/1\", \"experiment\": 3}"}) {
    std::ofstream(manifest.file) << bad;
    EXPECT_THROW((void)read_manifest(manifest.file), SetupError) << bad;
  }
  EXPECT_THROW(write_manifest(manifest.file, walks()), SetupError) << "it overwrites no other file";
}

}  // namespace
}  // namespace murosimf
