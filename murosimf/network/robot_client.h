/// robot_client.h - control software of a simulated robot, in its own program: reads and sets rows of numbers by name.
///
///     murosimf::client::RobotClient robot({.robot = "striker", .port = 5000});
///     const auto& ball = robot.signal("ground_truth.ball_position");
///     auto& velocity = robot.command("walk.velocity");
///     while (robot.next()) velocity.values[0] = ball.samples > 0 ? 0.2 : 0;
///
/// The names, units and rules are those of docs/library.md; docs/tcp.md has the rest. A program with several robots in one thread
/// calls ready() of each before it connects the next one, and answer() before next() of another one. This library needs Protobuf
/// and fmt, nothing else of the simulator.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::network {
class Connection;
}

namespace murosimf::wire {
class Ask;
class Commands;
class Cycle;
class Description;
class FromClient;
class ToClient;
}  // namespace murosimf::wire

namespace murosimf::client {

/// The address is not listened at, a name does not exist, or the simulator has ended the connection because of this program. One line.
class ClientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ClientOptions {
  std::string robot;
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
  double rate = 0;               ///< [Hz] requested, unless the scene gives one; 0: any
  std::string software = "C++";  ///< name in reports
  std::chrono::duration<double> patience{
      60};  ///< [s] for which it tries to connect, and waits for the answer to a question
};

/// Numbers to read, up to date after each next().
struct Signal {
  std::vector<double> values;
  std::vector<std::string> labels;  ///< of each number: the joint, or "x"
  std::int64_t time = 0;            ///< [ns] of simulated time at which they were measured
  std::uint64_t samples = 0;        ///< received so far; 0: none yet
};

/// Numbers to set. They apply until they are set again.
struct CommandRow {
  std::vector<double> values;
  std::vector<std::string> labels;
};

/// A message of a robot of the team.
struct TeamMessage {
  std::string bytes;
  std::string sender;     ///< empty: it comes from outside of the simulation
  std::int64_t sent = 0;  ///< [ns] of simulated time
};

/// The last picture of a camera.
struct Picture {
  int width = 0, height = 0;  ///< [px]
  std::string format;         ///< of pixels: rgb8, bayer_rggb8, ..., 32FC1 [m], 16UC1
  double period = 0;          ///< [s] of simulated time from one to the next
  std::string bytes;          ///< rows from the top, without gaps; empty: there was none yet
  std::int64_t time = 0;      ///< [ns] of simulated time at which the exposure of its first row began
  std::uint64_t number = 0;   ///< of pictures received so far
};

/// A shape of a drawing for observers.
struct Shape {
  enum Kind { circle, line, dots, sphere, polygon, text };
  Kind kind = circle;
  std::vector<double> points;  ///< [m] x, y, z of each point
  double size = 0;             ///< [m] radius, width of lines and dots, height of texts; 0: as small as can be seen
  std::array<double, 4> color{1, 1, 1, 1};  ///< red, green, blue, opacity from 0 to 1
  std::string words{};                      ///< of a text
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
  /// "camera.color", "camera.depth", "camera.labels"
  const Picture& picture(std::string_view name);
  /// Subscribes to messages of the team, and allows sending to it. Throws ClientError if there is no team.
  void use_messages();
  /// Ends the requests; the first next() does so as well.
  void ready();

  /// Sends the commands, unless answer() has, and waits for the next cycle. False: the run is over. Throws ClientError.
  [[nodiscard]] bool next();
  /// Sends the commands now: once per cycle.
  void answer();
  /// [ns] of simulated time of this cycle.
  [[nodiscard]] std::int64_t now() const { return now_; }
  /// Whether the run begins with this cycle, or begins again: commands hold before its first step, signals have no numbers yet.
  [[nodiscard]] bool starts() const { return starts_; }

  /// Messages from the team since the last cycle.
  [[nodiscard]] const std::vector<TeamMessage>& messages() const { return messages_; }
  /// Sends to all other robots of the team, with the commands.
  void send_message(std::string_view bytes) { sends_.emplace_back(bytes); }

  /// Draws shapes as a group of that name, which replaces the last one; without shapes it is removed. Points are in the world, or in
  /// the frame of the robot's base. Sent with the commands.
  void draw(std::string_view group, const std::vector<Shape>& shapes, bool of_robot = false);

  /// Adds a line to the report of the run; sent with the commands.
  void say(std::string_view line) { says_.emplace_back(line); }

 private:
  void connect(const ClientOptions& options);
  const wire::Description& ask(const wire::Ask& question, std::string_view name);
  void send();
  const wire::ToClient& receive(bool in_time);
  [[nodiscard]] bool read_cycle();
  void read_samples(const wire::Cycle& cycle);
  void read_messages(const wire::Cycle& cycle);
  void read_pictures(const wire::Cycle& cycle);

  RobotInfo info_;
  std::chrono::duration<double> patience_;
  std::deque<Signal> signals_;  // stay where they are
  std::deque<CommandRow> commands_;
  std::deque<Picture> pictures_;
  std::vector<TeamMessage> messages_;
  std::vector<std::string> says_, sends_;
  std::unique_ptr<wire::Commands> draws_;  // drawings of the next commands
  std::unique_ptr<network::Connection> connection_;
  std::unique_ptr<wire::FromClient> outgoing_;
  std::unique_ptr<wire::ToClient> incoming_;
  std::int64_t now_ = 0;
  std::uint64_t cycle_ = 0;
  bool ready_ = false, starts_ = false, owes_answer_ = false;
};

}  // namespace murosimf::client
