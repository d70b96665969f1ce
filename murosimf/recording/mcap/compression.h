/// compression.h - chunks of recordings made smaller by Zstandard; a build without its library writes them as they are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace murosimf::recording {

/// What compress() makes, by MCAP's name: "zstd"; empty: nothing.
[[nodiscard]] std::string_view usual_compression() noexcept;

[[nodiscard]] std::string compress(std::string_view bytes);

/// `size` bytes that were compressed by the method of this name. Throws SetupError: unknown to this build, damaged, or not of this size.
[[nodiscard]] std::string decompress(std::string_view method, std::string_view bytes, std::uint64_t size);

}  // namespace murosimf::recording
