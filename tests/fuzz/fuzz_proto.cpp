// Robot files of Webots.
#include "tests/fuzz/fuzz_robot.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  murosimf::fuzz::feed_robot(data, size, ".proto");
  return 0;
}
