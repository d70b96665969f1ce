// The C++ that pages of docs/ quote: it compiles and runs here, and scripts/check_pages.py compares both.
//
//     example_page_code
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <future>
#include <memory>
#include <span>
#include <thread>
#include <vector>

#include <murosimf/collision/queries.h>
#include <murosimf/collision/touches.h>
#include <murosimf/control_software/tcp/tcp_server.h>
#include <murosimf/dynamics/full_dynamics.h>
#include <murosimf/logging/run_log.h>
#include <murosimf/model/properties.h>
#include <murosimf/runtime/pose_feed.h>
#include <murosimf/runtime/thread_pool.h>
#include <murosimf/scene/assets.h>
#include <murosimf/scene/scene.h>
#include <murosimf/sensors/camera_frame.h>
#include <murosimf/sensors/reading.h>
#include <murosimf/session/session.h>
#include <murosimf/supervise/supervision.h>
#include <murosimf/world/column_view.h>

using namespace murosimf;
using namespace std::chrono_literals;

namespace {

int errors = 0;

void expect(bool right, const char* what) {
  std::printf("%s: %s\n", what, right ? "as the page says" : "NOT as the page says");
  if (!right) ++errors;
}

// docs/cameras.md

int looks = 0;

void look_at(const imaging::ColorImage&, const imaging::Lens&, Duration) { ++looks; }

class BallFinder final : public Algorithm {
 public:
  explicit BallFinder(Setup& setup) : frame_(sensors::read_frame(setup, "camera")) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant&) noexcept override {
    if (frame_.number == last_) return;
    last_ = frame_.number;
    look_at(frame_.color, frame_.info->lens, frame_.time);
  }

 private:
  const sensors::CameraFrame& frame_;
  std::uint64_t last_ = 0;
};

void cameras() {
  scene::Scene scene("six_cameras");
  Simulation& simulation = scene.simulation();
  const bool draws = simulation.warnings().empty();
  simulation.attach<BallFinder>("ball_finder", simulation.world().entity("blue1"), 100);
  simulation.run(200ms);
  if (draws) expect(looks > 0, "cameras.md, an algorithm that looks");
}

// docs/sensors.md

class BalanceController final : public Algorithm {
 public:
  BalanceController(Setup& setup) : gyro_(sensors::read_output(setup, "imu.gyroscope")) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant&) noexcept override { lean_ += period_ * gyro_[1]; }
  [[nodiscard]] double lean() const { return lean_; }

 private:
  std::span<const double> gyro_;
  double lean_ = 0, period_ = 0.001;
};

void balance() {
  scene::Scene scene("nudge");
  const auto& controller =
      scene.simulation().attach<BalanceController>("lean", scene.simulation().world().entity("robot"), 1000);
  scene.simulation().run(2s);
  expect(std::abs(controller.lean()) > 0, "sensors.md, in control software");
}

// docs/collision.md

void questions() {
  scene::Scene duel("duel");
  Simulation& simulation = duel.simulation();
  simulation.run(10ms);
  Entity& robot = simulation.world().entity("blue1");
  const Entity& ball = simulation.world().entity("ball");
  const Vec3d eye = robot.object("head").get(properties::position), forward{1, 0, -0.5}, place = eye;
  std::size_t touched = 0;
  collision::QueryScene scene(simulation.world());
  scene.refresh();
  const auto hit = scene.cast({eye, forward}, {.range = 5.0});
  const auto gap = scene.distance({&robot}, {&ball});
  const auto there = scene.overlapping(Sphere{0.3}, {place, {}});
  for (const auto& touch : collision::touches(simulation.world(), robot)) touched += touch.other != nullptr;
  std::printf("%zu bodies are touched\n", touched);
  expect(hit && gap && !there.empty(), "collision.md, what you can ask");
}

// docs/embedding.md

int drawn = 0;

void draw(const PoseFrame&) { ++drawn; }

