// Plug-ins: shared libraries that the program loads while it runs.
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

using namespace nlohmann::literals;

const std::string own_plugin = std::string(" --plugin ") + MUROSIMF_OWN_PLUGIN;

std::string bad_plugin(const std::string& error) { return std::string(MUROSIMF_BAD_PLUGINS) + "/" + error + ".so"; }

/// The walker's place [m] after 10 s with these options.
std::vector<double> place_with(const std::string& options) {
  const Result result = murosimf("run walk --duration 10 --json -" + options);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const auto report = nlohmann::json::parse(result.output, nullptr, false);
  for (const auto& entity : report.is_object() ? report["entities"] : nlohmann::json::array()) {
    if (entity["name"] == "walker") return entity["position"].get<std::vector<double>>();
  }
  ADD_FAILURE() << result.output;
  return {0, 0, 0};
}

TEST(Plugin, IsListed) {
  EXPECT_EQ(murosimf("list controllers").output.find("circle"), std::string::npos);
  EXPECT_NE(murosimf("list controllers" + own_plugin).output.find("circle "), std::string::npos);
  EXPECT_NE(murosimf("list contacts" + own_plugin).output.find("ice "), std::string::npos);
  EXPECT_NE(murosimf("list options" + own_plugin).output.find("radius"), std::string::npos);
}

// A circle of radius 0.3 m at 0.1 m/s: after 10 s, half of it and a bit, the walker is beside its start (-2, 0), not in front.
TEST(Plugin, ControllerMovesARobotAsItsOptionsSay) {
  const std::string circle = own_plugin + " --set walker.controller=circle --set walker.options.radius=0.3";
  const auto left = place_with(circle), right = place_with(circle + " --set walker.options.clockwise=true");
  EXPECT_GT(left[1], 0.3);
  EXPECT_LT(right[1], -0.3);
  EXPECT_LT(std::hypot(left[0] + 2, left[1]), 0.7) << "the diameter of the circle, and what walking adds";
}

// Without friction feet push nothing forward.
TEST(Plugin, ContactLawActs) {
  const std::string rigid = " --set walker.level=simplified_dynamics";
  EXPECT_GT(place_with(rigid)[0], -1);
  EXPECT_LT(place_with(rigid + own_plugin + " --set walker.contact=ice")[0], -1.7);
}

// kid21's base is 0.3 m or so above its soles.
TEST(Plugin, SensorMeasures) {
  const Result result =
      murosimf("run walk --duration 0.1 --json - --set walker.sensors.height.type=altimeter" + own_plugin);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const auto report = nlohmann::json::parse(result.output, nullptr, false);
  const double height = report.value("/sensors/walker/height/outputs/height/values/0"_json_pointer, 0.0);
  EXPECT_NEAR(height, 0.3, 0.1) << result.output;
}

