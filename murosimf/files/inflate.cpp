#include <zlib.h>

#include "murosimf/files/gray_png.h"

namespace murosimf::files {

std::optional<std::string> inflated(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf written = size;
  const int result = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &written,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (result != Z_OK || written != size) return std::nullopt;
  return bytes;
}

}  // namespace murosimf::files
