/// plugin.h - loads shared libraries that add to the registries at run time (plugin_interface.h).
#pragma once

#include <filesystem>

namespace murosimf::catalog {

/// Loads a plug-in and calls its registration; a second call with the same file does nothing. It is never unloaded, since entries and all
/// objects they create use its code. Throws SetupError, in one line that begins with the file: missing, no library, no plug-in,
/// made for another version, missing symbols, or the error of its own function. Entries added before its
/// function threw remain. Any thread may call; existing scenes do not change.
///
/// The program must export its symbols: CMake's property ENABLE_EXPORTS, as `murosimf` does.
void load_plugin(const std::filesystem::path& file);

}  // namespace murosimf::catalog
