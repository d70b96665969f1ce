/// tcp_clients.h - sources of a robot's software over TCP: programs that connect, or recorded ones (external_input_log.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/tcp/tcp_reception.h"
#include "murosimf/network/connection.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::control_software {

/// Messages to a client and from it. Throws NetworkError as network::Connection does; of a recording, for what it left.
class ClientLine {
 public:
  virtual ~ClientLine() = default;
  /// false: recorded; messages sent to it are dropped, and no call takes wall time.
  [[nodiscard]] virtual bool live() const = 0;
  virtual void send(std::string_view message) = 0;
  virtual void flush_until(network::WallTime end) = 0;
  /// Without waiting.
  [[nodiscard]] virtual std::optional<std::string_view> receive() = 0;
  [[nodiscard]] virtual std::string_view receive_until(network::WallTime end) = 0;
  /// Whether all that was sent to it has left. Recorded: whether it was sent a cycle at that time.
  [[nodiscard]] virtual bool flush() = 0;
};

struct ArrivedClient {
  std::string name;  ///< "walk.py at 127.0.0.1:40312"
  double rate = 0;   ///< [Hz] requested; 0: any
  std::unique_ptr<ClientLine> line;
};

/// Of one robot.
class TcpClients {
 public:
  virtual ~TcpClients() = default;
  /// Time of all following calls; nothing: set-up.
  virtual void at(Duration) {}
  /// Another client that has connected, without waiting.
  [[nodiscard]] virtual std::optional<ArrivedClient> take() = 0;
  /// The same, waiting for `limit` [s] of wall time. Nothing: it was stopped, or none has connected.
  [[nodiscard]] virtual std::optional<ArrivedClient> wait(double limit) = 0;
  /// The client has disconnected. From now on another one may connect, or (`for_good`) none.
  virtual void leave(bool for_good) = 0;
  /// Recorded, after a jump in time: all lasting input before `now`; continues there. Live: nothing.
  [[nodiscard]] virtual std::vector<ExternalInput> jump_to(Duration) { return {}; }
  /// The line of a client that jump_to() has reported.
  [[nodiscard]] virtual std::unique_ptr<ClientLine> line() { return nullptr; }
};

/// Clients of a reception.
class ReceivedClients final : public TcpClients {
 public:
  ReceivedClients(std::shared_ptr<TcpReception> reception, std::string robot)
      : reception_(std::move(reception)), robot_(std::move(robot)) {}
  [[nodiscard]] std::optional<ArrivedClient> wait(double limit) override;
  [[nodiscard]] std::optional<ArrivedClient> take() override;
  void leave(bool for_good) override { reception_->leave(robot_, for_good); }

 private:
  std::shared_ptr<TcpReception> reception_;
  std::string robot_;
};

/// Clients of a recording.
class RepeatedClients final : public TcpClients {
 public:
  /// `channel` may be null: it has no notes.
  RepeatedClients(std::shared_ptr<const ExternalInputLog> notes, const std::string& channel)
      : notes_(std::move(notes)), cursor_(std::make_shared<Cursor>(notes_->find(channel))) {}
  void at(Duration now) override { cursor_->now = now; }
  [[nodiscard]] std::optional<ArrivedClient> take() override;
  [[nodiscard]] std::optional<ArrivedClient> wait(double) override { return take(); }
  void leave(bool) override {}
  [[nodiscard]] std::vector<ExternalInput> jump_to(Duration now) override;
  [[nodiscard]] std::unique_ptr<ClientLine> line() override;

 private:
  class Line;
  struct Cursor {
    explicit Cursor(const ExternalInputLog::Channel* channel) : reader(channel) {}
    ExternalInputReader reader;
    Duration now = before_the_run;
  };

  std::shared_ptr<const ExternalInputLog> notes_;
  std::shared_ptr<Cursor> cursor_;
};

/// Bytes of a note ExternalInput::came, and back. Throws NetworkError if they are malformed.
[[nodiscard]] std::string to_bytes(const ArrivedClient& client);
[[nodiscard]] ArrivedClient arrived_client(std::string_view bytes);

}  // namespace murosimf::control_software
