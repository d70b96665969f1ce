#include "murosimf/dataset/stage.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/files/child_process.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

constexpr const char* inertial = "<inertial pos='0 0 0' mass='1' diaginertia='0.01 0.01 0.01'/>";

std::string arm(const std::string& joint) {
  return "<body name='" + joint + "_link' pos='0 0 0.1'><joint name='" + joint + "' type='hinge' axis='0 1 0'/>" +
         inertial + "<geom type='sphere' size='0.05'/></body>";
}

class StageOfRobots : public testing::Test {
 protected:
  /// A robot of the model "twin" with these joints; adds it to the scene.
  void add_twin(const std::string& name, const std::vector<std::string>& joints) {
    std::string text = std::string("<mujoco model='twin'><worldbody><body name='trunk'><freejoint/>") + inertial +
                       "<geom type='box' size='0.1 0.1 0.05'/>";
    for (const std::string& joint : joints) text += arm(joint);
    const auto file = folder_.path() / (name + ".xml");
    std::ofstream(file) << text << "</body></worldbody></mujoco>";
    add_robot(name, file, "");
  }
  void add_robot(const std::string& name, const std::filesystem::path& model, const std::string& more) {
    scene_ += "[[robots]]\nname = '" + name + "'\nmodel = '" + model.string() +
              "'\nlevel = 'simplified_dynamics'\ncontroller = 'none'\nposition = [" + std::to_string(count_++) +
              ", 0]\n" + more;
  }
  [[nodiscard]] Stage stage() const {
    Randomisation ranges;
    ranges.robots.recorded = 0;
    const auto file = folder_.path() / "scene.toml";
    std::ofstream(file) << scene_;
    return {file, scene::SceneOptions{}, ranges};
  }
  static std::string class_of(const Stage& stage, std::size_t actor) {
    return std::ranges::find(stage.categories(), stage.actors()[actor].category, &Category::number)->name;
  }

  fixtures::TempFolder folder_;
  std::string scene_;
  int count_ = 0;
};

TEST_F(StageOfRobots, OneKindIsCalledRobot) {
  add_twin("a", {"elbow"});
  add_twin("b", {"elbow"});  // of another file, with the same joints
  const Stage both = stage();
  EXPECT_EQ(class_of(both, 0), "robot");
  EXPECT_EQ(class_of(both, 1), "robot");
}

TEST_F(StageOfRobots, NoTwoCategoriesHaveOneName) {
  add_twin("a", {"elbow"});
  add_twin("b", {"elbow", "knee"});
  add_twin("c", {"elbow"});
  const Stage all = stage();
  EXPECT_EQ(class_of(all, 0), "robot_twin");
  EXPECT_EQ(class_of(all, 1), "robot_twin_2");
  EXPECT_EQ(class_of(all, 2), "robot_twin");
  EXPECT_EQ(all.actors()[0].category, class_robot);
  EXPECT_EQ(all.actors()[1].category, class_next);
  EXPECT_EQ(std::ranges::find(all.categories(), class_next, &Category::number)->keypoints,
            (std::vector<std::string>{"trunk", "elbow", "knee", "front"}));
}

TEST_F(StageOfRobots, PosturesAreThoseOfTheArgumentsOfXacro) {
  const auto python = files::run_process({"python3", "-c", "import xacro"}, "");
  if (!python || python->exit_code != 0) GTEST_SKIP() << "python3 has no package xacro: pip install xacro";
  const auto file = folder_.path() / "arms.xacro";
  const std::string solid =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial><collision><geometry>"
      "<sphere radius='0.1'/></geometry></collision></link>";
  std::ofstream(file)
      << "<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:arg name='arm' default='false'/>"
         "<link name='base'>" +
             solid + "<xacro:if value='$(arg arm)'><link name='arm'>" + solid +
             "<joint name='elbow' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 1 0'/>"
             "</joint></xacro:if></robot>";
  add_robot("bare", file, "xacro = {arm = false}\n");
  add_robot("armed", file, "xacro = {arm = true}\n");
  const Stage both = stage();
  ASSERT_NE(both.actors()[0].entity->model().size(), both.actors()[1].entity->model().size());
  for (const Actor& actor : both.actors()) {
    const auto size = static_cast<std::size_t>(actor.entity->model().size());
    std::size_t count = 0;
    for (const auto& some : *actor.postures) {
      for (const Posture& posture : some) count += posture.joints.size() == size ? 1U : 0U;
    }
    EXPECT_EQ(count, 1U) << actor.entity->name();
  }
}

TEST_F(StageOfRobots, TheHashOfPosturesTellsAnotherPosture) {
  add_twin("a", {"elbow"});
  const std::uint64_t before = stage().postures().hash();
  EXPECT_EQ(stage().postures().hash(), before);
  scene_ += "pitch_deg = 10\n";
  EXPECT_NE(stage().postures().hash(), before);
}

}  // namespace
}  // namespace murosimf::dataset
