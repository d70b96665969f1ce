#include "murosimf/render/opengl/driver_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <thread>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

constexpr std::size_t megabyte = 1'000'000;
constexpr std::size_t driver_bytes = 700 * megabyte;
constexpr std::size_t bytes_of_thread = 80 * megabyte;  ///< 8 of stack, 64 of the allocator, and overhead
constexpr unsigned most_driver_threads = 16;            ///< of llvmpipe

std::size_t needed_bytes() {
  return driver_bytes + bytes_of_thread * std::clamp(std::thread::hardware_concurrency(), 1U, most_driver_threads);
}

/// True if so much address space is left. Reserves nothing.
bool can_have(std::size_t bytes) {
  MUROSIMF_ASSERT(bytes > 0);
  // PROT_NONE and NORESERVE: counts against the limit of addresses, but takes no memory.
  void* const place = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED) return false;
  munmap(place, bytes);
  return true;
}

}  // namespace

void check_driver_memory() {
  const std::size_t bytes = needed_bytes();
  if (can_have(bytes)) return;
  throw SetupError(
      fmt::format("no pictures by OpenGL: the driver takes up to {} MB of address space, more than the limit leaves; "
                  "raise it (ulimit -v)",
                  bytes / megabyte));
}

}  // namespace murosimf::render
