// COLLADA files.
#include "tests/fuzz/fuzz_mesh.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  murosimf::fuzz::feed_mesh(data, size, ".dae");
  return 0;
}
