#include "murosimf/web/gzip.h"

#include <algorithm>
#include <limits>

#include <zlib.h>

#include "murosimf/model/error.h"

namespace murosimf::web {
namespace {

constexpr int gzip_format = 15 + 16;  // windowBits of zlib: the largest window, plus 16 for gzip's header
constexpr int best = 9, memory = 9;

using Work = int (*)(z_stream*, int);

/// Passes all bytes through `work`, until it reports the end.
std::string through(z_stream& stream, std::string_view bytes, Work work) {
  std::string out, part(1 << 16, '\0');
  int result = Z_OK;
  while (result == Z_OK) {
    if (stream.avail_in == 0) {
      const std::size_t size = std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib only reads there
      stream.avail_in = static_cast<uInt>(size);
      bytes.remove_prefix(size);
    }
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    result = work(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    out.append(part, 0, part.size() - stream.avail_out);
    // Z_BUF_ERROR with a full output buffer is no error: the next round provides room
    const bool waits_for_room = result == Z_BUF_ERROR && stream.avail_out == 0;
    if (waits_for_room) result = Z_OK;
  }
  if (result != Z_STREAM_END) throw SetupError("compressed bytes are damaged");
  return out;
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, best, Z_DEFLATED, gzip_format, memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw SetupError("no memory to compress");
  }
  const std::string out = through(stream, bytes, deflate);
  deflateEnd(&stream);
  return out;
}

std::string gunzip(std::string_view bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_format) != Z_OK) throw SetupError("no memory to unpack");
  struct End {
    z_stream& stream;
    ~End() { inflateEnd(&stream); }
  } end{stream};
  return through(stream, bytes, inflate);
}

}  // namespace murosimf::web
