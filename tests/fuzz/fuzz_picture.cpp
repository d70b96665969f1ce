// Pictures that robot files name: PNG and JPEG.
#include <fstream>
#include <iterator>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/render/picture_reading.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".picture", [](const auto& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const imaging::ColorImage picture = render::picture_of_file(bytes);
    if (picture.pixels().size() < 100'000) (void)imaging::mip_picture(picture);
  });
  return 0;
}
