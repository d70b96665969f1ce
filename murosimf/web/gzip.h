/// gzip.h - compression in the format of browsers (RFC 1952), and binary data as text (base64, RFC 4648).
#pragma once

#include <string>
#include <string_view>

namespace murosimf::web {

// Throw SetupError if this build has no zlib, or for damaged bytes.
[[nodiscard]] std::string gzip(std::string_view bytes);
[[nodiscard]] std::string gunzip(std::string_view bytes);

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace murosimf::web
