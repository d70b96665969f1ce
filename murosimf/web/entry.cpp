#include "murosimf/web/entry.h"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::web {
namespace {

/// Compares in constant time, so that the time does not reveal a prefix of the token.
bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

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
  if (!rules.token.empty() && equal(rules.token, visitor.token)) return true;
  return rules.loopback && is_loopback(visitor.host) && is_own(visitor);
}

/// From the system's source of randomness: a token must not be guessable.
std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw SetupError(fmt::format("no random numbers for a token: {}", std::generic_category().message(errno)));
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace murosimf::web
