#include "murosimf/viewer/viewer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/drawing/roboviz_server.h"
#include "murosimf/model/error.h"
#include "murosimf/session/live_source.h"
#include "murosimf/viewer/mouse_control.h"

namespace murosimf::viewer {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> dynamic{"blue1.level=simplified_dynamics"};

ViewerOptions options_with(std::vector<std::string> overrides = dynamic, Duration end = 1s) {
  ViewerOptions options;
  options.make_source = [overrides = std::move(overrides)] {
    return std::make_unique<session::LiveSource>(
        std::make_unique<scene::Scene>("three_on_three",
                                       scene::SceneOptions{.overrides = overrides, .pushable = true}));
  };
  options.session.paused = true;
  options.end = end;
  options.inspections = 200;
  return options;
}

/// Runs to its end as a window does: looking all the time.
void watch_to_end(Viewer& viewer) {
  viewer.session().go_on();
  for (int i = 0; i < 60000; ++i) {
    viewer.refresh(0.001);
    const auto& status = viewer.status();  // may come before the last frame
    if (status.paused && status.time >= status.end && viewer.poses().frame() &&
        viewer.poses().frame()->time >= status.end)
      return;
    std::this_thread::sleep_for(1ms);
  }
  FAIL() << "it did not come to its end";
}

std::uint64_t hash_of(Viewer& viewer) {
  viewer.settle();
  viewer.running().finish();
  return viewer.running().scene().simulation().state_hash();
}

bool told(const Viewer& viewer, const std::string& part) {
  for (const Message& message : viewer.messages()) {
    if (message.text.find(part) != std::string::npos) return true;
  }
  return false;
}

// What keeps its own state and goes on otherwise than it was there before is told of in a message.
TEST(Viewer, TellsWhatWillNotGoOnAsItWas) {
  ViewerOptions options = options_with();
  options.make_source = [make = options.make_source] {
    auto source = make();
    source->scene().parts().outside.memory->expect("the GameController");
    return source;
  };
  Viewer viewer(options);
  watch_to_end(viewer);
  viewer.session().seek(300ms).get();
  viewer.settle();
  EXPECT_TRUE(told(viewer, "the GameController keeps its own state: from 0.3 s on")) << "in a message";
}

// Rule: looking changes nothing, whatever is looked at.
TEST(Viewer, LookingChangesNothing) {
  scene::Scene alone("three_on_three", {.overrides = dynamic});
  alone.simulation().run(1s);
  Viewer viewer(options_with());
  viewer.perform(Action::select_1);
  viewer.perform(Action::contacts);
  viewer.perform(Action::support_polygons);
  viewer.perform(Action::tv_camera);
  viewer.open_objects[{viewer.outline().robot(0), 0}] = true;
  viewer.plots.add(viewer.outline(), {viewer.outline().robot(0), 0}, "position", false);
  viewer.wants_algorithms = viewer.wants_pictures = true;
  watch_to_end(viewer);
  EXPECT_FALSE(viewer.overlays_now().marks.empty());
  ASSERT_FALSE(viewer.plots[0].plot.curves.empty());
  EXPECT_FALSE(viewer.plots[0].plot.curves[0].times().empty()) << "how many hangs on how fast it runs";
  EXPECT_FALSE(viewer.seen().algorithms.empty());
  EXPECT_EQ(hash_of(viewer), alone.simulation().state_hash());
}

// What a viewer's touches have done is repeated by the commands of the run.
TEST(Viewer, TouchesCanBeRepeated) {
  Viewer viewer(options_with());
  viewer.select(viewer.outline().path_of("blue1"));
  viewer.steering.push(viewer.outline().path_of("blue1"), {20, 0, 0});
  viewer.perform(Action::select_2);
  viewer.perform(Action::next_level);
  viewer.steering.move(viewer.outline().ball(), {0.5, 0.25, 0.05});
  viewer.settle();
  watch_to_end(viewer);
  const std::uint64_t hash = hash_of(viewer);
  const auto commands = viewer.running().scene().simulation().commands();
  EXPECT_EQ(commands.size(), 3U);
  scene::Scene again("three_on_three", {.overrides = dynamic, .events = scene::events_of_commands(commands)});
  again.simulation().run(1s);
  EXPECT_EQ(again.simulation().state_hash(), hash);
}

TEST(Viewer, LevelsGoRound) {
  Viewer viewer(options_with({}));
  viewer.perform(Action::select_3);
  const std::string first = viewer.seen().entities[static_cast<std::size_t>(viewer.selected_entity())].level;
  std::vector<std::string> levels;
  for (int i = 0; i < 4; ++i) {
    viewer.perform(Action::next_level);
    viewer.settle();
    levels.push_back(viewer.seen().entities[static_cast<std::size_t>(viewer.selected_entity())].level);
  }
  EXPECT_NE(levels[0], first);
  EXPECT_EQ(levels.back(), first) << "of four";
}

TEST(Viewer, ARefusalIsAMessage) {
  Viewer viewer(options_with({}));
  viewer.steering.push(viewer.outline().path_of("blue1"), {20, 0, 0});  // at kinematic_walking
  viewer.steering.change("blue1.levle = full_dynamics");
  viewer.perform(Action::select_9);
  viewer.settle();
  EXPECT_TRUE(told(viewer, "ignores forces"));
  EXPECT_TRUE(told(viewer, "levle"));
  EXPECT_TRUE(told(viewer, "no robot number 9"));
}

TEST(Viewer, APropertyIsEdited) {
  Viewer viewer(options_with());
  const ObjectPath base = viewer.outline().path_of("blue1");
  viewer.open_objects[base] = true;
  viewer.settle();
  const auto& values = viewer.seen().objects.at(0).properties;
  const auto position = std::ranges::find(values, "position", &PropertyValue::name);
  ASSERT_NE(position, values.end());
  PropertyValue next = *position;
  next.numbers[0] += 0.125;
  viewer.steering.set_property(base, next);
  viewer.settle();
  const auto place = viewer.poses().place_of(base);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, next.numbers[0], 1e-12) << "seen at once, while it is paused";
}

