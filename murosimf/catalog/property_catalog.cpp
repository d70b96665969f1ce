#include "murosimf/catalog/property_catalog.h"

#include <algorithm>

#include "murosimf/air/air_properties.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/soccer/behavior_properties.h"

namespace murosimf::properties {
namespace {

/// Sorted by name, as `murosimf list` prints it and name search needs it.
std::vector<CatalogEntry> collect() {
  std::vector<CatalogEntry> all;
  for (const auto list : {core_list(), contact_list(), motion_list(), air_list(), gait_list(), behavior_list()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  std::ranges::stable_partition(all, &CatalogEntry::constant);
  return all;
}

}  // namespace

const std::vector<CatalogEntry>& catalog() {
  static const std::vector<CatalogEntry> all = collect();
  return all;
}

}  // namespace murosimf::properties
