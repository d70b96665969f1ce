/// tcp_session.h - the talk with one client: what it asks for, the cycles that it is told, and the commands that it answers.
///
/// Whatever the client does wrong throws WireError; the caller then ends the session.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/connect/robot_port.h"
#include "murosimf/connect/tcp/tcp_clients.h"
#include "murosimf/connect/tcp/tcp_server.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::wire {
class Ask;
class Commands;
class Cycle;
class Description;
class ToClient;
}  // namespace murosimf::wire

namespace murosimf::connect {

/// What a client is told of its robot.
struct TcpRobot {
  std::string name, team, model;
  double period = 0;  ///< [s]
  std::uint64_t seed = 0;
  bool lock_step = true;
};

class TcpSession {
 public:
  /// Welcomes the client. What it sends is written down with `pen`, which must outlive it, once it was found good.
  TcpSession(std::unique_ptr<ClientLine> line, TcpRobot robot, RobotPort& port, SayLine say,
             ExternalInputRecorder& pen);
  ~TcpSession();
  TcpSession(const TcpSession&) = delete;
  TcpSession& operator=(const TcpSession&) = delete;

  /// Answers what it asks for, until it is ready.
  void set_up(wire::WallTime end);
  [[nodiscard]] bool is_ready() const { return ready_; }
  /// false: of a recording.
  [[nodiscard]] bool is_live() const { return line_->live(); }
  /// Of a recording, after time has jumped: asks that it had made before.
  void ask_again(std::string_view message) { take(message); }

  /// Tells it the cycle at `now`, or that the run begins.
  void publish_cycle(Duration now);
  void publish_start();
  /// Waits for the answer to it and puts it into the port's commands.
  void wait_for_answer(wire::WallTime end);
  /// Takes what has come, without waiting.
  void take_what_has_come(wire::WallTime now);

  /// Whether it can be told more: what it was told has left, and it still works on one cycle at most. What sockets buffer would make
  /// slow software fall ever further behind.
  [[nodiscard]] bool keeps_up() { return ready_ && line_->flush() && (!is_live() || cycle_ - answered_ <= 1); }
  /// Whether it is to get ready or to answer, and since when nothing of that kind has come.
  [[nodiscard]] bool is_waited_for() const { return !ready_ || owes_answer_; }
  [[nodiscard]] wire::WallTime waited_for_since() const { return heard_at_; }

  /// The last words, if they can be said without waiting.
  void say_goodbye() noexcept;
  void say_refused(const std::string& reason) noexcept;

 private:
  void take(std::string_view bytes);
  [[nodiscard]] ExternalInput::Kind take_message();
  void answer(const wire::Ask& ask);
  void describe_signal(const std::string& name, wire::Description& described);
  void describe_command(const std::string& name, wire::Description& described);
  void describe_picture(const std::string& name, wire::Description& described);
  void publish_samples(wire::Cycle& cycle) const;
  void publish_messages(wire::Cycle& cycle);
  void publish_pictures(wire::Cycle& cycle);
  void take_over(const wire::Commands& commands);
  void send_to_team(const wire::Commands& commands);
  void draw(const wire::Commands& commands);
  void check_rate(wire::WallTime now);
  void send();
  void tell();

  std::unique_ptr<ClientLine> line_;
  TcpRobot robot_;
  RobotPort* port_;
  SayLine say_;
  ExternalInputRecorder* pen_;
  std::vector<const murosimf_signal*> signals_;
  std::vector<murosimf_command*> commands_;
  std::vector<std::string> command_names_;
  struct Asked {
    const murosimf_picture* picture;
    std::uint64_t told = 0;  // number of the last one that was told
  };
  std::vector<Asked> pictures_;
  std::size_t picture_bytes_ = 0;  // of one of each
  bool has_messages_ = false;
  std::unique_ptr<wire::FromClient> incoming_;
  std::unique_ptr<wire::ToClient> outgoing_;
  std::string bytes_;
  std::uint64_t cycle_ = 0, started_ = 0;  // the last one that it was told, and the one of the start
  std::uint64_t answered_ = 0;             // the last one
  bool ready_ = false, owes_answer_ = false;
  wire::WallTime heard_at_{};  // or since when it owes the answer
  std::size_t asked_ = 0;
  std::size_t messages_ = 0;  // within the second that began then
  wire::WallTime second_{};
};

}  // namespace murosimf::connect
