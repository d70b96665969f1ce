// Replacement for compression in builds without Zstandard.
#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/compression.h"

namespace murosimf::recording {

std::string_view usual_compression() noexcept { return {}; }

std::string compress(std::string_view bytes) { return std::string(bytes); }

std::string decompress(std::string_view method, std::string_view bytes, std::uint64_t size) {
  if (!method.empty()) {
    throw SetupError(
        fmt::format("is compressed by '{}', and this program was built without zstd (libzstd-dev)", method));
  }
  if (bytes.size() != size) throw SetupError("its size is not the one that it says");
  return std::string(bytes);
}

}  // namespace murosimf::recording
