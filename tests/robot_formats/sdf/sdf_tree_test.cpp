/// sdf_tree_test - links and joints in any order become a tree and the loops in it.
#include "murosimf/robot_formats/sdf/sdf_tree.h"

#include "tests/robot_formats/sdf/sdf_files.h"

namespace murosimf::robot_formats::sdf {
namespace {

using namespace sdf_files;

std::vector<int> links_of(const SdfTree& tree) {
  std::vector<int> links;
  for (const SdfNode& node : tree.nodes) links.push_back(node.link);
  return links;
}

TEST(SdfTree, PutsParentsFirstAndBranchesInTheOrderOfJoints) {
  const SdfTree tree = make_tree(5, {{3, 1}, {0, 3}, {0, 2}, {3, 4}});
  EXPECT_EQ(links_of(tree), (std::vector<int>{0, 3, 1, 4, 2}));
  EXPECT_EQ(tree.nodes[2].parent, 1);
  EXPECT_EQ(tree.nodes[2].joint, 0);
  EXPECT_TRUE(tree.closers.empty());
  EXPECT_TRUE(tree.loose.empty());
}

TEST(SdfTree, BeginsAtTheWorldIfAJointIsThere) {
  const SdfTree tree = make_tree(2, {{0, 1}, {-1, 0}});
  EXPECT_EQ(links_of(tree), (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(tree.nodes[1].joint, 1);
}

TEST(SdfTree, TurnsAJointRoundThatPointsTheOtherWay) {
  const SdfTree tree = make_tree(3, {{0, 1}, {2, 1}});
  EXPECT_EQ(links_of(tree), (std::vector<int>{0, 1, 2}));
  EXPECT_FALSE(tree.nodes[1].reversed);
  EXPECT_TRUE(tree.nodes[2].reversed);
}

// a four-bar: the last joint in the order of ranks closes it, wherever it stands
TEST(SdfTree, ClosesLoopsWithTheHighestRank) {
  const SdfTree tree = make_tree(4, {{0, 1, 1}, {1, 2, 2}, {0, 3, 1}, {3, 2, 1}});
  EXPECT_EQ(tree.closers, (std::vector<int>{1}));
  EXPECT_EQ(links_of(tree), (std::vector<int>{0, 1, 3, 2}));
}

TEST(SdfTree, NamesWhatNothingHolds) {
  const SdfTree tree = make_tree(4, {{0, 1}, {2, 3}});
  EXPECT_EQ(tree.loose, (std::vector<int>{2, 3}));
  EXPECT_TRUE(tree.closers.empty());
}

TEST(SdfTree, TakesACircle) {
  const SdfTree tree = make_tree(2, {{0, 1}, {1, 0}});
  EXPECT_EQ(links_of(tree), (std::vector<int>{0, 1}));
  EXPECT_EQ(tree.closers, (std::vector<int>{1}));
}

class SdfLoops : public SdfTest {};

const std::string four_bar = link("a") + link("b", "<pose>0 0 1 0 0 0</pose>") + link("c", "<pose>1 0 1 0 0 0</pose>") +
                             link("d", "<pose>1 0 0 0 0 0</pose>") +
                             joint("revolute", "a", "b", "<axis><xyz>0 1 0</xyz></axis>", "ab") +
                             joint("revolute", "b", "c", "<axis><xyz>0 1 0</xyz></axis>", "bc") +
                             joint("revolute", "a", "d", "<axis><xyz>0 1 0</xyz></axis>", "ad");

TEST_F(SdfLoops, AreConnectedAtABall) {
  const auto robot = read(model(four_bar + joint("ball", "d", "c", "<pose>0 0 -0.5 0 0 0</pose>", "dc")));
  ASSERT_EQ(robot.loops.size(), 1u);
  EXPECT_FALSE(robot.loops[0].welded);
  EXPECT_EQ(robot.loops[0].frame1, "dc.end1");
  int found = 0;
  for (const robot_formats::BodyDescription& body : robot.bodies) {
    for (const robot_formats::FrameDescription& frame : body.frames) {
      const Transformd place = place_in_base(robot, body.name) * frame.place;
      expect_near(place.position, {1, 0, 0.5});
      ++found;
    }
  }
  EXPECT_EQ(found, 2);
}

TEST_F(SdfLoops, OfHingesHaveTwoPointsOfTheirAxis) {
  const auto robot = read(model(four_bar + joint("revolute", "d", "c", "<axis><xyz>0 1 0</xyz></axis>", "dc")));
  ASSERT_EQ(robot.loops.size(), 2u);
  const auto& frames = robot.bodies.back().frames;
  ASSERT_EQ(frames.size(), 2u);
  expect_near(frames[1].place.position - frames[0].place.position, {0, 0.1, 0});
}

TEST_F(SdfLoops, OfSlidersAreRefused) {
  const std::string said =
      message(model(four_bar + joint("prismatic", "d", "c", "<axis><xyz>0 1 0</xyz></axis>", "dc")));
  EXPECT_TRUE(contains(said, "joint 'dc' of type 'prismatic' closes a loop")) << said;
}

// the second link moves about the joint's axis as in the file, seen from the other side
TEST_F(SdfLoops, KeepSignsOfJointsThatAreTurnedRound) {
  const auto robot =
      read(model(link("a") + link("b") + link("c", "<pose>0 0 2 0 0 0</pose>") + joint("fixed", "a", "b", "", "ab") +
                 joint("revolute", "c", "b", "<pose>0 0 1 0 0 0</pose><axis><xyz>1 0 0</xyz></axis>", "cb")));
  const robot_formats::BodyDescription& body = robot.bodies.at(2);
  EXPECT_EQ(body.name, "c");
  expect_near(body.joints.at(0).axis, {-1, 0, 0});
  expect_near(body.joints[0].anchor, {0, 0, -1});
}

}  // namespace
}  // namespace murosimf::robot_formats::sdf
