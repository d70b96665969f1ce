/// tcp_reception.h - connected clients that have named their robot, until their software is created (network/reception.h).
///
/// Clients that send something else, or nothing for too long, are refused with one line.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/control_software/tcp/tcp_client.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/network/reception.h"

namespace murosimf::control_software {

class TcpReception {
 public:
  /// Throws SetupError if the address cannot be used.
  explicit TcpReception(TcpServerOptions options);
  ~TcpReception();
  TcpReception(const TcpReception&) = delete;
  TcpReception& operator=(const TcpReception&) = delete;

  [[nodiscard]] network::Address address() const { return reception_->address(); }
  void expect(std::vector<std::string> robots);
  /// Waits until the client of a robot has connected, `limit` [s] of wall time. Nothing: it was stopped, or none has connected.
  [[nodiscard]] std::optional<TcpClient> wait_for(const std::string& robot, double limit);
  [[nodiscard]] bool is_stopped() const { return options_.stop && options_.stop(); }
  /// The same without waiting.
  [[nodiscard]] std::optional<TcpClient> take(const std::string& robot);
  /// The client of a robot has disconnected. From now on another one may connect, or (`for_good`) none.
  void leave(const std::string& robot, bool for_good);
  /// TcpServer::tell.
  void tell(const std::string& line);

 private:
  void inspect(network::Caller& caller, std::string_view message);
  void reject(network::Caller& caller, const std::string& reason);
  void admit(TcpClient client);
  [[nodiscard]] std::string objection(const std::string& robot);
  void remove_disconnected(const std::string& robot);
  void publish_refusal(const std::string& address, const std::string& reason);
  void say(const std::string& line);
  [[nodiscard]] std::optional<TcpClient> taken(const std::string& robot);

  TcpServerOptions options_;
  std::size_t told_ = 0;

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::optional<std::set<std::string>> robots_;    // nothing: they are not known yet
  std::map<std::string, TcpClient> waiting_;       // clients by robot, until they are taken
  std::vector<TcpClient> early_;                   // before robots were known
  std::map<std::string, network::Socket> busy_;    // connections of clients that were taken, by robot
  std::set<std::string> closed_;                   // robots that accept no client any more
  std::unique_ptr<network::Reception> reception_;  // last member: its thread calls the others
};

}  // namespace murosimf::control_software
