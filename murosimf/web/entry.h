/// entry.h - access control of the server: a page in another tab of a browser is refused, although it reaches this computer's ports as well.
#pragma once

#include <string>
#include <string_view>

namespace murosimf::web {

/// Information of a client's request line and headers; empty: missing.
struct Visitor {
  std::string host;    ///< name of this server used by the client: "127.0.0.1:8080"
  std::string origin;  ///< origin of the requesting page: "https://somewhere.org"; programs have none
  std::string token;   ///< of the address: /?token=...
};

struct AccessRules {
  bool loopback = true;  ///< the server is reachable from this computer only
  std::string token;     ///< permits everything
};

/// Permits clients with the token. Without it, on loopback only: programs, and pages served by this server itself. Using
/// another name of the server, as by a page with a domain name that leads here (DNS rebinding), requires the token.
[[nodiscard]] bool may_enter(const AccessRules& rules, const Visitor& visitor);

/// "localhost", "127.0.0.1:80", "[::1]"
[[nodiscard]] bool is_loopback(std::string_view host);

/// 32 random hexadecimal digits. Throws SetupError if the system provides no random numbers.
[[nodiscard]] std::string new_token();

}  // namespace murosimf::web
