/// udp_port.h - a socket for datagrams (IPv4) that never waits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/league/datagrams.h"

namespace murosimf::league {

struct UdpAddress {
  std::string host = "127.0.0.1";  ///< four numbers
  std::uint16_t port = 0;

  /// "HOST:PORT", or "PORT" of this machine alone. Throws SetupError with the expected form.
  [[nodiscard]] static UdpAddress parse(std::string_view text);
  friend bool operator==(const UdpAddress&, const UdpAddress&) = default;
};

class UdpPort final : public Datagrams {
 public:
  /// Receives at `listen` (port 0: any free one); given datagrams go to `send_to`, or, with `answer_port`, to that port of
  /// the machine that sent the last datagram, before that nowhere. Throws SetupError, with the address: it is in use, or invalid.
  struct Options {
    UdpAddress listen;
    std::optional<UdpAddress> send_to{};
    std::uint16_t answer_port = 0;
  };
  explicit UdpPort(const Options& options);
  ~UdpPort() override;
  UdpPort(const UdpPort&) = delete;
  UdpPort& operator=(const UdpPort&) = delete;

  /// At most most_at_once; the rest stays in the system, which drops the excess.
  [[nodiscard]] std::vector<std::string> take(Duration now) override;
  void give(std::string_view bytes) override;
  [[nodiscard]] std::uint16_t port() const;  ///< port that it listens at

  static constexpr int most_at_once = 16;

 private:
  int socket_;
  std::uint16_t answer_port_;
  std::uint32_t to_host_ = 0;  // in network byte order; 0: none yet
  std::uint16_t to_port_ = 0;
};

}  // namespace murosimf::league
