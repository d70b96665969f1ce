#include "murosimf/catalog/property_catalog.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

// Rule: the catalogue has every property once, constant ones first, each with unit, frame and meaning.
TEST(PropertyCatalog, HasEveryPropertyOnce) {
  std::set<std::string_view> names;
  bool variable_seen = false;
  for (const properties::CatalogEntry& entry : properties::catalog()) {
    EXPECT_TRUE(names.insert(entry.info.name).second) << entry.info.name;
    EXPECT_FALSE(entry.info.unit.empty() || entry.info.frame.empty() || entry.info.meaning.empty()) << entry.info.name;
    EXPECT_FALSE(entry.constant && variable_seen) << entry.info.name;
    variable_seen = variable_seen || !entry.constant;
  }
  // one of each folder's list
  for (const auto known :
       {"mass", "visuals", "position", "external_damping", "total_mass", "walk_command", "pose_estimate"})
    EXPECT_TRUE(names.contains(known)) << known;
}

}  // namespace
}  // namespace murosimf
