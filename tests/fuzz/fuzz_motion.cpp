// Key-frame motions.
#include "murosimf/scene_file/motion_file.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) { (void)scene_file::read_motion(file); });
  return 0;
}
