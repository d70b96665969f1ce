// Scenes that someone asks for over a network: of which files they are made, what they must not do, and what is told of errors.
#include "murosimf/scene/requested_scene.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::scene {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;
using fixtures::says;

constexpr const char* walker = "[[robots]]\nname = \"robot\"\nmodel = \"kid21\"\n";

std::string box_of(const std::string& mesh_file, const std::string& use) {
  return "<mujoco><asset><mesh name=\"m\" file=\"" + mesh_file +
         "\"/></asset><worldbody><body name=\"box\"><freejoint/>"
         "<geom type=\"box\" size=\"0.1 0.1 0.1\" mass=\"1\"/><geom type=\"mesh\" mesh=\"m\" " +
         use + "/></body></worldbody></mujoco>\n";
}

/// run/first.toml, of which a run was made, beside what else may be asked for; other/ is not theirs.
class RequestedScene : public testing::Test {
 protected:
  RequestedScene() {
    fs::create_directories(root_ / "run");
    fs::create_directories(root_ / "other");
    write("run/first.toml", walker);
    write("other/second.toml", walker);
    write("other/secret.toml", "password = \"CANARY\"\n");
    write("other/tetrahedron.stl", tetrahedron());
    const Scene scene(root_ / "run/first.toml");
    allowed_ = files_of_run(scene, {}, {});
  }
  ~RequestedScene() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  static std::string tetrahedron() {
    const char* corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::string text = "solid s\n";
    for (const auto& face : faces) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int corner : face) text += std::string("vertex ") + corners[corner] + "\n";
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid s\n";
  }
  /// Builds it as a door would; what is told, empty if nothing is wrong. `whole_` is what the run itself says.
  std::string ask(const std::string& name, std::vector<std::string> overrides = {}, SceneOptions options = {}) {
    options.overrides = std::move(overrides);
    options.files.only_from = allowed_;
    whole_.clear();
    try {
      for_outside(name, options, [&] {
        Scene scene(name, options);
        scene.simulation().initialize();
      });
    } catch (const RequestError& error) {
      whole_ = error.whole();
      return error.what();
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  }
  [[nodiscard]] std::string in_run(const std::string& name) const { return (root_ / "run" / name).string(); }

  const fs::path root_ = fixtures::temp_folder() / "requested_scene";
  std::shared_ptr<const files::AllowedFiles> allowed_;
  std::string whole_;
};

TEST_F(RequestedScene, FilesOfTheRunAndOfTheProgram) {
  EXPECT_EQ(ask("nudge", {"robot.level=simplified_dynamics"}), "");
  EXPECT_EQ(ask(in_run("first.toml"), {"robot.model=models/kid21.xml"}), "");
  EXPECT_EQ(ask("examples/controllers/to_the_ball.toml").find("no file"), std::string::npos);
}

TEST_F(RequestedScene, NoOthersAndNotWhetherTheyAreThere) {
  const std::string there = ask((root_ / "other/second.toml").string());
  fs::remove(root_ / "other/second.toml");
  EXPECT_EQ(ask((root_ / "other/second.toml").string()), there);
  EXPECT_TRUE(says(there, {"no file", "second.toml"}));
  for (const std::string& name :
       {std::string("/etc/passwd"), std::string("/proc/self/environ"), std::string("/dev/zero"),
        in_run("../other/secret.toml"), std::string("../../../../etc/passwd")}) {
    EXPECT_TRUE(says(ask(name), {"no file"})) << name;
  }
  EXPECT_EQ(ask("walk\n.toml"), "this is no name of a scene");
  EXPECT_EQ(ask(std::string(5000, 'x')), "this is no name of a scene");
  EXPECT_FALSE(ask("").empty());
}

TEST_F(RequestedScene, FoldersAndFilesThatTheCommandLineNames) {
  const Scene scene("walk");
  allowed_ = files_of_run(scene, {root_ / "other"}, {});
  EXPECT_EQ(ask((root_ / "other/second.toml").string()), "");
  EXPECT_FALSE(ask(in_run("first.toml")).empty());
  allowed_ = files_of_run(scene, {}, {root_ / "run/first.toml"});
  EXPECT_EQ(ask(in_run("first.toml")), "");
}

// Also one that stands beside the scene: only --libraries lets it in.
TEST_F(RequestedScene, LoadsNoSoftware) {
  write("run/soft.toml", std::string(walker) + "controller = \"library\"\nlibrary = \"./soft.so\"\n");
  write("run/soft.so", "no library");
  write("run/elsewhere.toml",
        std::string(walker) + "controller = \"library\"\nlibrary = \"../other/tetrahedron.stl\"\n");
  EXPECT_TRUE(says(ask(in_run("soft.toml")), {"soft.toml:", "the scene cannot be built"}));
  EXPECT_TRUE(says(whole_, {"--libraries"}));
  EXPECT_TRUE(says(ask(in_run("first.toml"), {"robot.library=soft.so"}), {"'library' is not among the settings"}));
  EXPECT_TRUE(says(ask(in_run("first.toml"), {"robot.controller=library", "robot.library=soft.so"}), {"command line"}));
  write("run/class.toml", std::string(walker) + "controller = \"python\"\noptions = {class = \"soft:Walk\"}\n");
  write("run/soft.py", "open('" + (root_ / "ran").string() + "', 'w')\n");
  EXPECT_TRUE(says(ask(in_run("class.toml")), {"class.toml:", "the scene cannot be built"}));
  EXPECT_TRUE(says(whole_, {"'soft:Walk'", "--libraries"}));
  for (const char* text : {"robot.controller=python", "defaults.controller=python"}) {
    EXPECT_TRUE(says(ask(in_run("first.toml"), {text}), {"command line"})) << text;
  }
  EXPECT_TRUE(says(ask(in_run("first.toml"), {"robot.options.class=soft:Walk"}), {"texts"}));
  EXPECT_FALSE(std::filesystem::exists(root_ / "ran")) << "nothing of it was run";
  write("run/away.toml", std::string(walker) + "controller = \"python\"\noptions = {class = \"json:JSONDecoder\"}\n");
  EXPECT_FALSE(ask(in_run("away.toml"), {}, {.libraries = true}).empty());
  EXPECT_TRUE(says(whole_, {"no module 'json' beside the scene"}));
  EXPECT_FALSE(ask(in_run("soft.toml"), {}, {.libraries = true}).empty());
  EXPECT_TRUE(says(whole_, {"soft.so", "cannot be loaded"})) << "allowed, but none";
  EXPECT_FALSE(ask(in_run("elsewhere.toml"), {}, {.libraries = true}).empty());
  EXPECT_TRUE(says(whole_, {"no file '../other/tetrahedron.stl'"}));
}

