/// tcp_software.h - control software in another program: one robot's.
///
/// In lock-step every cycle waits for the client's answer, so the run is repeatable; a client that does not answer ends. Otherwise
/// the latest commands hold, a client that goes leaves them, and another one may come.
#pragma once

#include <memory>
#include <string>

#include "murosimf/connect/control_software.h"
#include "murosimf/connect/outside_notes.h"
#include "murosimf/connect/tcp_clients.h"
#include "murosimf/connect/tcp_session.h"

namespace murosimf::connect {

class TcpSoftware final : public ControlSoftware {
 public:
  /// Answers what the client asks for. Throws SetupError if it does not get ready in time, or goes.
  TcpSoftware(const Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<TcpClients> clients,
              ArrivedClient client, const TcpOptions& options, std::uint64_t seed, OutsidePen pen);
  ~TcpSoftware() override;
  TcpSoftware(const TcpSoftware&) = delete;
  TcpSoftware& operator=(const TcpSoftware&) = delete;

  [[nodiscard]] CallOutcome start() override;
  [[nodiscard]] CallOutcome step(Duration now) noexcept override;
  [[nodiscard]] std::string news() override;
  void state(StateArchive& archive) override { jumped_ = jumped_ || archive.loads(); }

 private:
  template <class Talk>
  [[nodiscard]] CallOutcome guarded(const Talk& talk) noexcept;
  [[nodiscard]] std::string drop(const std::string& reason) noexcept;
  void talk_freely(Duration now);
  void welcome_another();
  void meet(ArrivedClient client);
  void catch_up(Duration now);
  void at(Duration now);
  [[nodiscard]] wire::WallTime end_of_waiting() const;

  std::shared_ptr<TcpClients> clients_;
  TcpOptions options_;
  TcpRobot robot_;
  RobotPort* port_;
  SayLine say_;
  OutsidePen pen_;
  std::unique_ptr<TcpSession> session_;  // null: nobody is there
  std::string client_;                   // the name of the last one
  std::string last_;                     // why it has gone
  std::string news_;
  bool jumped_ = false;  // since the last step
};

}  // namespace murosimf::connect
