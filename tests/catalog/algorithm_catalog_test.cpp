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
  expect_told(components::sensor_types());
}

TEST(AlgorithmCatalog, DefaultsOfOptionsAreAllowed) {
  int options = 0;
  for (const ControllerType& controller : controllers()) {
    std::set<std::string_view> names;
    for (const OptionInfo& option : controller.options) {
      EXPECT_TRUE(names.insert(option.name).second) << controller.name << ": " << option.name;
      EXPECT_EQ(fixtures::error_of([&] { check_option(option, option.fallback); }), "no error") << controller.name;
      EXPECT_FALSE(option.meaning.empty()) << controller.name << ": " << option.name;
      ++options;
    }
  }
  EXPECT_GT(options, 20);
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
  EXPECT_EQ(&registries().sensors, &components::sensor_types());
}

}  // namespace
}  // namespace murosimf::catalog
