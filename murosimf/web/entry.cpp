#include "murosimf/web/entry.h"

#include "murosimf/model/error.h"
#include "murosimf/network/token.h"

namespace murosimf::web {
namespace {

std::string_view without_port(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

/// Whether the origin is this server, not another one on this computer; or a program that is built as a page.
bool is_own(const Visitor& visitor) {
  const std::string_view origin = visitor.origin;
  if (origin.empty() || origin == "file://") return true;
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return origin.substr(scheme.size()) == visitor.host;
  }
  return false;
}

}  // namespace

bool is_loopback(std::string_view host) {
  const std::string_view name = without_port(host);
  if (name == "localhost" || name == "[::1]") return true;
  return name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool may_enter(const AccessRules& rules, const Visitor& visitor) {
  if (!rules.token.empty() && network::is_token(visitor.token, rules.token)) return true;
  return rules.loopback && is_loopback(visitor.host) && is_own(visitor);
}

std::string new_token() {
  std::string token = network::new_token();
  if (token.empty()) throw SetupError("this system gives no random numbers for a token");
  return token;
}

}  // namespace murosimf::web
