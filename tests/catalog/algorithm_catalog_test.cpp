// What there is by name: every entry says what it is, and every option what it takes.
#include "murosimf/catalog/algorithm_catalog.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::catalog {
namespace {

template <class Entry>
void expect_told(const Registry<Entry>& registry) {
  std::set<std::string_view> names;
  for (const Entry& entry : registry) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.meaning.empty()) << entry.name;
  }
  EXPECT_FALSE(names.empty());
}

TEST(AlgorithmCatalog, EveryEntryHasANameAndAMeaning) {
  expect_told(levels());
  expect_told(contacts());
  expect_told(body_contacts());
  expect_told(controllers());
  expect_told(component_files::sensor_types());
  expect_told(robot::robot_formats());
}

/// Each has a name of its own and a meaning; the default is allowed, if one is said. How many there are.
template <class Entry>
int expect_options_told(const Registry<Entry>& registry) {
  int options = 0;
  for (const Entry& entry : registry) {
    std::set<std::string_view> names;
    for (const OptionInfo& option : entry.options) {
      EXPECT_TRUE(names.insert(option.name).second) << entry.name << ": " << option.name;
      EXPECT_FALSE(option.meaning.empty()) << entry.name << ": " << option.name;
      if (default_text(option) != "-" && !default_text(option).empty()) {
        EXPECT_EQ(fixtures::error_of([&] { check_option(option, option.fallback); }), "no error") << entry.name;
      }
      ++options;
    }
  }
  return options;
}

TEST(AlgorithmCatalog, OptionsAreToldAndTheirDefaultsAllowed) {
  EXPECT_GT(expect_options_told(controllers()), 20);
  EXPECT_EQ(expect_options_told(levels()), 2 + 2 + 3 + 1);
  EXPECT_EQ(expect_options_told(contacts()), 4 + 4);
  EXPECT_EQ(expect_options_told(body_contacts()), 1 + 4 + 4);
  EXPECT_GT(expect_options_told(component_files::sensor_types()), 60);
}

// What only another law has is no error of this one: a scene changes its laws and keeps their options.
TEST(AlgorithmCatalog, LawsTakeTheirOwnOptions) {
  EXPECT_EQ(fixtures::error_of([] { (void)make_contact_law("implicit_stick", {{"rebound", 0.5}}); }), "no error");
  EXPECT_EQ(fixtures::error_of([] {
              (void)make_contact_law("paper", {{"rebound", 1.5}});
            }),
            "'rebound' is 1.5; it must be in the range 0 to 1");
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)make_contact_law("papr"); }), {"did you mean 'paper'?"}));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] {
                               (void)make_body_contact_law("island_gauss_seidel", {{"sweeps", 0.5}});
                             }),
                             {"'sweeps' is 0.5; it must be a whole number in the range 1 to 1000"}));
}

// Attaching without a scene takes the same options, and refuses the same.
TEST(AlgorithmCatalog, AttachingChecksOptions) {
  ControllerOptions options;
  options.own = {{"sped", 1.0}};
  EXPECT_EQ(fixtures::error_of([&] {
              test::Rig rig;
              controllers().find("drive").attach(rig.simulation, rig.add("robot", test::kid21()), options);
            }),
            "unknown option of this algorithm, 'sped'; known: acceleration, steering");
}

TEST(AlgorithmCatalog, RegistriesAreThoseThatAreRead) {
  EXPECT_EQ(&registries().levels, &levels());
  EXPECT_EQ(&registries().controllers, &controllers());
  EXPECT_EQ(&registries().sensors, &component_files::sensor_types());
}

}  // namespace
}  // namespace murosimf::catalog
