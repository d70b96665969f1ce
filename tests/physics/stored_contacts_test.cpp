// Contact points are data: bytes that have been away come back as the same contacts.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

using collision::ContactPoint;

/// As they would stand in a file.
std::string bytes_of(const std::vector<ContactPoint>& points) {
  std::string bytes(points.size() * sizeof(ContactPoint), '\0');
  if (!points.empty()) std::memcpy(bytes.data(), points.data(), bytes.size());
  return bytes;
}

std::vector<ContactPoint> points_of(const std::string& bytes) {
  std::vector<ContactPoint> points(bytes.size() / sizeof(ContactPoint));
  if (!points.empty()) std::memcpy(points.data(), bytes.data(), bytes.size());
  return points;
}

// Rule: a run in which the points of contact were stored and read back between two steps goes on as if they had not
// been. The box slides, so the law's memory decides about its way: without the points the hash is another one.
TEST(StoredContacts, GoOnAsBefore) {
  const auto run = [](auto&& between) {
    Rig rig(0.3, 0.5);
    Entity& box = rig.add("box", box_model(0.3));
    rig.attach_dynamics(box);
    rig.run(0.2);
    auto& points = box.column(collision::contacts).values[0].points;
    EXPECT_GT(points.size(), 0u);
    between(points);
    rig.run(0.2);
    return rig.simulation.state_hash();
  };
  const auto untouched = run([](auto&) {});
  EXPECT_EQ(run([](auto& points) {
              const std::string stored = bytes_of(points);
              points.clear();
              points = points_of(stored);
            }),
            untouched);
  EXPECT_NE(run([](auto& points) { points.clear(); }), untouched);
}

}  // namespace
}  // namespace murosimf::test