// The time line: back to an earlier instant, and on from there as another branch.
TEST(Viewer, GoesBackAndOn) {
  Viewer viewer(options_with());
  watch_to_end(viewer);
  viewer.settle();
  const Vec3d at_end = *viewer.poses().place_of(viewer.outline().path_of("blue1"));
  viewer.steering.seek(0.25);
  viewer.settle();
  EXPECT_EQ(viewer.status().time, 250ms);
  EXPECT_EQ(viewer.poses().frame()->time, 250ms);
  EXPECT_NE(viewer.poses().place_of(viewer.outline().path_of("blue1"))->x, at_end.x);
  viewer.perform(Action::step_back);
  viewer.settle();
  EXPECT_EQ(viewer.status().time, 249ms);
  watch_to_end(viewer);
  viewer.settle();
  EXPECT_GE(viewer.branches().size(), 2U);
  EXPECT_EQ(viewer.poses().place_of(viewer.outline().path_of("blue1"))->x, at_end.x) << "it was not moved";
  viewer.session().pause();
  viewer.steering.reset();
  viewer.settle();
  EXPECT_EQ(viewer.status().time, 0s);
}

TEST(Viewer, ReadsTheSceneAgain) {
  int made = 0;
  ViewerOptions options = options_with();
  options.make_source = [&, make = options.make_source] {
    if (++made == 3) throw SetupError("broken now");
    return make();
  };
  Viewer viewer(options);
  watch_to_end(viewer);
  viewer.perform(Action::reload);
  viewer.settle();
  EXPECT_EQ(viewer.status().time, 0s);
  EXPECT_EQ(made, 2);
  viewer.perform(Action::reload);
  EXPECT_TRUE(told(viewer, "broken now"));
  viewer.refresh(0.01);
  EXPECT_TRUE(viewer.poses().frame()) << "the old one goes on";
}

/// A mouse over a picture in which `name` is hit wherever it points.
struct Mouse {
  Mouse(Viewer& which, const std::string& name) : viewer(which), control(which) {
    const ObjectPath path = viewer.outline().path_of(name);
    const Vec3d place = *viewer.poses().place_of(path);
    pick = [path, place](const Pixel&) { return Hit{path, place}; };
    view = viewer.rig.view(viewer.rig_view(), 800, 600);
    at = *pixel_of(view, place);
  }
  void drag(const MouseControl::Held& held, const Vec3d& way,
            MouseControl::Button button = MouseControl::Button::left) {
    const Pixel to = *pixel_of(view, *viewer.poses().place_of(*pick(at)->path) + way);
    control.press(button, held, at, view, pick);
    control.move({0.5 * (at.x + to.x), 0.5 * (at.y + to.y)}, view);
    control.move(to, view);
    control.release(to, view, pick);
  }
  Viewer& viewer;
  MouseControl control;
  MouseControl::Pick pick;
  sensors::Perspective view;
  Pixel at;
};

