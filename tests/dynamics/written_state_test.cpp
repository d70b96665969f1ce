// Changes of a level's columns by any means: the next step continues from them.
#include "murosimf/dynamics/written_state.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {
namespace {

Chain arm() {
  return Chain{}.base("base").with(properties::mass, 2.0).revolute("joint", {1, 0, 0}).with(properties::mass, 0.7);
}

struct Written : testing::Test {
  Written()
      : entity(world.add("robot", std::make_shared<const Model>("robot", arm()))),
        setup(world, entity, access),
        columns(setup) {
    columns.r[0] = {1, -2, 3};
    columns.v[0] = {0.1, 0.2, -0.3};
    columns.w[0] = {4, 5, -6};
    columns.Q[0] = {1, 0, 0, 0};
    for (std::size_t i = 0; i < columns.q.size(); ++i) columns.q[i] = columns.qd[i] = 0.25;
  }
  World world;
  Entity& entity;
  AccessSet access;
  murosimf::Setup setup;
  PoseColumns columns;
};

TEST_F(Written, NothingIsKnownAtFirst) { EXPECT_TRUE(WrittenState(columns).differs(columns)); }

TEST_F(Written, SeesEveryNumberThatIsState) {
  WrittenState written(columns);
  const std::size_t last = columns.q.size() - 1;
  for (double* number : {&columns.r[0].x, &columns.r[0].z, &columns.v[0].y, &columns.w[0].z, &columns.Q[0].w,
                         &columns.q[0], &columns.q[last], &columns.qd[0], &columns.qd[last]}) {
    written.remember(columns);
    EXPECT_FALSE(written.differs(columns));
    const double before = *number;
    *number = std::nextafter(before, 1e9);
    EXPECT_TRUE(written.differs(columns));
    *number = before;
    EXPECT_FALSE(written.differs(columns));
  }
}

TEST_F(Written, PosesOfOtherObjectsFollowAndAreNoState) {
  WrittenState written(columns);
  written.remember(columns);
  columns.r[1] = {7, 8, 9};
  EXPECT_FALSE(written.differs(columns));
}

TEST_F(Written, NotANumberIsNoChangeForEver) {
  WrittenState written(columns);
  columns.q[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(written.differs(columns));
  written.remember(columns);
  EXPECT_FALSE(written.differs(columns));
}

TEST_F(Written, CanBeForgotten) {
  WrittenState written(columns);
  written.remember(columns);
  written.forget();
  EXPECT_TRUE(written.differs(columns));
}

}  // namespace
}  // namespace murosimf::dynamics
