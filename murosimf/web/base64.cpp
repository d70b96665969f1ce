#include <cstdint>

#include "murosimf/math/assert.h"
#include "murosimf/web/gzip.h"

namespace murosimf::web {

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out.push_back(i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=');
    }
  }
  MUROSIMF_ASSERT(out.size() % 4 == 0);
  return out;
}

}  // namespace murosimf::web
