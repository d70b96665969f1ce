// Control software over TCP, on the loopback: cycles in lock-step, and how old commands are when they come into force at real time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/network/robot_client.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/scene/scene.h"

namespace {

using namespace murosimf;
using WallClock = std::chrono::steady_clock;

const std::vector<std::string> robots{"blue1", "blue2", "blue3", "red1", "red2", "red3"};

/// Six robots of scenes/three_on_three.toml, each with software in a thread of its own that answers at once.
class Match {
 public:
  /// `set` is called for each cycle of each software.
  template <class Set>
  Match(const std::string& mode, int threads, const Set& set) : server_(control_software::listen_for_software({})) {
    scene::SceneOptions options{.threads = threads, .cameras = false, .software = server_};
    for (const std::string& robot : robots) {
      options.overrides.push_back(robot + ".controller=tcp");
      options.overrides.push_back(robot + ".options.mode=" + mode);
      clients_.emplace_back([this, robot, set] { play(robot, set); });
    }
    scene_ = std::make_unique<scene::Scene>("three_on_three", options);
    scene_->simulation().initialize();
  }
  ~Match() {
    scene_.reset();  // ends the software, too
    for (std::thread& client : clients_) client.join();
  }
  Match(const Match&) = delete;
  Match& operator=(const Match&) = delete;

  [[nodiscard]] Simulation& simulation() { return scene_->simulation(); }
  [[nodiscard]] double cycles() const {
    double sum = 0;
    for (const std::string& robot : robots) {
      sum += static_cast<double>(control_software::software_report(scene_->simulation().world().entity(robot))->calls);
    }
    return sum;
  }

 private:
  template <class Set>
  void play(const std::string& name, const Set& set) const {
    client::RobotClient robot({.robot = name, .port = server_->address().port, .rate = 100});
    for (const char* signal : {"joint.position", "imu.gyroscope", "imu.accelerometer"}) (void)robot.signal(signal);
    auto& velocity = robot.command("walk.velocity");
    auto& others = robot.command("walk.other_joints");
    while (robot.next()) {
      others.values[0] = 0.1;
      set(velocity.values);
    }
  }

  std::shared_ptr<control_software::TcpServer> server_;
  std::vector<std::thread> clients_;
  std::unique_ptr<scene::Scene> scene_;
};

/// The simulation included.
void lock_step_tcp(benchmark::State& state) {
  Match match("lock_step", static_cast<int>(state.range(0)), [](std::vector<double>& velocity) { velocity[0] = 0.1; });
  const double before = match.cycles();
  for (auto _ : state) match.simulation().run(std::chrono::milliseconds(100));
  state.counters["robot_cycles"] = benchmark::Counter(match.cycles() - before, benchmark::Counter::kIsRate);
}
BENCHMARK(lock_step_tcp)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();

/// Algorithm: notes how old [s] the commands of its robot are when they are new; software writes the time of sending.
class AgeOfCommands final : public Algorithm {
 public:
  AgeOfCommands(Setup& setup, WallClock::time_point begin, std::vector<double>& ages)
      : command_(setup.read(properties::walk_command)), begin_(begin), ages_(&ages) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override {
    const double sent = command_[0].y;
    if (sent == last_) return;
    last_ = sent;
    ages_->push_back(std::chrono::duration<double>(WallClock::now() - begin_).count() - sent);
  }

 private:
  std::span<const Vec3d> command_;
  WallClock::time_point begin_;
  std::vector<double>* ages_;
  double last_ = 0;
};

/// Six robots at real time, 100 Hz: from the sending of a command until its robot follows it.
void free_tcp_age(benchmark::State& state) {
  const WallClock::time_point begin = WallClock::now();  // commands go up to 100, so for 100 s
  std::vector<double> ages;
  Match match("free", 1, [begin](std::vector<double>& velocity) {
    velocity[1] = std::chrono::duration<double>(WallClock::now() - begin).count();
  });
  match.simulation().attach<AgeOfCommands>("age_of_commands", match.simulation().world().entity("blue1"), 1000, begin,
                                           ages);
  for (auto _ : state) {
    Clock clock(1.0);
    match.simulation().run(std::chrono::seconds(10), clock);
  }
  if (ages.empty()) return state.SkipWithError("no commands have come");
  std::sort(ages.begin(), ages.end());
  const auto quantile = [&](double share) {
    return 1e3 * ages[static_cast<std::size_t>(share * static_cast<double>(ages.size() - 1))];
  };
  state.counters["commands"] = static_cast<double>(ages.size());
  state.counters["ms_median"] = quantile(0.5);
  state.counters["ms_90"] = quantile(0.9);
  state.counters["ms_99"] = quantile(0.99);
  state.counters["ms_worst"] = quantile(1);
}
BENCHMARK(free_tcp_age)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
