#include "murosimf/connect/tcp_server.h"
#include "murosimf/model/error.h"

namespace murosimf::connect {

std::shared_ptr<TcpServer> listen_for_software(TcpServerOptions) {
  throw SetupError(
      "this program was built without Protobuf, so nobody can connect (Debian and Ubuntu: libprotobuf-dev, "
      "protobuf-compiler)");
}

}  // namespace murosimf::connect
