/// file_lock.h - files that grow for a long time are locked by their writer, so that no other run writes to them.
///
/// The lock is advisory, ends with the process in any case, and reports its process to others. On file systems without locks
/// there is none.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Locks an open descriptor with write access, while it is open. False: another process holds the lock.
[[nodiscard]] bool lock_file(int descriptor) noexcept;

/// "process 4711" that holds the lock of a file, "another run" if the system does not report it; empty: the file is not locked, or missing.
[[nodiscard]] std::string who_writes(const std::filesystem::path& file);

}  // namespace murosimf::files
