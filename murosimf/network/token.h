/// token.h - tokens that let a client in: drawn at the start of a server, compared when a client says hello.
#pragma once

#include <string>
#include <string_view>

namespace murosimf::network {

/// 128 bits of the system's source of randomness as 32 hexadecimal digits, so that a token cannot be guessed from the time of the start. Empty: the
/// system gives none.
[[nodiscard]] std::string new_token();

/// In a time that depends on the lengths alone, so that it does not reveal a prefix of the token.
[[nodiscard]] bool is_token(std::string_view offered, std::string_view token) noexcept;

}  // namespace murosimf::network
