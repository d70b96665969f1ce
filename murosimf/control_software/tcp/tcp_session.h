/// tcp_session.h - the session with one client: its requests, the cycles sent to it, and the commands it answers.
///
/// Every violation of the protocol throws NetworkError; the caller then ends the session.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/control_software/tcp/tcp_clients.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::wire {
class Ask;
class Commands;
class Cycle;
class Description;
class ToClient;
}  // namespace murosimf::wire

namespace murosimf::control_software {

/// Description of its robot for a client.
struct TcpRobot {
  std::string name, team, model;
  double period = 0;  ///< [s]
  std::uint64_t seed = 0;
  bool lock_step = true;
};

class TcpSession {
 public:
  /// Welcomes the client. Its input is logged with `pen`, which must outlive the session, once it was found valid.
  TcpSession(std::unique_ptr<ClientLine> line, TcpRobot robot, RobotPort& port, SayLine say,
             ExternalInputRecorder& pen);
  ~TcpSession();
  TcpSession(const TcpSession&) = delete;
  TcpSession& operator=(const TcpSession&) = delete;

  /// Answers requests until the client is ready.
  void set_up(network::WallTime end);
  [[nodiscard]] bool is_ready() const { return ready_; }
  /// false: recorded.
  [[nodiscard]] bool is_live() const { return line_->live(); }
  /// Recorded, after a jump in time: repeats an earlier request.
  void ask_again(std::string_view message) { take(message); }

  /// Sends the cycle at `now`, or the start of the run.
  void publish_cycle(Duration now);
  void publish_start();
  /// Waits for its answer and writes it to the port's commands.
  void wait_for_answer(network::WallTime end);
  /// Processes received messages, without waiting.
  void receive_pending(network::WallTime now);

  /// Whether another cycle can be sent: earlier ones have left, and at most one is being processed. Buffering in sockets would make
  /// slow software fall ever further behind.
  [[nodiscard]] bool keeps_up() { return ready_ && line_->flush() && (!is_live() || cycle_ - answered_ <= 1); }
  /// Whether the client must get ready or answer, and since when it has not.
  [[nodiscard]] bool is_waited_for() const { return !ready_ || owes_answer_; }
  [[nodiscard]] network::WallTime waited_for_since() const { return heard_at_; }

  /// The last message, if it can be sent without waiting.
  void send_goodbye() noexcept;
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
  void check_rate(network::WallTime now);
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
    std::uint64_t told = 0;  // number of the last one sent
  };
  std::vector<Asked> pictures_;
  std::size_t picture_bytes_ = 0;  // of one of each
  bool has_messages_ = false;
  std::unique_ptr<wire::FromClient> incoming_;
  std::unique_ptr<wire::ToClient> outgoing_;
  std::string bytes_;
  std::uint64_t cycle_ = 0, started_ = 0;  // the last one sent, and the one of the start
  std::uint64_t answered_ = 0;             // the last one answered
  bool ready_ = false, owes_answer_ = false;
  network::WallTime heard_at_{};  // or since when it owes the answer
  std::size_t asked_ = 0;
  std::size_t messages_ = 0;  // within the second that began then
  network::WallTime second_{};
};

}  // namespace murosimf::control_software
