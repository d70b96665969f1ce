// Scene files.
#include "murosimf/scene_file/scene_spec.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) { (void)scene_file::read_scene(file); });
  return 0;
}