TEST(Plugin, SensorOfARobotsFileIsKnown) {
  write("robot.toml", "[sensors.height]\ntype = \"altimeter\"\n");
  const fs::path robot = scratch("robot.xml");  // beside it, with the same name
  fs::copy_file(fs::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml", robot);
  expect_mistake("check " + robot.string(), {"robot.toml:2:8", "unknown sensor type 'altimeter'"}, 1);
  const Result known = murosimf("check " + robot.string() + own_plugin);
  EXPECT_NE(known.output.find("altimeter"), std::string::npos) << known.output << known.errors;
}

// A ball of 2.5 kg in a scene: the format is known with the plug-in only, and the robot falls onto its radius.
TEST(Plugin, FormatIsRead) {
  const fs::path ball = write("ball.lump", "0.2 2.5\n");
  const fs::path scene = write("scene.toml", "[[robots]]\nname = \"lump\"\nmodel = \"" + ball.string() +
                                                 "\"\ncontroller = \"none\"\nlevel = \"simplified_dynamics\"\n");
  expect_mistake("run " + scene.string() + " --duration 0.1", {"ball.lump", "known: mjcf (<mujoco>), urdf (<robot>)"});
  const Result result = murosimf("run " + scene.string() + " --duration 0.5 --json -" + own_plugin);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  const auto report = nlohmann::json::parse(result.output, nullptr, false);
  EXPECT_NEAR(report.value("/entities/0/position/2"_json_pointer, 0.0), 0.2, 0.01) << result.output;
}

TEST(Plugin, FormatIsListed) {
  EXPECT_EQ(murosimf("list formats").output.find(".lump"), std::string::npos);
  EXPECT_NE(murosimf("list formats" + own_plugin).output.find("lump       .lump"), std::string::npos);
  const fs::path other = write("robot.xml", "<collada/>");
  expect_mistake("check " + other.string() + own_plugin,
                 {"unknown format of a robot file", "mjcf (<mujoco>), urdf (<robot>), sdf (<sdf>)", "lump (.lump)"}, 1);
}

TEST(Plugin, FormatsMistakeIsOneLine) {
  expect_mistake("check " + write("ball.lump", "heavy\n").string() + own_plugin, {"ball.lump: two numbers"}, 1);
}

// A ball of 2.5 kg on the earth and on the moon.
TEST(Plugin, CommandRuns) {
  const std::string weigh = own_plugin.substr(1) + " weigh " + write("ball.lump", "0.2 2.5\n").string();
  EXPECT_EQ(murosimf(weigh).output, "24.525 N\n");
  EXPECT_EQ(murosimf(weigh + " --gravity 2").output, "5 N\n");
}

TEST(Plugin, CommandIsListedWithTheOthers) {
  const std::string plugin = own_plugin.substr(1);
  for (const std::string words : {"--help", "list commands", "man", "completion bash"}) {
    EXPECT_EQ(murosimf(words).output.find("weigh"), std::string::npos) << words;
    EXPECT_NE(murosimf(plugin + " " + words).output.find("weigh"), std::string::npos) << words;
  }
  EXPECT_NE(murosimf(plugin + " weigh --help").output.find("where it stands [m/s^2], 0 to 1000; default: 9.81"),
            std::string::npos);
}

TEST(Plugin, CommandsMistakesAreOneLine) {
  const std::string plugin = own_plugin.substr(1);
  expect_mistake("weigh kid21", {"unknown command 'weigh'"});
  expect_mistake(plugin + " wiegh kid21", {"unknown command 'wiegh'; did you mean 'weigh'?"});
  expect_mistake(plugin + " weigh kid21 --gravity 2000", {"--gravity: 'gravity' is 2000", "0 to 1000 m/s^2"});
  expect_mistake(plugin + " weigh kid21 --gravty 2", {"--gravty"});
  expect_mistake(plugin + " weigh", {"model is required"});
  expect_mistake("--plugin " + bad_plugin("taken_command") + " list levels", {"there is a command 'run' already"});
  expect_mistake("--plugin /nowhere/own.so list levels", {"--plugin: /nowhere/own.so: No such file"});
}

TEST(Plugin, LoadedTwiceIsLoadedOnce) {
  EXPECT_EQ(murosimf("list controllers" + own_plugin + own_plugin).exit_code, 0);
}

TEST(Plugin, OptionsAreChecked) {
  const std::string circle =
      "run walk --duration 1" + own_plugin + " --set walker.controller=circle --set walker.options.";
  expect_mistake(circle + "radus=1",
                 {"--set 'walker.options.radus=1'", "controller 'circle'", "did you mean 'radius'?"});
  expect_mistake(circle + "radius=0", {"'radius' is 0", "0.2 to 100 m"});
  expect_mistake(circle + "clockwise=3", {"'clockwise' must be true or false"});
}

TEST(Plugin, MistakesAreOneLine) {
  const auto refused = [](const std::string& file, const std::vector<std::string>& parts) {
    expect_mistake("run walk --duration 1 --plugin " + file, parts);
  };
  refused("/nowhere/own.so", {"--plugin: /nowhere/own.so: No such file"});
  refused("/tmp", {"/tmp: is no file"});
  refused(write("text.so", "no library").string(), {"cannot be loaded"});
  refused(bad_plugin("no_version"), {"no_version.so: this is no plug-in", "murosimf_plugin_version"});
  refused(bad_plugin("no_entry"), {"this is no plug-in", "murosimf_register"});
  refused(bad_plugin("other_version"), {"made for 'plug-in interface 0 of murosimf 0.0.9, C++ ABI 1'",
                                        "this program is 'plug-in interface 1 of murosimf", "build it anew"});
  refused(bad_plugin("unknown_symbol"), {"cannot be loaded", "nobody_has_defined_this"});
  refused(bad_plugin("throws"), {"throws.so: the license has expired"});
  refused(bad_plugin("throws_a_number"), {"no std::exception"});
  refused(bad_plugin("taken_name"), {"there is a controller 'walk' already"});
}

// As control software (control_library_test.cpp).
TEST(Plugin, ThatCrashesOrEndsTheProgramIsNamed) {
  expect_mistake("run walk --duration 1 --plugin " + bad_plugin("crashes_when_loaded"),
                 {"plug-in '", "crashes_when_loaded.so': its loading crashed (SIGSEGV); the run ends here"}, 3);
  expect_mistake("run walk --duration 1 --plugin " + bad_plugin("exits"),
                 {"exits.so': its murosimf_register called exit(0); the run ends here"}, 3);
}

TEST(Plugin, WhoseAlgorithmCrashesEndsTheRunWithItsReport) {
  const Result result =
      murosimf("run walk --duration 5 --set walker.controller=bad --plugin " + bad_plugin("crashes_in_a_step"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("crashes_in_a_step.so': bad of walker crashed (SIGSEGV); the run ends here"),
            std::string::npos)
      << result.errors;
  EXPECT_NE(result.output.find("stopped by a crash at 1.0"), std::string::npos) << result.output;
}

TEST(Plugin, DoesNotChangeHowOthersRound) {
  const auto hash = [](const std::string& plugin, int threads) {
    const Result result =
        murosimf("run three_on_three --duration 2 --threads " + std::to_string(threads) +
                 " --set blue1.controller=bad --set 'red*.level=simplified_dynamics' --plugin " + bad_plugin(plugin));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return state_hash_in(result.output);
  };
  const std::string as_it_should_be = hash("none", 1);
  for (const int threads : {1, 2, 3}) EXPECT_EQ(hash("rounds", threads), as_it_should_be) << threads;
}

TEST(Plugin, IsForTheCommandLineAlone) {
  const fs::path scene = write("scene.toml", "plugins = [\"own.so\"]\n");
  expect_mistake("run " + scene.string(), {"scene.toml:1:1", "unknown key 'plugins'"});
}

}  // namespace
}  // namespace murosimf::test
