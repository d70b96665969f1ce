#include "murosimf/model/error.h"
#include "murosimf/web/gzip.h"

namespace murosimf::web {

std::string gzip(std::string_view) {
  throw SetupError("this program was built without zlib (Debian and Ubuntu: zlib1g-dev)");
}
std::string gunzip(std::string_view bytes) { return gzip(bytes); }

}  // namespace murosimf::web
