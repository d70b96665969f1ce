// Key-frame motions.
#include "murosimf/robot/motion_file.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) { (void)robot::read_motion(file); });
  return 0;
}
