/// tcp_server.h - control software of robots in other programs and computers, over TCP (docs/tcp.md).
///
///     const auto server = control_software::listen_for_software({.address = {"127.0.0.1", 5000}});
///     scene::Scene scene("match.toml", {.software = server});          // waits for the software of its robots
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/software_maker.h"
#include "murosimf/model/error.h"
#include "murosimf/network/socket.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/pacer.h"

namespace murosimf::control_software {

/// [robots.options] of the controller "tcp".
struct TcpOptions {
  std::string mode = "lock_step";  ///< or "free"
  double limit = 10;               ///< [s] of wall time that software may take to answer a cycle
  double wait = 60;                ///< [s] of wall time for it to connect and to request what it needs
  double absence = 1;              ///< [s] of wall time, in lock-step: for others to connect after it has disconnected
};

struct TcpServerOptions {
  network::Address address;
  SayLine say = {};        ///< clients that were refused, one line each; called by another thread
  StopRequest stop = {};   ///< whether waiting for clients ends early
  double hello_limit = 5;  ///< [s] of wall time in which clients must send their Hello
};

/// Software that disconnected, or violated the protocol, before it was ready: other software may take its place.
class SoftwareWent : public SetupError {
 public:
  using SetupError::SetupError;
};

/// The software that has connected for a robot.
struct ArrivedSoftware {
  std::string name;  ///< "walk.py at 127.0.0.1:40312"
  double rate = 0;   ///< [Hz] requested; 0: any
  SoftwareMaker make;
};

class TcpServer {
 public:
  virtual ~TcpServer() = default;
  /// Where it listens.
  [[nodiscard]] virtual network::Address address() const = 0;
  /// Sets the robots that exist: clients for others are refused.
  virtual void expect(std::vector<std::string> robots) = 0;
  /// Waits for a robot's software. Its input is logged with `pen`. Throws SetupError if none connects in time.
  [[nodiscard]] virtual ArrivedSoftware wait_for(const std::string& robot, const TcpOptions& options,
                                                 std::uint64_t seed, ExternalInputRecorder pen) = 0;
  /// Passes a line about failed clients to TcpServerOptions::say.
  virtual void tell(const std::string&) {}
};

/// Throws SetupError: the port is in use; this program was built without TCP.
[[nodiscard]] std::shared_ptr<TcpServer> listen_for_software(TcpServerOptions options);

/// A robot's recorded software, which repeats its input. Throws SetupError: there was none; this program was built without TCP.
[[nodiscard]] ArrivedSoftware repeat_software(std::shared_ptr<const ExternalInputLog> notes, const std::string& robot,
                                              const TcpOptions& options, std::uint64_t seed, ExternalInputRecorder pen);

}  // namespace murosimf::control_software
