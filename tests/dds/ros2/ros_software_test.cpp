// A Booster K1 commanded by nodes of ROS 2 at the other end of DDS, on 127.0.0.1: trajectories, the action, the walk, garbage, recordings.
#include "murosimf/dds/ros2/ros_software.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/dds/ros2/ros_writer.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf::dds::ros2 {
namespace {

using namespace std::chrono_literals;

/// Tests run in processes of their own, at the same time.
int own_domain() { return 1 + getpid() % 99; }

constexpr const char* head = "AAHead_yaw";

class Node {
 public:
  Node()
      : participant_(own_domain()),
        trajectory_(writer("joint_trajectory_controller/joint_trajectory", "trajectory_msgs/JointTrajectory")),
        walk_(writer("cmd_vel", "geometry_msgs/Twist")) {}

  void turn_head(const char* joint, double angle, double time) {
    RosWriter out;
    out.header({}, "");
    out.texts(std::vector<std::string>{joint});
    out.u32(1);
    out.u32(1);
    out.f64(angle);
    for (int i = 0; i < 3; ++i) out.u32(0);
    out.time(from_seconds(time));
    trajectory_.write(out.encoded());
  }
  void walk(double forward) {
    RosWriter out;
    out.vector({forward, 0, 0});
    out.vector({});
    walk_.write(out.encoded());
  }
  void garbage() {
    trajectory_.write({0, 1, 0, 0, 1, 2, 3});
    walk_.write({0, 1});
  }
  /// Until the robot reads what is sent.
  void meet() {
    for (int i = 0; i < 5000 && !(trajectory_.has_readers() && walk_.has_readers()); ++i)
      std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(trajectory_.has_readers());
  }

 private:
  TopicWriter& writer(const std::string& topic, const std::string& type) {
    return participant_.writer({.name = topic_name("/k1/" + topic), .type = type_name(type), .reliable = true});
  }
  Participant participant_;
  TopicWriter &trajectory_, &walk_;
};

scene::SceneOptions options() {
  return {.overrides = {"k1.controller=ros2"}, .ros2_domain = own_domain(), .cameras = false};
}

struct RosSoftware : ::testing::Test {
  void SetUp() override {
    try {
      const Participant any(own_domain());
    } catch (const SetupError& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

double head_of(const scene::Scene& scene) {
  const Entity& k1 = scene.simulation().world().entity("k1");
  return k1.find(properties::joint_position)->values[static_cast<std::size_t>(k1.model().object_index(head))];
}

/// Messages arrive by threads of DDS, so steps wait a little.
void run_for(scene::Scene& scene, Duration time) {
  for (Duration t{}; t < time; t += 10ms) {
    std::this_thread::sleep_for(1ms);
    scene.simulation().run(10ms);
  }
}

TEST_F(RosSoftware, FollowsTrajectoriesAndIgnoresWhatDoesNotFit) {
  Node node;
  scene::Scene scene("booster", options());
  scene.simulation().initialize();
  node.meet();
  const auto said = [&] { return control_software::software_report(scene.simulation().world().entity("k1"))->said; };
  for (int i = 0; i < 200 && said().size() < 3; ++i) {  // the robot's side may learn of the node later
    node.turn_head("no_such_joint", 0.5, 0.2);
    node.garbage();
    run_for(scene, 50ms);
  }
  node.turn_head(head, 0.5, 0.4);
  run_for(scene, 1s);
  EXPECT_NEAR(head_of(scene), 0.5, 0.02);
  ASSERT_EQ(said().size(), 3U);
  EXPECT_EQ(said()[0].text, "a ROS 2 node has come that commands it");
}

TEST_F(RosSoftware, WalksUntilCommandsEnd) {
  Node node;
  scene::Scene scene("booster", options());
  scene.simulation().initialize();
  node.meet();
  const Entity& k1 = scene.simulation().world().entity("k1");
  for (int i = 0; i < 15; ++i) {
    node.walk(0.1);
    run_for(scene, 200ms);
  }
  const double way = k1.find(properties::odometry)->values[0].x;
  EXPECT_GT(way, 0.05);
  run_for(scene, 3s);
  const double stopped = k1.find(properties::odometry)->values[0].x;
  run_for(scene, 1s);
  EXPECT_NEAR(k1.find(properties::odometry)->values[0].x, stopped, 0.02);
}

TEST_F(RosSoftware, IsRepeatedFromARecording) {
  fixtures::RepeatableRun run{.scene = "booster", .how = options()};
  run.how.outside.notes = std::make_shared<ExternalInputLog>();
  run.options.state_period = 100ms;
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    Node node;
    node.meet();
    for (int i = 0; i < 200 && head_of(scene) < 0.1; ++i) {
      node.turn_head(head, 0.3, 0.2);
      run_for(scene, 300ms);
    }
    node.walk(0.1);
    run_for(scene, 300ms);
    EXPECT_NEAR(head_of(scene), 0.3, 0.03);
  };
  fixtures::expect_repeatable(fixtures::record("ros2.mcap", run));
}

}  // namespace
}  // namespace murosimf::dds::ros2
