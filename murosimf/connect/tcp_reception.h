/// tcp_reception.h - accepts clients in a thread of its own, until each has said whose software it is.
///
/// Clients that say something else, or nothing for too long, are refused with one line. There are never more of them than
/// most_strangers, and none of them is waited for.
#pragma once

#include <atomic>
#include <condition_variable>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/connect/tcp_client.h"
#include "murosimf/connect/tcp_server.h"

namespace murosimf::connect {

class TcpReception {
 public:
  /// Throws SetupError if nobody can listen there.
  explicit TcpReception(TcpServerOptions options);
  ~TcpReception();
  TcpReception(const TcpReception&) = delete;
  TcpReception& operator=(const TcpReception&) = delete;

  [[nodiscard]] wire::Address address() const { return listener_.own_address(); }
  void expect(std::vector<std::string> robots);
  /// Waits until the client of a robot is there, `limit` [s] of wall time. Nothing: it was stopped, or none has come.
  [[nodiscard]] std::optional<TcpClient> wait_for(const std::string& robot, double limit);
  [[nodiscard]] bool is_stopped() const { return options_.stop && options_.stop(); }
  /// The same without waiting.
  [[nodiscard]] std::optional<TcpClient> take(const std::string& robot);
  /// A robot's client has gone. From now on another one may come, or (`for_good`) none.
  void leave(const std::string& robot, bool for_good);

  static constexpr std::size_t most_strangers = 64;

 private:
  struct Stranger {
    TcpClient client;
    wire::WallTime end;  // by which it has said who it is
  };

  void receive_all();
  void accept_all(wire::WallTime now);
  [[nodiscard]] bool look_at(Stranger& stranger, wire::WallTime now);
  void turn_away(Stranger& stranger, const std::string& reason);
  void admit(TcpClient client);
  [[nodiscard]] std::string objection(const std::string& robot) const;
  void tell(const TcpClient& client, const std::string& reason);
  [[nodiscard]] std::optional<TcpClient> taken(const std::string& robot);

  TcpServerOptions options_;
  wire::Socket listener_;
  int wake_ = -1;                  // event that ends the thread's waiting
  std::list<Stranger> strangers_;  // the thread's own
  std::size_t told_ = 0;

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::optional<std::set<std::string>> robots_;  // nothing: they are not known yet
  std::map<std::string, TcpClient> waiting_;     // clients by robot, until they are taken
  std::vector<TcpClient> early_;                 // before robots were known
  std::set<std::string> busy_, closed_;          // robots that have a client, and those that get none any more
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::connect
