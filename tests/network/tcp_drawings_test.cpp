// Drawings over TCP are kept as they were sent; invalid ones are left out without further effects.
#include <gtest/gtest.h>

#include "murosimf/world/drawing.h"
#include "tests/network/tcp_fixture.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

TEST(TcpDrawings, StandThereAsTheyWereSent) {
  const Listener listener;
  Software painter([&] {
    client::RobotClient robot({.robot = "walker", .port = listener.port(), .rate = 10});
    while (robot.next()) {
      if (robot.starts()) continue;
      robot.draw(
          "way",
          {{.kind = client::Shape::line, .points = {0, 0, 0, 1, 2, 3}, .size = 0.02, .color = {1, 0, 0.5, 0.25}}});
      robot.draw("me", {{.kind = client::Shape::text, .points = {0, 0, 0.5}, .size = 0.1, .words = "here"}}, true);
      robot.draw("nonsense", {{.kind = client::Shape::circle, .points = {0, 0}}});
    }
  });
  {
    scene::Scene scene("walk", {.overrides = {"walker.controller=tcp"}, .cameras = false, .software = listener.server});
    scene.simulation().run(250ms);
    const Drawings& all = scene.simulation().world().entity("walker").find(properties::drawings)->values[0];
    ASSERT_EQ(all.groups.size(), 2U);
    EXPECT_EQ(all.groups[0].name, "me");
    EXPECT_TRUE(all.groups[0].of_robot);
    EXPECT_EQ(all.groups[0].shapes[0].kind, DrawnShape::text);
    EXPECT_EQ(all.groups[0].shapes[0].words, "here");
    EXPECT_EQ(all.groups[1].time, 200ms);
    const DrawnShape& line = all.groups[1].shapes[0];
    EXPECT_EQ(line.kind, DrawnShape::line);
    ASSERT_EQ(line.points.size(), 2U);
    EXPECT_EQ(line.points[1].z, 3);
    EXPECT_EQ(line.color, (Color{1, 0, 0.5}));
    EXPECT_EQ(line.opacity, 0.25);
    EXPECT_EQ(line.size, 0.02);
  }
  EXPECT_EQ(painter.error(), "");
}

}  // namespace
}  // namespace murosimf::control_software
