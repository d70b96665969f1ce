#include "murosimf/control_software/tcp/tcp_server.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/tcp/tcp_clients.h"
#include "murosimf/control_software/tcp/tcp_reception.h"
#include "murosimf/control_software/tcp/tcp_software.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

class ReceivingServer final : public TcpServer {
 public:
  explicit ReceivingServer(TcpServerOptions options) : reception_(std::make_shared<TcpReception>(std::move(options))) {}

  [[nodiscard]] network::Address address() const override { return reception_->address(); }
  void expect(std::vector<std::string> robots) override { reception_->expect(std::move(robots)); }
  [[nodiscard]] ArrivedSoftware wait_for(const std::string& robot, const TcpOptions& options, std::uint64_t seed,
                                         ExternalInputRecorder pen) override;
  void tell(const std::string& line) override { reception_->tell(line); }

 private:
  std::shared_ptr<TcpReception> reception_;
};

ArrivedSoftware arrived(std::shared_ptr<TcpClients> clients, ArrivedClient first, const TcpOptions& options,
                        std::uint64_t seed, ExternalInputRecorder pen) {
  const auto client = std::make_shared<ArrivedClient>(std::move(first));  // makers can be copied, lines cannot
  return {client->name, client->rate, [=](Setup& setup, RobotPort& port, const SayLine& say) {
            return std::make_unique<TcpSoftware>(setup, port, say, clients, std::move(*client), options, seed, pen);
          }};
}

ArrivedSoftware ReceivingServer::wait_for(const std::string& robot, const TcpOptions& options, std::uint64_t seed,
                                          ExternalInputRecorder pen) {
  const auto clients = std::make_shared<ReceivedClients>(reception_, robot);
  std::optional<ArrivedClient> found = clients->wait(options.wait);
  if (!found && reception_->is_stopped()) {
    throw SetupError(fmt::format("stopped while waiting for the software of {}", robot));
  }
  if (!found) {
    throw SetupError(fmt::format("{}: no software has come for it to {} within {} s", robot,
                                 to_text(reception_->address()), options.wait));
  }
  return arrived(clients, std::move(*found), options, seed, pen);
}

}  // namespace

std::shared_ptr<TcpServer> listen_for_software(TcpServerOptions options) {
  return std::make_shared<ReceivingServer>(std::move(options));
}

ArrivedSoftware repeat_software(std::shared_ptr<const ExternalInputLog> notes, const std::string& robot,
                                const TcpOptions& options, std::uint64_t seed, ExternalInputRecorder pen) {
  const auto clients = std::make_shared<RepeatedClients>(std::move(notes), "tcp:" + robot);
  try {
    if (std::optional<ArrivedClient> first = clients->take()) {
      return arrived(clients, std::move(*first), options, seed, pen);
    }
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("the software of {} {}", robot, error.what()));
  }
  throw SetupError(fmt::format("the recording does not say which software came for {}", robot));
}

}  // namespace murosimf::control_software
