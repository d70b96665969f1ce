/// driver_memory.h - checks whether a limit of the address space (ulimit -v) leaves what an OpenGL driver needs.
///
/// Drivers abort the program where memory ends; so this is checked before they are loaded. Measured with Mesa 22.3
/// (llvmpipe, LLVM 15) on 2 cores: 'render' takes 760 MB of addresses, most of it never used: code of the driver, and for each of its
/// threads a stack and a reserve of the allocator.
#pragma once

namespace murosimf::render {

/// Throws SetupError if that much is not available.
void check_driver_memory();

}  // namespace murosimf::render
