// Robot files of MuJoCo.
#include "murosimf/io/mjcf_reader.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  for (const bool lenient : {false, true}) {
    fuzz::feed(data, size, ".xml", [&](const auto& file) { (void)io::read_mjcf(file, {.lenient = lenient}); });
  }
  return 0;
}
