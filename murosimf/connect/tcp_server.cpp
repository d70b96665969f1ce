#include "murosimf/connect/tcp_server.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/connect/tcp_reception.h"
#include "murosimf/connect/tcp_software.h"
#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

class ReceivingServer final : public TcpServer {
 public:
  explicit ReceivingServer(TcpServerOptions options) : reception_(std::make_shared<TcpReception>(std::move(options))) {}

  [[nodiscard]] wire::Address address() const override { return reception_->address(); }
  void expect(std::vector<std::string> robots) override { reception_->expect(std::move(robots)); }
  [[nodiscard]] ArrivedSoftware wait_for(const std::string& robot, const TcpOptions& options,
                                         std::uint64_t seed) override;

 private:
  std::shared_ptr<TcpReception> reception_;
};

ArrivedSoftware ReceivingServer::wait_for(const std::string& robot, const TcpOptions& options, std::uint64_t seed) {
  std::optional<TcpClient> found = reception_->wait_for(robot, options.wait);
  if (!found && reception_->is_stopped()) {
    throw SetupError(fmt::format("stopped while waiting for the software of {}", robot));
  }
  if (!found) {
    throw SetupError(fmt::format("{}: no software has come for it to {} within {} s", robot,
                                 to_text(reception_->address()), options.wait));
  }
  const auto client = std::make_shared<TcpClient>(std::move(*found));  // makers can be copied, connections cannot
  return {client->name(), client->rate, [=, reception = reception_](Setup& setup, RobotPort& port, const SayLine& say) {
            return std::make_unique<TcpSoftware>(setup, port, say, reception, std::move(*client), options, seed);
          }};
}

}  // namespace

std::shared_ptr<TcpServer> listen_for_software(TcpServerOptions options) {
  return std::make_shared<ReceivingServer>(std::move(options));
}

}  // namespace murosimf::connect
