/// page.h - the page for browsers (web/ at the root), as bundled when this program was built.
#pragma once

#include <string_view>

namespace murosimf::web {

/// One self-contained HTML file, compressed (gzip); empty if the program was built without npm.
[[nodiscard]] std::string_view compressed_page();

}  // namespace murosimf::web
