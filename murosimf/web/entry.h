/// entry.h - who may see and steer: a page in some other tab of a browser may not, though it reaches this computer's ports as well.
#pragma once

#include <string>
#include <string_view>

namespace murosimf::web {

/// What a client says of itself in its first line and headers; empty: nothing.
struct Visitor {
  std::string host;    ///< as it calls this server: "127.0.0.1:8080"
  std::string origin;  ///< of the page whose script asks: "https://somewhere.org"; programs have none
  std::string token;   ///< of the address: /?token=...
};

struct AccessRules {
  bool loopback = true;  ///< the server is reached from this computer alone
  std::string token;     ///< opens everything
};

/// Whoever has the token may. Without it, on loopback only: programs, and pages that this computer has served itself. Calling the server by
/// another name, as a page does that has its own name lead here, needs the token.
[[nodiscard]] bool may_enter(const AccessRules& rules, const Visitor& visitor);

/// "localhost", "127.0.0.1:80", "[::1]"
[[nodiscard]] bool is_loopback(std::string_view host);

/// 32 hexadecimal digits that nobody can guess. Throws SetupError if the system gives no random numbers.
[[nodiscard]] std::string new_token();

}  // namespace murosimf::web
