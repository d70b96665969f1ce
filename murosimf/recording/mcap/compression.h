/// compression.h - compression of chunks by Zstandard; a build without its library writes them uncompressed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace murosimf::recording {

/// Method of compress(), by MCAP's name: "zstd"; empty: none.
[[nodiscard]] std::string_view usual_compression() noexcept;

[[nodiscard]] std::string compress(std::string_view bytes);

/// Decompresses to `size` bytes by the method of this name. Throws SetupError: unknown to this build, damaged, or of another size.
[[nodiscard]] std::string decompress(std::string_view method, std::string_view bytes, std::uint64_t size);

}  // namespace murosimf::recording