TEST(MouseControl, AClickSelectsAndADragTurns) {
  Viewer viewer(options_with());
  Mouse mouse(viewer, "red1");
  mouse.control.press(MouseControl::Button::left, {}, mouse.at, mouse.view, mouse.pick);
  mouse.control.release(mouse.at, mouse.view, mouse.pick);
  EXPECT_EQ(viewer.selected(), viewer.outline().path_of("red1"));
  const double azimuth = viewer.rig.orbit.azimuth;
  mouse.control.press(MouseControl::Button::left, {}, {10, 10}, mouse.view, mouse.pick);
  mouse.control.move({110, 10}, mouse.view);
  mouse.control.release({110, 10}, mouse.view, mouse.pick);
  EXPECT_NE(viewer.rig.orbit.azimuth, azimuth);
  EXPECT_EQ(viewer.selected(), viewer.outline().path_of("red1"));
}

TEST(MouseControl, ShiftMovesTheBall) {
  Viewer viewer(options_with());
  Mouse mouse(viewer, "ball");
  const Vec3d before = *viewer.poses().place_of(viewer.outline().path_of("ball"));
  mouse.drag({.shift = true}, {0.4, -0.3, 0});
  viewer.settle();
  const Vec3d after = *viewer.poses().place_of(viewer.outline().path_of("ball"));
  EXPECT_NEAR(after.x, before.x + 0.4, 1e-6);
  EXPECT_NEAR(after.y, before.y - 0.3, 1e-6);
  EXPECT_NEAR(after.z, before.z, 1e-9);
}

TEST(MouseControl, CtrlPushesAlongThePicture) {
  Viewer viewer(options_with());
  Mouse mouse(viewer, "blue1");
  const Vec3d way = 0.1 * mouse.view.axes.x;
  mouse.drag({.ctrl = true}, way, MouseControl::Button::right);
  viewer.settle();
  viewer.running().finish();
  const auto& commands = viewer.running().scene().simulation().commands();
  ASSERT_EQ(commands.size(), 1U);
  double fx = 0, fy = 0, fz = 0, time = 0;
  const auto bracket = commands[0].text.find('[');
  ASSERT_NE(bracket, std::string::npos) << commands[0].text;
  ASSERT_EQ(std::sscanf(commands[0].text.c_str() + bracket, "[%lf, %lf, %lf, %lf]", &fx, &fy, &fz, &time), 4)
      << commands[0].text;
  const Vec3d force = 200 * way;
  EXPECT_NEAR(norm(Vec3d{fx, fy, fz} - force), 0, 0.02);
  EXPECT_EQ(time, 0.1);
}

// What the eye sees of a thing is pulled: to the right turns it about the axis that points up in the picture, by the right hand.
TEST(MouseControl, CtrlAndTheLeftButtonTurn) {
  Viewer viewer(options_with());
  Mouse mouse(viewer, "blue1");
  mouse.drag({.ctrl = true}, 0.1 * mouse.view.axes.x);
  viewer.settle();
  viewer.running().finish();
  const auto& commands = viewer.running().scene().simulation().commands();
  ASSERT_EQ(commands.size(), 1U);
  double f[3], m[3], time = 0;
  const auto bracket = commands[0].text.find('[');
  ASSERT_EQ(std::sscanf(commands[0].text.c_str() + bracket, "[%lf, %lf, %lf, %lf, %lf, %lf, %lf]", &f[0], &f[1], &f[2],
                        &m[0], &m[1], &m[2], &time),
            7)
      << commands[0].text;
  const Vec3d up = -1.0 * mouse.view.axes.y;  // y of the picture points down
  EXPECT_EQ(std::hypot(f[0], f[1], f[2]), 0);
  EXPECT_NEAR(norm(Vec3d{m[0], m[1], m[2]} - 2.0 * up), 0, 0.002) << "20 N m for a meter";
  EXPECT_EQ(time, 0.1);
}

