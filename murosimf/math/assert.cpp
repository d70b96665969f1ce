#include "murosimf/math/assert.h"

#include <cstdio>
#include <cstdlib>

namespace murosimf {

void assertion_failed(const char* condition, const char* file, int line, const char* function) noexcept {
  // stdio and no formatting library: it must work whatever state the program is in
  std::fprintf(stderr, "%s:%d: %s: assertion '%s' failed\n", file, line, function, condition);
  std::abort();
}

}  // namespace murosimf
