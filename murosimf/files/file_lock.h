/// file_lock.h - files that grow for a long time are locked by who writes them, so that no other run takes them.
///
/// The lock is advisory, ends with the process however that ends, and names its process to others. On file systems without locks
/// there is none.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Of an open descriptor that may write; as long as it is open. False: another one has it.
[[nodiscard]] bool lock_file(int descriptor) noexcept;

/// "process 4711" that has the lock of a file, "another run" if the system does not tell; empty: nothing locks it, or it is not there.
[[nodiscard]] std::string who_writes(const std::filesystem::path& file);

}  // namespace murosimf::files