TEST(Viewer, MovesJointsWhileItIsPaused) {
  Viewer viewer(options_with());
  viewer.select(viewer.outline().path_of("blue1"));
  const auto shin = [&] {
    for (const MovableJoint& joint : viewer.joints()) {
      if (joint.name.find("shin") != std::string::npos) return joint;
    }
    ADD_FAILURE() << "no shin";
    return MovableJoint{};
  };
  const MovableJoint before = shin();
  EXPECT_LT(before.lowest, before.highest);
  const double wanted = 0.5 * (before.lowest + before.highest);
  ASSERT_GT(std::abs(wanted - before.position), 0.01);
  for (const double share : {0.25, 0.5, 1.0}) {
    viewer.steering.move_joint(before.path, before.position + share * (wanted - before.position));
  }
  viewer.settle();
  EXPECT_NEAR(shin().position, wanted, 1e-6);
  viewer.running().finish();
  const auto& commands = viewer.running().scene().simulation().commands();
  ASSERT_FALSE(commands.empty()) << "the run can be repeated";
  EXPECT_NE(commands.back().text.find(before.name + ".joint_position = "), std::string::npos);
}

/// A circle on the ground in the group "way", as agents of the league send it (tests/drawing/roboviz_test.cpp has all of it).
void draw_circle(std::uint16_t port) {
  const std::string packet = std::string("\1\0", 2) + "1.00000.50000.25001.0000" + "\xff\x80" + '\0' + "way" + '\0' +
                             std::string(2, '\0') + "way" + '\0';
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_GT(::sendto(socket, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  ::close(socket);
}

// Rule: drawings of others change nothing, and can be switched off by their groups.
TEST(Viewer, ShowsWhatOthersDraw) {
  const drawing::RobovizServer door({"127.0.0.1", 0});
  ViewerOptions options = options_with(dynamic, 200ms);
  options.others = &door;
  Viewer viewer(options);
  const auto shapes = [&] { return viewer.drawings_in(viewer.rig.view(viewer.rig_view(), 800, 600)); };
  EXPECT_TRUE(shapes().empty());
  draw_circle(door.address().port);
  for (int i = 0; i < 2000 && shapes().empty(); ++i) std::this_thread::sleep_for(1ms);
  ASSERT_FALSE(shapes().empty());
  const Pixel middle = *pixel_of(viewer.rig.view(viewer.rig_view(), 800, 600), {1, 0.5, 0});
  EXPECT_LT(std::hypot(shapes()[0].points[0].x - middle.x, shapes()[0].points[0].y - middle.y), 60);
  EXPECT_EQ(viewer.drawing_groups(), std::vector<std::string>{"roboviz/way"});
  viewer.drawings.hidden.insert("roboviz/way");
  EXPECT_TRUE(shapes().empty());
  EXPECT_EQ(viewer.drawing_groups().size(), 1U) << "it can be switched on again";
  viewer.drawings.hidden.clear();
  viewer.perform(Action::drawings);
  EXPECT_TRUE(shapes().empty());
  watch_to_end(viewer);
  scene::Scene alone("three_on_three", {.overrides = dynamic});
  alone.simulation().run(200ms);
  EXPECT_EQ(hash_of(viewer), alone.simulation().state_hash());
}

TEST(MouseControl, ARunningSceneIsNotMoved) {
  ViewerOptions options = options_with(dynamic, Duration::max());
  options.session.paused = false;
  options.session.speed = 1.0;
  Viewer viewer(options);
  viewer.refresh(0);
  Mouse mouse(viewer, "ball");
  mouse.drag({.shift = true}, {0.4, 0, 0});
  EXPECT_TRUE(told(viewer, "pause first"));
}

TEST(CameraRig, FollowsWhatIsSelected) {
  Viewer viewer(options_with());
  viewer.perform(Action::select_1);
  viewer.perform(Action::follow);
  viewer.refresh(0.01);
  const Vec3d away = viewer.rig.orbit.target - *viewer.poses().place_of({viewer.outline().robot(0), 0});
  watch_to_end(viewer);
  viewer.settle();
  viewer.refresh(0.01);
  EXPECT_NEAR(norm(viewer.rig.orbit.target - *viewer.poses().place_of({viewer.outline().robot(0), 0}) - away), 0, 1e-9);
}

TEST(CameraRig, TelevisionLooksAtTheBall) {
  Viewer viewer(options_with());
  viewer.perform(Action::tv_camera);
  viewer.refresh(100);
  const auto pixel =
      pixel_of(viewer.rig.view(viewer.rig_view(), 1000, 600), *viewer.poses().place_of({viewer.outline().ball(), 0}));
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 500, 30);
  EXPECT_NEAR(pixel->y, 300, 60);
}

}  // namespace
}  // namespace murosimf::viewer