void steer() {
  scene::Scene scene("three_on_three", {.cameras = false});
  Simulation& simulation = scene.simulation();
  auto reader = simulation.poses().subscribe({.period = 20ms, .contacts = true});
  std::future<void> done = scene.post("blue1.level = full_dynamics");
  simulation.run(100ms);
  done.get();
  if (const PoseFrame* frame = reader->latest()) draw(*frame);
  expect(drawn == 1, "embedding.md, looking on");

  Entity& robot = simulation.world().entity("blue1");
  const double before = robot.view("position")(12, 2);
  ColumnView positions = robot.view("position");
  positions(12, 2) += 0.1;
  expect(robot.view("position")(12, 2) == before + 0.1, "embedding.md, columns");

  // docs/levels.md
  scene.exchange_level("blue1", "articulated_dynamics");
  simulation.exchange<dynamics::FullDynamics>("full_dynamics", robot);
  expect(simulation.level_of(robot)->traits().dynamic, "levels.md, in a program");

  scene.reset();
  scene.reset(1234);
  expect(simulation.now() == 0s, "embedding.md, back to the start");
}

void come_and_go() {
  scene::Scene scene("three_on_three", {.cameras = false});
  scene.leave("red1");
  scene.enter("red1");
  scene_file::RobotSpec robot = scene.spec().robots[0];
  robot.name = "blue4";
  robot.position = {-2, 1.5, 0};
  Entity& blue4 = scene.add(robot);
  expect(blue4.name() == "blue4", "embedding.md, who is there");
}

void repeat() {
  scene::Scene scene("walk");
  (void)scene.post("walker.command = [0.1, 0, 0.5]");
  scene.simulation().run(200ms);
  const auto& commands = scene.simulation().commands();
  scene::Scene again("walk", {.events = scene::events_of_commands(commands)});
  again.simulation().run(200ms);
  expect(again.simulation().state_hash() == scene.simulation().state_hash(), "embedding.md, the run again");
}

void session_steered() {
  scene::Scene scene("walk", {.overrides = {"walker.level=simplified_dynamics"}, .pushable = true});
  session::Session session(scene, {.speed = 1.0});
  std::thread run([&] { session.run(60s); });
  session.change("walker.torso.push = [60, 0, 0, 0.1]").get();
  while (session.status().time < 2100ms) std::this_thread::sleep_for(10ms);
  session.pause();
  session.seek(2s).get();
  session.go_on();
  session.finish();
  run.join();
  expect(scene.simulation().now() >= 2s, "embedding.md, steering");
}

void many_worlds() {
  auto assets = std::make_shared<scene::Assets>();
  scene::Scene first("walk", {.assets = assets});
  scene::Scene second(first.spec(), {.assets = assets});
  const std::vector<scene::Scene*> worlds{&first, &second};
  ThreadPool pool(8);
  pool.for_each(worlds.size(), [&](std::size_t i) { worlds[i]->simulation().run(20ms); });
  expect(first.simulation().state_hash() == second.simulation().state_hash(), "embedding.md, many worlds");
}

// docs/logging.md

void log_of() {
  scene::Scene scene("three_on_three", {.cameras = false});
  logging::RunLog log(scene.simulation(), {"blue1.imu"}, {.step_rate = scene.spec().rate});
  scene.simulation().run(10s);
  log.write("run.csv");
  expect(std::filesystem::remove("run.csv"), "logging.md, from C++");
}

// docs/supervise.md and docs/tcp.md: both wait for other programs, so they only compile

[[maybe_unused]] void supervised() {
  scene::Scene scene("walk");
  session::Session session(scene, {.paused = true});
  const auto supervision = supervise::supervise(session, {.address = {"127.0.0.1", 5001}});
  session.run(60s);
}

[[maybe_unused]] void software_from_outside() {
  const auto server = control_software::listen_for_software({.address = {"127.0.0.1", 5000}});
  scene::Scene scene("ball.toml", {.software = server});
}

}  // namespace

int main() {
  cameras();
  balance();
  questions();
  steer();
  come_and_go();
  repeat();
  session_steered();
  many_worlds();
  log_of();
  return errors;
}
