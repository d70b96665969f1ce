/// tcp_fixture.h - scenes of robots with software over TCP, software in threads, and clients that can send any bytes.
#pragma once

#include <gtest/gtest.h>
#include <robot_protocol.pb.h>

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "examples/controllers/walk_to_ball_tcp.h"
#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/network/connection.h"
#include "murosimf/network/robot_client.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"

namespace murosimf::control_software::fixtures {

using namespace std::chrono_literals;
using ::murosimf::fixtures::error_of;
using ::murosimf::fixtures::says;

inline network::WallTime soon() { return std::chrono::steady_clock::now() + 20s; }

/// A server for software, and its reports.
class Listener {
 public:
  explicit Listener(double hello_limit = 5)
      : server(listen_for_software({.say =
                                        [this](const std::string& line) {
                                          const std::lock_guard lock(mutex_);
                                          lines_.push_back(line);
                                        },
                                    .hello_limit = hello_limit})) {}
  ~Listener() { server.reset(); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  [[nodiscard]] std::vector<std::string> lines() const {
    const std::lock_guard lock(mutex_);
    return lines_;
  }
  /// Waits until there are so many.
  [[nodiscard]] std::vector<std::string> lines(std::size_t count) const {
    const network::WallTime end = soon();
    while (lines().size() < count && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(5ms);
    return lines();
  }
  [[nodiscard]] std::uint16_t port() const { return server->address().port; }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;

 public:
  std::shared_ptr<TcpServer> server;  // last: its thread writes lines
};

/// The two robots of the example; `overrides` as for --set.
inline scene::SceneOptions two_robots(const Listener& listener, std::vector<std::string> overrides = {},
                                      int threads = 1) {
  return {.threads = threads, .overrides = std::move(overrides), .cameras = false, .software = listener.server};
}
inline const std::filesystem::path to_the_ball_tcp = MUROSIMF_SOURCE_DIR "/examples/controllers/to_the_ball_tcp.toml";

/// Software in a thread; its exception is kept.
class Software {
 public:
  explicit Software(std::function<void()> run)
      : thread_([this, run = std::move(run)] {
          try {
            run();
          } catch (const std::exception& error) {
            error_ = error.what();
          }
        }) {}
  ~Software() { (void)error(); }
  Software(const Software&) = delete;
  Software& operator=(const Software&) = delete;

  /// Waits until it has ended; empty: by itself.
  const std::string& error() {
    if (thread_.joinable()) thread_.join();
    return error_;
  }

 private:
  std::string error_;
  std::thread thread_;
};

/// The text of a ClientError; "none" if there is none.
template <class F>
std::string error_text(const F& f) {
  try {
    f();
  } catch (const client::ClientError& error) {
    return error.what();
  }
  return "none";
}

/// A client that may violate the protocol.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port) : connection(network::Socket::connect({.port = port}), 1 << 20) {}

  void send(const wire::FromClient& message) {
    connection.send(message.SerializeAsString());
    connection.flush_until(soon());
  }
  void bytes(std::string_view text) const {
    while (!text.empty()) {
      text.remove_prefix(connection.socket().send(text));
      (void)connection.socket().wait(soon(), true);
    }
  }
  wire::ToClient receive() {
    wire::ToClient message;
    const std::string_view bytes = connection.receive_until(soon());
    EXPECT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
    return message;
  }
  /// Receives until the simulator closes the connection; returns the reason that it gave.
  std::string end() {
    std::string reason;
    try {
      for (;;) {
        const wire::ToClient message = receive();
        if (message.has_refusal()) reason = message.refusal().reason();
      }
    } catch (const network::NetworkError&) {  // closed
    }
    return reason;
  }
  void hello(const std::string& robot, unsigned version = 1) {
    wire::FromClient message;
    message.mutable_hello()->set_version(version);
    message.mutable_hello()->set_robot(robot);
    message.mutable_hello()->set_software("raw");
    send(message);
  }
  void ask_for_velocity() {
    wire::FromClient message;
    message.mutable_ask()->set_command("walk.velocity");
    send(message);
  }
  void ready() {
    wire::FromClient message;
    message.mutable_ready();
    send(message);
  }
  /// Hello, welcome, walk.velocity, ready.
  void come(const std::string& robot) {
    hello(robot);
    EXPECT_TRUE(receive().has_welcome());
    ask_for_velocity();
    EXPECT_TRUE(receive().has_description());
    ready();
  }
  void answer(std::uint64_t cycle, std::vector<double> velocity = {0.1, 0, 0}) {
    wire::FromClient message;
    message.mutable_commands()->set_cycle(cycle);
    message.mutable_commands()->add_rows()->mutable_values()->Add(velocity.begin(), velocity.end());
    send(message);
  }
  /// Answers this many cycles.
  void play(int cycles) {
    for (int i = 0; i < cycles; ++i) answer(receive().cycle().cycle());
  }

  network::Connection connection;
};

inline const SoftwareReport& software(const scene::Scene& scene, const std::string& robot) {
  return *software_report(scene.simulation().world().entity(robot));
}

/// [m/s] Its last command.
inline double forward(const scene::Scene& scene, const std::string& robot) {
  return scene.simulation().world().entity(robot).base().get(properties::walk_command).x;
}

/// Steps of the run at real time, until `done`.
template <class Done>
[[nodiscard]] bool run_until(scene::Scene& scene, const Done& done) {
  const network::WallTime end = soon();
  while (!done() && std::chrono::steady_clock::now() < end) {
    scene.simulation().run(50ms);
    std::this_thread::sleep_for(2ms);
  }
  return done();
}

}  // namespace murosimf::control_software::fixtures
