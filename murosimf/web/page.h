/// page.h - the page of the browser (web/ at the root), as it was bundled when this program was built.
#pragma once

#include <string_view>

namespace murosimf::web {

/// One HTML file with all that it needs, compressed (gzip); empty if the program was built without npm.
[[nodiscard]] std::string_view compressed_page();

}  // namespace murosimf::web