TEST_F(RequestedScene, IsMadeWithTheSameRulesWhoeverBuildsIt) {
  const SceneOptions options{.overrides = {"robot.library=soft.so"}, .files = {.only_from = allowed_}};
  EXPECT_TRUE(says(error_of([&] { const Scene scene("nudge", options); }), {"not among the settings"}));
  const auto second = (root_ / "other/second.toml").string();
  EXPECT_TRUE(says(error_of([&] { const Scene scene(second, {.files = {.only_from = allowed_}}); }), {"no file"}));
}

TEST_F(RequestedScene, MeshesFromElsewhere) {
  const std::string body = "[[bodies]]\nname = \"box\"\nmodel = \"./box.xml\"\n";
  write("run/with_mesh.toml", body);
  for (const std::string use : {"mass=\"0.1\"", "contype=\"0\" conaffinity=\"0\" group=\"2\" mass=\"0\""}) {
    write("run/mesh.stl", tetrahedron());
    write("run/box.xml", box_of("mesh.stl", use));
    EXPECT_EQ(ask(in_run("with_mesh.toml")), "") << use << whole_;
    for (const std::string& file :
         {std::string("../other/tetrahedron.stl"), (root_ / "other/tetrahedron.stl").string()}) {
      write("run/box.xml", box_of(file, use));
      EXPECT_FALSE(ask(in_run("with_mesh.toml")).empty()) << file;
      EXPECT_TRUE(says(whole_, {"in none of the folders that may be read here"}));
    }
  }
}

TEST_F(RequestedScene, OtherFilesThatAScenesNames) {
  const auto refused = [&](const std::string& more) {
    write("run/more.toml", walker + more);
    return !ask(in_run("more.toml")).empty() && !whole_.empty();
  };
  write("other/gait.csv", "time\n0\n");
  EXPECT_TRUE(refused("controller = \"trajectory\"\noptions = {file = \"../other/gait.csv\"}\n"));
  EXPECT_TRUE(says(whole_, {"no file '../other/gait.csv'"}));
  EXPECT_TRUE(refused("controller = \"keyframes\"\nmotion = \"../other/secret.toml\"\n"));
  EXPECT_TRUE(refused("sensors.imu = {part = \"../other/secret.toml\"}\n"));
}

// Names of files and lines, nothing of what stands there; the run itself says all.
TEST_F(RequestedScene, TellsNothingThatStandsInFiles) {
  const auto told = [&](const std::string& name, const std::string& text, std::vector<std::string> overrides = {}) {
    write("run/" + name, text);
    const std::string answer = ask(in_run(name), std::move(overrides));
    EXPECT_EQ(answer.find("CANARY"), std::string::npos) << answer;
    EXPECT_EQ(answer.find(root_.string()), std::string::npos) << answer;
    return answer;
  };
  EXPECT_TRUE(says(told("a.toml", "\npassword = \"CANARY\"\n"), {"a.toml:2: the scene cannot be built"}));
  EXPECT_TRUE(says(whole_, {"a.toml:2", "password"}));
  EXPECT_TRUE(says(told("b.toml", "x = [\n CANARY CANARY"), {"b.toml:2"}));
  EXPECT_TRUE(
      says(told("c.toml", "[[robots]]\nname = \"CANARY\"\n", {"robit.level=x"}), {"the scene cannot be built"}));
  EXPECT_TRUE(says(told("d.toml", "[[robots]]\nname = \"robot\"\nmodel = \"CANARY\"\n"), {"d.toml:1"}));
  write("run/bad.xml", "<mujoco>\n<CANARY/></mujoco>");
  EXPECT_TRUE(says(told("e.toml", "[[robots]]\nname = \"robot\"\nmodel = \"./bad.xml\"\n"), {"bad.xml:2"}));
  const std::string wrong = ask(in_run("first.toml"), {"robit.level=full_dynamics"});
  EXPECT_TRUE(says(wrong, {"did you mean 'robot'"})) << "of a scene, what it has may be told";
}

TEST(PlacesIn, OneAfterTheOther) {
  EXPECT_EQ(places_in("/home/me/a.toml:12:3: /home/me/b.xml:7: unknown key 'x'"), "a.toml:12: b.xml:7");
  EXPECT_EQ(places_in("a.toml:12: b:c: d"), "a.toml:12");
  EXPECT_EQ(places_in("a.toml:1:2:3: b"), "");
  EXPECT_EQ(places_in("a.toml:1:"), "");
  EXPECT_EQ(places_in(":1: b"), "");
  EXPECT_EQ(places_in("a.toml:"), "");
  EXPECT_EQ(places_in(std::string(100'000, 'a')), "");
  EXPECT_EQ(places_in("no place: 12"), "");
  EXPECT_EQ(places_in(""), "");
}

}  // namespace
}  // namespace murosimf::scene
