// Same scene and seed, same bits: on every run, for any number of threads.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/temp_folder.h"
#include "tests/written_scene.h"

namespace murosimf::test {
namespace {

std::uint64_t hash_of(int threads, std::uint64_t seed, const std::vector<std::string>& overrides, double duration = 5) {
  scene::Scene scene(std::string(MUROSIMF_SOURCE_DIR) + "/scenes/three_on_three.toml",
                     {.threads = threads, .seed = seed, .overrides = overrides});
  scene.simulation().run(from_seconds(duration));
  return scene.simulation().state_hash();
}

/// On every run and for any number of threads, bit for bit.
void expect_one_hash(const std::string& levels, const std::vector<std::string>& overrides) {
  const std::uint64_t one = hash_of(1, 7, overrides);
  law::Worst differs;
  for (const int threads : {1, 2, 3}) differs.see(hash_of(threads, 7, overrides) == one ? 0 : 1, threads, "threads");
  law::expect_equal({.law = "same scene and seed, other runs with 1, 2 and 3 threads: different states",
                     .level = levels,
                     .source = "the same state hash"},
                    differs, 0, "");
  EXPECT_NE(hash_of(1, 8, overrides), one);
}

TEST(Determinism, HashDependsOnTheSeedOnly) {
  expect_one_hash("three kinematic_walking against three simplified_dynamics", {});
}
TEST(Determinism, HashDependsOnTheSeedOnlyWithLinks) {
  expect_one_hash("three full_dynamics against three articulated_dynamics",
                  {"red.*.level=full_dynamics", "blue.*.level=articulated_dynamics"});
}

// Whether waves are shared out hangs on measured times: nothing else may.
TEST(Determinism, SharingWavesOrNotIsTheSame) {
  const auto hash = [](int threads, Sharing sharing) {
    scene::Scene scene("three_on_three", {.threads = threads});
    scene.simulation().pool().share(sharing);
    scene.simulation().run(from_seconds(4));
    const ThreadPool& pool = scene.simulation().pool();
    EXPECT_EQ(pool.waves_shared(), sharing == Sharing::always ? pool.waves() : pool.waves_shared());
    EXPECT_EQ(pool.waves() > 0, threads > 1);
    return scene.simulation().state_hash();
  };
  const std::uint64_t one = hash(1, Sharing::if_it_pays);
  EXPECT_EQ(hash(2, Sharing::always), one);
  EXPECT_EQ(hash(2, Sharing::if_it_pays), one);
}

/// Pairs of robots that walk into each other, some of which cannot be pushed and touch two pairs.
std::string pairs() {
  std::string text =
      "[defaults]\nmodel = \"kid21\"\nlevel = \"articulated_dynamics\"\ncontroller = \"walk\"\ncommand = [0.2, 0, 0]\n";
  const auto add = [&](const std::string& name, double x, double y, const std::string& more) {
    text += "[[robots]]\nname = \"" + name + "\"\nposition = [" + std::to_string(x) + ", " + std::to_string(y) + "]\n" +
            more;
  };
  for (int i = 0; i < 5; ++i) {
    add("east" + std::to_string(i), 0, 0.3 * i, "");
    add("west" + std::to_string(i), 0.25, 0.3 * i, "heading_deg = 180\n");
    if (i % 2 == 1)
      add("post" + std::to_string(i), 0.12, 0.3 * i + 0.15, "level = \"kinematic_walking\"\ncommand = [0, 0, 0]\n");
  }
  return text;
}

// Islands are solved by several threads.
TEST(Determinism, ManyIslandsOnManyThreads) {
  const std::string file = fixtures::write_scene(pairs());
  const auto hash_after = [&](int threads) {
    scene::Scene scene(file, {.threads = threads});
    scene.simulation().run(from_seconds(1.5));
    return scene.simulation().state_hash();
  };
  const std::uint64_t one = hash_after(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash_after(threads), one) << threads << " threads";
}

// Adding a robot does not change the start of the others: jitter comes from streams named by robot, not drawn one by one.
TEST(Determinism, StartPlacesDoNotDependOnOtherRobots) {
  const std::string file = std::string(MUROSIMF_SOURCE_DIR) + "/scenes/three_on_three.toml";
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string crowded = fixtures::temp_folder().string() + "/" + "crowded.toml";
  std::string longer = text.str();
  longer.insert(longer.find("[[robots]]"), "[[robots]]\nname = \"guest\"\nlevel = \"kinematic_walking\"\n\n");
  std::ofstream(crowded) << longer;
  scene::Scene all(file);
  const Vec3d before = all.simulation().world().entity("red3").options().position;
  scene::Scene more(crowded);
  const Vec3d after = more.simulation().world().entity("red3").options().position;
  law::expect_equal({.law = "one more robot in the scene: change of another one's start",
                     .level = "scene file",
                     .source = "random streams are named by robot: none"},
                    norm(after - before), 0, "m");
}

}  // namespace
}  // namespace murosimf::test
