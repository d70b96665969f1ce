#include "murosimf/model/error.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::supervise {

std::unique_ptr<Supervision> supervise(session::Session&, const SupervisionOptions&) {
  throw SetupError(
      "this program was built without Protobuf, so nothing can connect (Debian and Ubuntu: libprotobuf-dev, "
      "protobuf-compiler)");
}

}  // namespace murosimf::supervise
