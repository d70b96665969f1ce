// Tables of heights: pictures, arrays, CSV.
#include "murosimf/files/height_file.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  for (const char* extension : {".png", ".npy", ".csv"}) {
    fuzz::feed(data, size, extension, [](const auto& file) { (void)files::read_height_file(file); });
  }
  return 0;
}
