#include "murosimf/web/page.h"

namespace murosimf::web {

std::string_view compressed_page() { return {}; }

}  // namespace murosimf::web
