// Which shapes have the same surface: shapes of any objects, or of one object each.
#include "murosimf/collision/surface_kinds.h"

#include <gtest/gtest.h>

namespace murosimf::collision {
namespace {

CollidingShape shape(int object, const Surface& surface) {
  CollidingShape made;
  made.object = object;
  made.placed.surface = surface;
  return made;
}

const Surface rubber{"rubber", 0.8}, felt{"felt", 0.8}, smooth_felt{"felt", 0.3};

const std::vector<CollidingShape>& shapes() {
  static const std::vector<CollidingShape> all{shape(0, felt), shape(2, rubber),      shape(2, felt),
                                               shape(2, felt), shape(5, smooth_felt), shape(7, rubber)};
  return all;
}

std::vector<std::size_t> kinds_of(const SurfaceKinds& kinds) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < shapes().size(); ++i) found.push_back(kinds.of(i));
  return found;
}

TEST(SurfaceKinds, OfAModelAreMaterialAndFriction) {
  const SurfaceKinds kinds(shapes(), SurfaceKinds::Of::model);
  EXPECT_EQ(kinds_of(kinds), (std::vector<std::size_t>{0, 1, 0, 0, 2, 1}));
  ASSERT_EQ(kinds.surfaces().size(), 3U);
  EXPECT_EQ(kinds.surfaces()[1].material, "rubber");
  EXPECT_EQ(kinds.surfaces()[2].friction, 0.3);
  EXPECT_EQ(kinds.objects(), (std::vector<int>{0, 2, 5}));
}

TEST(SurfaceKinds, OfObjectsAreToldApartByThem) {
  const SurfaceKinds kinds(shapes(), SurfaceKinds::Of::object);
  EXPECT_EQ(kinds_of(kinds), (std::vector<std::size_t>{0, 1, 2, 2, 3, 4}));
  EXPECT_EQ(kinds.objects(), (std::vector<int>{0, 2, 2, 5, 7}));
}

TEST(SurfaceKinds, OfNothingThereAreNone) { EXPECT_TRUE(SurfaceKinds({}, SurfaceKinds::Of::model).surfaces().empty()); }

}  // namespace
}  // namespace murosimf::collision
