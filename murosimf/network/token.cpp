#include "murosimf/network/token.h"

#include <sys/random.h>

#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace murosimf::network {

std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_token(std::string_view offered, std::string_view token) noexcept {
  if (offered.size() != token.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < token.size(); ++i) difference |= static_cast<unsigned char>(offered[i] ^ token[i]);
  return difference == 0;
}

}  // namespace murosimf::network
