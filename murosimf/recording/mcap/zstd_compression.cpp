// Compression in builds with Zstandard.
#include <fmt/format.h>
#include <zstd.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/compression.h"

namespace murosimf::recording {
namespace {

constexpr int level = 1;  // of 19: a game at 100 Hz takes a third of the time of level 3, for a tenth more bytes

}  // namespace

std::string_view usual_compression() noexcept { return "zstd"; }

std::string compress(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0) throw SetupError(fmt::format("zstd: {}", ZSTD_getErrorName(size)));
  packed.resize(size);
  return packed;
}

/// The size is known from the chunk: another one is damage.
std::string decompress(std::string_view method, std::string_view bytes, std::uint64_t size) {
  if (method.empty() && bytes.size() == size) return std::string(bytes);
  if (method != "zstd") {
    throw SetupError(method.empty() ? "its size is not the one that it says"
                                    : fmt::format("is compressed by '{}'; this program reads zstd", method));
  }
  const unsigned long long told = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (told != size && told != ZSTD_CONTENTSIZE_UNKNOWN) throw SetupError("its size is not the one that it says");
  std::string unpacked(size, '\0');
  const std::size_t found = ZSTD_decompress(unpacked.data(), unpacked.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(found) != 0) throw SetupError(fmt::format("zstd: {}", ZSTD_getErrorName(found)));
  if (found != size) throw SetupError("its size is not the one that it says");
  return unpacked;
}

}  // namespace murosimf::recording
