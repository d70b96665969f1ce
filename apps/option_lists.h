/// option_lists.h - options of everything in the registries, as `murosimf list options` prints them.
#pragma once

#include <string>

namespace murosimf::app {

/// A table each of controllers, sensors and so on; with what plug-ins have added.
[[nodiscard]] std::string option_lists();

}  // namespace murosimf::app
