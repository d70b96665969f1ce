/// tcp_reception.h - clients that have said whose software they are, until somebody takes them (wire/reception.h).
///
/// Clients that say something else, or nothing for too long, are refused with one line.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/connect/tcp/tcp_client.h"
#include "murosimf/connect/tcp/tcp_server.h"
#include "murosimf/wire/reception.h"

namespace murosimf::connect {

class TcpReception {
 public:
  /// Throws SetupError if nobody can listen there.
  explicit TcpReception(TcpServerOptions options);
  ~TcpReception();
  TcpReception(const TcpReception&) = delete;
  TcpReception& operator=(const TcpReception&) = delete;

  [[nodiscard]] wire::Address address() const { return reception_->address(); }
  void expect(std::vector<std::string> robots);
  /// Waits until the client of a robot is there, `limit` [s] of wall time. Nothing: it was stopped, or none has come.
  [[nodiscard]] std::optional<TcpClient> wait_for(const std::string& robot, double limit);
  [[nodiscard]] bool is_stopped() const { return options_.stop && options_.stop(); }
  /// The same without waiting.
  [[nodiscard]] std::optional<TcpClient> take(const std::string& robot);
  /// A robot's client has gone. From now on another one may come, or (`for_good`) none.
  void leave(const std::string& robot, bool for_good);
  /// TcpServer::tell.
  void tell(const std::string& line);

 private:
  void look_at(wire::Caller& caller, std::string_view message);
  void turn_away(wire::Caller& caller, const std::string& reason);
  void admit(TcpClient client);
  [[nodiscard]] std::string objection(const std::string& robot);
  void forget_who_has_gone(const std::string& robot);
  void publish_refusal(const std::string& address, const std::string& reason);
  void say(const std::string& line);
  [[nodiscard]] std::optional<TcpClient> taken(const std::string& robot);

  TcpServerOptions options_;
  std::size_t told_ = 0;

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::optional<std::set<std::string>> robots_;  // nothing: they are not known yet
  std::map<std::string, TcpClient> waiting_;     // clients by robot, until they are taken
  std::vector<TcpClient> early_;                 // before robots were known
  std::map<std::string, wire::Socket> busy_;     // connections of clients that were taken, by robot
  std::set<std::string> closed_;                 // robots that get none any more
  std::unique_ptr<wire::Reception> reception_;   // last: its thread calls
};

}  // namespace murosimf::connect
