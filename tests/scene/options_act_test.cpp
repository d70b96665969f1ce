// Every option of a controller, level or law acts, and its default is what happens without it.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
namespace {

struct Play {
  std::string scene;
  double duration;  ///< [s]
  std::vector<std::string> set = {};
};

/// The hash of the state after each tenth of the play, with these options.
struct Course {
  static constexpr int parts = 10;

  Course(const Play& play, const std::vector<std::string>& more)
      : scene(play.scene, options_of(play, more)), part(from_seconds(play.duration / parts)) {}

  static SceneOptions options_of(const Play& play, const std::vector<std::string>& more) {
    SceneOptions options{.overrides = play.set, .cameras = false};
    options.overrides.insert(options.overrides.end(), more.begin(), more.end());
    return options;
  }
  std::uint64_t next() {
    scene.simulation().run(part);
    return scene.simulation().world().state_hash();
  }

  Scene scene;
  Duration part;
};

using Hashes = std::array<std::uint64_t, Course::parts>;

Hashes hashes_of(const Play& play, const std::vector<std::string>& options) {
  Course course(play, options);
  Hashes hashes;
  for (std::uint64_t& hash : hashes) hash = course.next();
  return hashes;
}

/// As soon as it does, nothing more is looked at.
bool differs(const Play& play, const std::string& option, const Hashes& plain) {
  Course course(play, {option});
  return std::ranges::any_of(plain, [&](std::uint64_t hash) { return course.next() != hash; });
}

OptionValue other_than(const OptionValue& usual) {
  if (const bool* truth = std::get_if<bool>(&usual)) return !*truth;
  return 0.7 * std::get<double>(usual);
}

/// `table`: where they stand, "walker.options".
void expect_options_act(const std::vector<OptionInfo>& options, const std::string& table, const Play& play) {
  const Hashes plain = hashes_of(play, {});
  std::vector<std::string> usual;
  for (const OptionInfo& option : options) {
    const std::string path = table + "." + option.name + "=";
    usual.push_back(path + value_text(option.fallback));
    EXPECT_TRUE(differs(play, path + value_text(other_than(option.fallback)), plain)) << path;
  }
  EXPECT_EQ(hashes_of(play, usual), plain) << "all defaults, said";
}

void expect_options_act(const std::string& controller, const std::string& robots, const Play& play) {
  expect_options_act(catalog::controllers().find(controller).options, robots + ".options", play);
}

TEST(ControllerOptions, OfTheBallChaserAct) { expect_options_act("ball_chaser", "*", {"three_on_three", 20}); }

TEST(ControllerOptions, OfDriveAct) {
  expect_options_act("drive", "car", {"car_crash", 1, {"car.command=[1, 0, 0.5]"}});
}

TEST(ControllerOptions, OfBalanceAct) {
  expect_options_act("balance", "robot", {"push", 3, {"robot.controller=balance"}});
}

/// The paper's numbers of all pairs of materials, and others: of the key of a pair, and of the option that comes before it.
struct PaperNumber {
  std::string key, option, usual, other;
};
const PaperNumber paper_numbers[] = {{"rebound", "rebound", "0.4", "0.3"},
                                     {"viscous_friction", "friction", "5", "3.5"},
                                     {"spin_friction", "spin_friction", "0.01", "0.02"}};

/// An option of the law wins over the pair of materials; without it the pair's number counts, whose default is the old option's.
void expect_paper_numbers_act(const std::string& table, const Play& play) {
  const Hashes plain = hashes_of(play, {});
  for (const auto& [key, option, usual, other] : paper_numbers) {
    const std::string of_option = table + "." + option + "=", of_pairs = "materials." + key + "=";
    EXPECT_EQ(hashes_of(play, {of_option + usual}), plain) << option;
    const Hashes changed = hashes_of(play, {of_option + other});
    EXPECT_NE(changed, plain) << option;
    EXPECT_EQ(hashes_of(play, {of_pairs + other}), changed) << key;
    Play both = play;
    both.set.push_back(of_pairs + other);
    EXPECT_EQ(hashes_of(both, {of_option + usual}), plain) << key;
  }
}

TEST(LawOptions, OfThePapersLawsAct) {
  for (const std::string law : {"paper", "paper_multipoint"}) {
    const Play play{"walk", 2, {"walker.level=simplified_dynamics", "walker.contact=" + law}};
    expect_paper_numbers_act("walker.contact_options", play);
    expect_options_act({catalog::contacts().find(law).options.back()}, "walker.contact_options", play);
  }
}

TEST(LawOptions, OfThePapersLawsBetweenBodiesAct) {
  for (const std::string law : {"paper", "paper_multipoint"}) {
    const Play play{"heap", 0.6, {"body_contact=" + law}};
    expect_paper_numbers_act("body_contact_options", play);
    expect_options_act({catalog::body_contacts().find(law).options.back()}, "body_contact_options", play);
  }
}

TEST(LawOptions, OfIslandsAct) {
  const Play play{"heap", 1};
  EXPECT_TRUE(differs(play, "body_contact_options.sweeps=5", hashes_of(play, {})));
  ASSERT_EQ(catalog::body_contacts().find("island_gauss_seidel").options.size(), 1U);
}

// The filter of joint targets, or their linear way, at whatever level; corrections act in flight, which an upward start is.
TEST(LevelOptions, OfJointsAct) {
  for (const std::string level : {"kinematic_walking", "simplified_dynamics", "full_dynamics"}) {
    const std::vector<OptionInfo>& options = catalog::levels().find(level).options;
    expect_options_act({options.at(0)}, "walker.level_options", {"walk", 1, {"walker.level=" + level}});
    expect_options_act({options.at(1)}, "walker.level_options",
                       {"walk", 1, {"walker.level=" + level, "walker.joint_reference=linear"}});
  }
}

TEST(LevelOptions, OfFlightAct) {
  for (const std::string level : {"full_dynamics", "articulated_dynamics"}) {
    const OptionInfo& correction = catalog::levels().find(level).options.back();
    expect_options_act({correction}, "walker.level_options",
                       {"walk", 0.3, {"walker.level=" + level, "walker.position=[0, 0, 1]"}});
  }
}

// A law that comes while the scene runs takes its options too: what it does not have is kept for it.
TEST(LawOptions, ActAlsoOnALawThatComesLater) {
  const auto hash = [](const std::string& friction) {
    Scene scene("walk",
                {.overrides = {"walker.level=simplified_dynamics", "walker.contact_options.friction=" + friction},
                 .events = {"0.5:walker.contact=paper"},
                 .cameras = false});
    scene.simulation().run(from_seconds(1.5));
    return scene.simulation().world().state_hash();
  };
  EXPECT_EQ(hash("5"), hash("5"));
  EXPECT_NE(hash("5"), hash("3"));
}

}  // namespace
}  // namespace murosimf::scene
