#include "murosimf/dataset/arrangement.h"

#include <cmath>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>

#include "murosimf/dataset/random_camera.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

constexpr double upright = 0.8;  // [1] cosine of a base's tilt

std::string robot(const std::string& name, const std::string& more) {
  return "[[robots]]\nname = '" + name + "'\nmodel = 'kid21'\nlevel = 'simplified_dynamics'\ncontroller = 'none'\n" +
         more;
}

class Arranging : public testing::Test {
 protected:
  Arranging() {
    ranges_.robots.recorded = 0;
    ranges_.robots.present = 1;
  }
  void build(const std::string& scene) {
    const auto file = folder_.path() / "scene.toml";
    std::ofstream(file) << scene;
    stage_ = std::make_unique<Stage>(file, scene::SceneOptions{}, ranges_);
  }
  [[nodiscard]] Arrangement arranged(std::uint64_t number) const {
    return arrange(*stage_, ranges_, imaging::Lens(random_lenses(ranges_.lens, 64, 48, 1)[0]), 1, number);
  }
  static Vec3d place(const Arrangement& in, const Actor& of) { return in.frame.position[in.frame.first[of.place]]; }
  static bool lies(const Arrangement& in, const Actor& robot) {
    return in.frame.orientation[in.frame.first[robot.place]].z.z < upright;
  }
  void expect_apart(const Arrangement& in, const Actor& a, const Actor& b) const {
    if (a.role == Actor::Role::body && b.role == Actor::Role::body) return;
    const Vec3d way = place(in, a) - place(in, b);
    EXPECT_GE(std::hypot(way.x, way.y), in.reach[a.place] + in.reach[b.place] - 1e-9)
        << a.entity->name() << " and " << b.entity->name();
  }

  fixtures::TempFolder folder_;
  Randomisation ranges_;
  std::unique_ptr<Stage> stage_;
};

TEST_F(Arranging, PresentActorsDoNotOverlap) {
  ranges_.people = {.count = 5, .present = 1, .on_field = 0.6, .in_view = 0.6, .things = 5, .thing_present = 1};
  build("[ball]\n" + robot("standing", "position = [-1, 0]\n") + robot("other", "position = [1, 1]\n") +
        robot("lying", "position = [1, -1]\npitch_deg = -90\n") +
        "[[bodies]]\nname = 'crate'\nshape = 'box'\nsize = [0.8, 0.4, 0.3]\nmass = 2\nposition = [0.5, 0]\n"
        "[[bodies]]\nname = 'wall'\nshape = 'box'\nsize = [2, 0.1, 0.5]\nheading_deg = 30\nstatic = true\nposition = "
        "[-1, 1]\n");
  ASSERT_EQ(stage_->standing().size(), 1U);
  std::size_t compared = 0;
  for (std::uint64_t number = 0; number < 100; ++number) {
    const Arrangement in = arranged(number);
    std::vector<const Actor*> present;
    for (const Actor& actor : stage_->actors()) {
      if (in.frame.present[actor.place]) present.push_back(&actor);
    }
    for (std::size_t i = 0; i < present.size(); ++i) {
      EXPECT_GT(in.reach[present[i]->place], 0) << present[i]->entity->name();
      for (std::size_t k = 0; k < i; ++k, ++compared) expect_apart(in, *present[i], *present[k]);
      if (present[i]->role == Actor::Role::body) continue;
      EXPECT_GE(stage_->standing()[0].distance(place(in, *present[i])), in.reach[present[i]->place] - 1e-9);
    }
  }
  EXPECT_GT(compared, 3000U);
}

// Lying takes more of the ground than standing.
TEST_F(Arranging, ReachFollowsFromThePosture) {
  ranges_.camera.of_robot = 0;
  build(robot("standing", "position = [-1, 0]\n") + robot("lying", "position = [1, 0]\npitch_deg = -90\n"));
  const Postures& known = *stage_->actors()[0].postures;
  ASSERT_EQ(known[static_cast<std::size_t>(Doing::standing)].size(), 1U);
  ASSERT_EQ(known[static_cast<std::size_t>(Doing::down)].size(), 1U);
  EXPECT_GT(known[static_cast<std::size_t>(Doing::down)][0].reach,
            known[static_cast<std::size_t>(Doing::standing)][0].reach + 0.05);
}

TEST_F(Arranging, TheRobotWhoseCameraLooksDoesNotLie) {
  ranges_.camera.of_robot = 1;
  ranges_.robots.standing = ranges_.robots.moving = 0;
  ranges_.robots.down = 1;
  build(robot("one", "position = [-1, 0]\n") + robot("two", "position = [1, 0]\npitch_deg = -90\n"));
  for (std::uint64_t number = 0; number < 20; ++number) {
    const Arrangement in = arranged(number);
    ASSERT_FALSE(in.camera.empty());
    for (const Actor& actor : stage_->actors()) {
      if (!in.frame.present[actor.place]) continue;
      EXPECT_EQ(lies(in, actor), !in.camera.starts_with(actor.entity->name() + "."));
    }
  }
}

TEST_F(Arranging, WithoutAPostureOnItsFeetItsCameraDoesNotLook) {
  ranges_.camera.of_robot = 1;
  build(robot("one", "pitch_deg = -90\n"));
  for (std::uint64_t number = 0; number < 20; ++number) {
    const Arrangement in = arranged(number);
    EXPECT_EQ(in.camera, "");
    const Actor& actor = stage_->actors()[0];
    EXPECT_TRUE(in.frame.present[actor.place] && lies(in, actor));
  }
}

// Weights of postures that were not recorded do not count: the robot stands, though it should move.
TEST_F(Arranging, WeightsOfWhatIsNotThereAreZero) {
  ranges_.camera.of_robot = 0;
  ranges_.robots.standing = ranges_.robots.down = 0;
  ranges_.robots.moving = 1;
  build(robot("one", ""));
  const Arrangement in = arranged(0);
  EXPECT_TRUE(in.frame.present[stage_->actors()[0].place]);
  EXPECT_FALSE(lies(in, stage_->actors()[0]));
}

}  // namespace
}  // namespace murosimf::dataset
