#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

[[noreturn]] void refuse() {
  throw SetupError(
      "this program was built without Protobuf, so nothing can connect (Debian and Ubuntu: libprotobuf-dev, "
      "protobuf-compiler)");
}

}  // namespace

std::shared_ptr<TcpServer> listen_for_software(TcpServerOptions) { refuse(); }

ArrivedSoftware repeat_software(std::shared_ptr<const ExternalInputLog>, const std::string&, const TcpOptions&,
                                std::uint64_t, ExternalInputRecorder) {
  refuse();
}

}  // namespace murosimf::control_software
