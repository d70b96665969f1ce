// Debug builds: a kernel that is given rows of another model ends the program.
#include "murosimf/multibody/span_sizes.h"

#include <vector>

#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/link_motion.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

TEST(SpanSizes, OfATree) {
  const Model model = fixtures::two_legged();
  const std::vector<double> objects(static_cast<std::size_t>(model.size())), links(model.tree().links.size());
  ASSERT_NE(objects.size(), links.size());
  EXPECT_TRUE(one_row_per_object(model.tree(), objects, objects));
  EXPECT_FALSE(one_row_per_object(model.tree(), objects, links));
  EXPECT_TRUE(one_row_per_link(model.tree(), links, links));
  EXPECT_FALSE(one_row_per_link(model.tree(), links, objects));
}

#ifndef NDEBUG
TEST(SpanSizesDeathTest, KernelsRefuseOthers) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Model model = fixtures::two_legged();
  const auto rows = static_cast<std::size_t>(model.size());
  const std::vector<double> q(rows);
  std::vector<Vec3d> r(rows);
  std::vector<Mat3d> R(rows), too_few(rows - 1);
  poses<double>(model.tree(), q, r, R);
  EXPECT_DEATH(poses<double>(model.tree(), q, r, too_few), "one_row_per_object");
  std::vector<LinkMotion<double>> links(model.tree().links.size() - 1);
  EXPECT_DEATH(link_motions<double>(model.tree(), r, R, {}, q, links), "one_row_per_link");
}
#endif

}  // namespace
}  // namespace murosimf::multibody
