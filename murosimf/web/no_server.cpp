#include "murosimf/model/error.h"
#include "murosimf/web/server.h"

namespace murosimf::web {

struct Server::Inside {};

Server::Server(Options) {
  throw SetupError("this program was built without a server for browsers (Debian and Ubuntu: libwebsockets-dev)");
}
Server::~Server() = default;
const network::Address& Server::address() const {
  static const network::Address none;
  return none;
}
int Server::clients() const { return 0; }

}  // namespace murosimf::web
