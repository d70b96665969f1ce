/// plugin.h - loads shared libraries that add to the registries while the program runs (plugin_interface.h).
#pragma once

#include <filesystem>

namespace murosimf::catalog {

/// Loads a plug-in and lets it register; a second call with the same file does nothing. It is never unloaded, since entries and all
/// that they make are its code. Throws SetupError, in one line that begins with the file: it is missing, no library, no plug-in,
/// made for another version, needs what this program does not have, or what its own function says. What it had added before its
/// function threw stays. Any thread may call; scenes that are built already do not change.
///
/// The program must export its symbols: CMake's property ENABLE_EXPORTS, as `murosimf` does.
void load_plugin(const std::filesystem::path& file);

}  // namespace murosimf::catalog
