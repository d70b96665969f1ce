/// robot_client.h - control software of a simulated robot, in a program of its own: it sees and sets rows of numbers by name.
///
///     murosimf::client::RobotClient robot({.robot = "striker", .port = 5000});
///     const auto& ball = robot.signal("ground_truth.ball_position");
///     auto& velocity = robot.command("walk.velocity");
///     while (robot.next()) velocity.values[0] = ball.samples > 0 ? 0.2 : 0;
///
/// The names, units and rules are those of docs/library.md; docs/tcp.md has the rest. A program whose one thread has several robots
/// calls ready() of each before it connects the next one, and answer() before next() of another one. This library needs Protobuf
/// and fmt, nothing else of the simulator.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::wire {
class Connection;
class FromClient;
class ToClient;
}  // namespace murosimf::wire

namespace murosimf::client {

/// Nobody listens, there is nothing of a name, or the simulator has ended the connection for what this program did. One line.
class ClientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ClientOptions {
  std::string robot;
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
  double rate = 0;               ///< [Hz] wanted, unless the scene says one; 0: any
  std::string software = "C++";  ///< what reports call it
  std::chrono::duration<double> patience{
      60};  ///< [s] for which nobody may listen yet, and in which a question is answered
};

/// Numbers to read, up to date after each next().
struct Signal {
  std::vector<double> values;
  std::vector<std::string> labels;  ///< of each number: the joint, or "x"
  std::int64_t time = 0;            ///< [ns] of simulated time at which they were measured
  std::uint64_t samples = 0;        ///< that have come so far; 0: there was none yet
};

/// Numbers to set. They hold until they are set again.
struct CommandRow {
  std::vector<double> values;
  std::vector<std::string> labels;
};

/// Its robot.
struct RobotInfo {
  std::string name, team, model;
  double period = 0;  ///< [s] of simulated time from one cycle to the next
  std::uint64_t seed = 0;
  bool lock_step = true;  ///< the simulation waits for each answer
};

class RobotClient {
 public:
  /// Connects, and waits until the robot is set up. Throws ClientError.
  explicit RobotClient(const ClientOptions& options);
  ~RobotClient();
  RobotClient(const RobotClient&) = delete;
  RobotClient& operator=(const RobotClient&) = delete;

  [[nodiscard]] const RobotInfo& info() const { return info_; }

  // Before ready(). What they return stays where it is. Throw ClientError if there is nothing of that name.
  const Signal& signal(std::string_view name);
  CommandRow& command(std::string_view name);
  /// Nothing more is asked for; the first next() says so, too.
  void ready();

  /// Sends the commands, unless answer() has, and waits for the next cycle. False: the run is over. Throws ClientError.
  [[nodiscard]] bool next();
  /// Sends the commands now: once per cycle.
  void answer();
  /// [ns] of simulated time of this cycle.
  [[nodiscard]] std::int64_t now() const { return now_; }
  /// Whether the run begins with this cycle, or begins again: commands hold before its first step, signals have no numbers yet.
  [[nodiscard]] bool starts() const { return starts_; }

  /// A line for the report of the run; sent with the commands.
  void say(std::string_view line) { says_.emplace_back(line); }

 private:
  void connect(const ClientOptions& options);
  std::vector<std::string> ask(std::string_view name, bool for_signal);
  void send();
  const wire::ToClient& receive(bool in_time);
  [[nodiscard]] bool take_cycle();

  RobotInfo info_;
  std::chrono::duration<double> patience_;
  std::deque<Signal> signals_;  // stay where they are
  std::deque<CommandRow> commands_;
  std::vector<std::string> says_;
  std::unique_ptr<wire::Connection> connection_;
  std::unique_ptr<wire::FromClient> outgoing_;
  std::unique_ptr<wire::ToClient> incoming_;
  std::int64_t now_ = 0;
  std::uint64_t cycle_ = 0;
  bool ready_ = false, starts_ = false, owes_answer_ = false;
};

}  // namespace murosimf::client
