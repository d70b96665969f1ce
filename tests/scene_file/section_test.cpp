// Sections of a scene file as tables: what is read, what is refused, what people are told.
#include "murosimf/scene_file/section.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/scene_file/all_sections.h"

namespace murosimf::scene_file {
namespace {

struct Lamp {
  std::string name = "spot";
  std::string kind = "led";
  double power = 7.5;
  double turned = pi / 4;
  bool on = true;
  std::uint64_t count = 3;
  Vec3d place{1, 2, -3};
  std::optional<double> warmth;
  std::optional<Vec3d> toward;
  int read_by_function = 0;
};

void read_plug(const files::TomlTable& table, std::string_view key, Lamp& lamp) {
  double plug = 0;
  table.read(key, plug);
  lamp.read_by_function = static_cast<int>(plug) + 1;
}

const Section<Lamp>& lamp_section() {
  static const Section<Lamp> section("[lamp]",
                                     {{"name", &Lamp::name, "", "what it is called"},
                                      {"kind",
                                       Choice<Lamp>{&Lamp::kind, "kind of lamp",
                                                    [] {
                                                      return std::vector<std::string_view>{"led", "gas"};
                                                    }},
                                       "", "how it makes light"},
                                      {"power", &Lamp::power, "W", "what it takes", between(2, 90)},
                                      {"turned_deg", Angle<Lamp>{&Lamp::turned}, "deg", "about its stand",
                                       between(-180, 180)},
                                      {"on", &Lamp::on, "", "whether it shines"},
                                      {"count", &Lamp::count, "", "of bulbs"},
                                      {"place", &Lamp::place, "m", "where it stands", up_to(50)},
                                      {"warmth", &Lamp::warmth, "K", "of its color", positive, "that of the sun"},
                                      {"toward", &Lamp::toward, "", "where it looks"},
                                      {"plug", read_plug, "", "which one", {}, "the nearest"},
                                      {"diagnostic", {}, "", "read elsewhere"}});
  return section;
}

Lamp lamp_of(const std::string& text) {
  const toml::table table = toml::parse(text, std::string("lamp.toml"));
  Lamp lamp;
  lamp_section().read(table, lamp);
  return lamp;
}

std::string refusal_of(const std::string& text) {
  try {
    (void)lamp_of(text);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(Section, ReadsEveryKindOfValueIntoItsPlace) {
  const Lamp lamp = lamp_of(R"(
name = "desk"
kind = "gas"
power = 12
turned_deg = -90
on = false
count = 9007199254740993
place = [4, -5, 6]
warmth = 2700
toward = [0, 0.5, -1]
plug = 4
diagnostic = 7
)");
  EXPECT_EQ(lamp.name, "desk");
  EXPECT_EQ(lamp.kind, "gas");
  EXPECT_EQ(lamp.power, 12);
  EXPECT_DOUBLE_EQ(lamp.turned, -pi / 2);
  EXPECT_FALSE(lamp.on);
  EXPECT_EQ(lamp.count, 9007199254740993U);
  EXPECT_EQ(norm(lamp.place - Vec3d{4, -5, 6}), 0);
  EXPECT_EQ(lamp.warmth, 2700);
  ASSERT_TRUE(lamp.toward);
  EXPECT_EQ(norm(*lamp.toward - Vec3d{0, 0.5, -1}), 0);
  EXPECT_EQ(lamp.read_by_function, 5);
}

TEST(Section, LeavesAloneWhatIsNotThere) {
  const Lamp lamp = lamp_of("power = 12");
  EXPECT_EQ(lamp.name, "spot");
  EXPECT_DOUBLE_EQ(lamp.turned, pi / 4);
  EXPECT_EQ(lamp.warmth, std::nullopt);
  EXPECT_EQ(lamp.read_by_function, 0);
}

TEST(Section, RefusesWithThePlaceOfTheKey) {
  EXPECT_EQ(refusal_of("powr = 3"), "lamp.toml:1:1: unknown key 'powr'; did you mean 'power'?");
  EXPECT_EQ(refusal_of("kind = 'ledd'"), "lamp.toml:1:8: unknown kind of lamp 'ledd'; did you mean 'led'?");
  EXPECT_EQ(refusal_of("name = ''"), "lamp.toml:1:8: 'name' is empty: leave it out, or name something");
  EXPECT_EQ(refusal_of("\npower = 'much'"), "lamp.toml:2:9: 'power' must be a finite number");
}

TEST(Section, KeepsNumbersWithinTheirBounds) {
  EXPECT_EQ(refusal_of("power = 2"), "");
  EXPECT_EQ(refusal_of("power = 90"), "");
  EXPECT_EQ(refusal_of("power = 1.9"), "lamp.toml:1:9: 'power' must be from 2 to 90 W");
  EXPECT_EQ(refusal_of("power = 90.1"), "lamp.toml:1:9: 'power' must be from 2 to 90 W");
  EXPECT_EQ(refusal_of("turned_deg = 181"), "lamp.toml:1:14: 'turned_deg' must be from -180 to 180");
  EXPECT_EQ(refusal_of("warmth = 0"), "lamp.toml:1:10: 'warmth' must be positive");
  EXPECT_EQ(refusal_of("place = [30, 40, 0]"), "");
  EXPECT_EQ(refusal_of("place = [30, 40, 1]"), "lamp.toml:1:9: 'place' is more than 50 m");
}

TEST(Section, TellsDefaultsAsAFileWouldHaveThem) {
  const SectionInfo info = lamp_section().info();
  EXPECT_EQ(info.header, "[lamp]");
  const std::vector<std::string> wanted{
      "spot", "led", "7.5", "45", "true", "3", "[1, 2, -3]", "that of the sun", "", "the nearest", ""};
  ASSERT_EQ(info.keys.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(info.keys[i].fallback, wanted[i]) << info.keys[i].name;
}

TEST(KeyList, FindsSectionsByTheirKeyInTheFile) {
  for (const std::string_view name : {"", "start", "views", "robots", "defaults", "bodies", "materials"}) {
    ASSERT_NE(find_section(name), nullptr) << name;
  }
  EXPECT_EQ(find_section("robot"), nullptr);
  EXPECT_EQ(find_section("views")->header, "[views.NAME]");
}

TEST(KeyList, NamesEverySectionThatAFileMayHave) {
  for (const std::string_view key : scene_section().names()) {
    const bool is_section = find_section(key) != nullptr;
    if (!is_section) {
      EXPECT_TRUE(key == "name" || key == "duration" || key == "seed" || key == "rate" || key == "gravity" ||
                  key == "body_contact" || key == "body_contact_options")
          << key;
    }
  }
}

TEST(KeyList, EveryKeyHasAMeaning) {
  for (const SectionInfo& section : sections()) {
    for (const KeyInfo& key : section.keys) EXPECT_FALSE(key.meaning.empty()) << section.header << " " << key.name;
  }
}

}  // namespace
}  // namespace murosimf::scene_file
