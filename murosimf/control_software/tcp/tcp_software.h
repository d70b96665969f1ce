/// tcp_software.h - control software in another program: one robot's.
///
/// In lock-step every cycle waits for the client's answer, so the run is repeatable. Otherwise the latest commands hold. When a client
/// disconnects or violates the protocol, the robot keeps its commands, and another one may connect at any cycle; in lock-step the run waits
/// for it for a while (TcpOptions::absence).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "murosimf/control_software/control_software.h"
#include "murosimf/control_software/tcp/tcp_clients.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/control_software/tcp/tcp_session.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::control_software {

class TcpSoftware final : public ControlSoftware {
 public:
  /// Answers requests of the client. Throws SoftwareWent if it does not get ready in time, or disconnects.
  TcpSoftware(const Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<TcpClients> clients,
              ArrivedClient client, const TcpOptions& options, std::uint64_t seed, ExternalInputRecorder pen);
  ~TcpSoftware() override;
  TcpSoftware(const TcpSoftware&) = delete;
  TcpSoftware& operator=(const TcpSoftware&) = delete;

  [[nodiscard]] CallOutcome start() override;
  [[nodiscard]] CallOutcome step(Duration now) noexcept override;
  [[nodiscard]] std::string news() override;
  void state(StateArchive& archive) override { jumped_ = jumped_ || archive.loads(); }
  [[nodiscard]] std::string absence() const override { return robot_.lock_step && !session_ ? last_ : std::string{}; }

 private:
  template <class Talk>
  bool guarded(const Talk& talk) noexcept;
  void drop(const std::string& reason) noexcept;
  void add_news(const std::string& line);
  void exchange_in_step(std::optional<Duration> now) noexcept;
  void ask(std::optional<Duration> now);
  void begin_with(ArrivedClient client);
  void exchange_freely(Duration now);
  void accept_another();
  void meet(ArrivedClient client);
  void catch_up(Duration now);
  void at(Duration now);
  [[nodiscard]] network::WallTime end_of_waiting() const;

  std::shared_ptr<TcpClients> clients_;
  TcpOptions options_;
  TcpRobot robot_;
  RobotPort* port_;
  SayLine say_;
  ExternalInputRecorder pen_;
  std::unique_ptr<TcpSession> session_;  // null: no client
  std::string client_;                   // the name of the last one
  std::string last_;                     // why it was disconnected
  std::string news_;
  bool jumped_ = false;  // since the last step
};

}  // namespace murosimf::control_software
