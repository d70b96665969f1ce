/// roboviz_server.h - receives drawings of other programs in the protocol of RoboViz (roboviz_drawings.h), by UDP, in its own thread.
///
///     drawing::RobovizServer door({"127.0.0.1", 32769});
///     draw(*door.shown());                               // from any thread
///
/// Invalid packets are ignored and counted.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "murosimf/drawing/roboviz_drawings.h"
#include "murosimf/network/socket.h"

namespace murosimf::drawing {

class RobovizServer final : public DebugDrawSource {
 public:
  static constexpr std::uint16_t usual_port = 32769;

  /// Port 0: one that is free. Throws NetworkError if the address cannot be listened at.
  explicit RobovizServer(const network::Address& address);
  ~RobovizServer() override;

  [[nodiscard]] const network::Address& address() const { return address_; }
  /// A copy, made if something is new.
  [[nodiscard]] std::shared_ptr<const ExternalDrawings> shown() const override;
  [[nodiscard]] std::uint64_t packets() const { return packets_; }
  [[nodiscard]] std::uint64_t ignored() const { return ignored_; }  ///< of them

 private:
  void listen();

  int socket_ = -1, wake_ = -1;
  network::Address address_;
  mutable std::mutex mutex_;  // of what follows
  RobovizDrawings drawings_;
  mutable std::shared_ptr<const ExternalDrawings> shown_ = std::make_shared<const ExternalDrawings>();
  std::atomic<std::uint64_t> packets_{0}, ignored_{0};
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::drawing
