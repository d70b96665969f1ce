// What varies in a data set.
#include "murosimf/dataset/randomisation.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) { (void)dataset::read_randomisation(file); });
  return 0;
}
