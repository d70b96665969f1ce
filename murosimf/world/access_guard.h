/// access_guard.h - debug builds: a stepping algorithm looks up only columns that it has declared.
///
/// Taking a span is the declaration (setup.h), but a column can also be looked up by name while the waves run, and then
/// the scheduler would not know of the access. So each look-up asserts that the algorithm which this thread
/// steps has declared the column. Between steps, and in release builds, every access is allowed.
#pragma once

namespace murosimf {

class AccessSet;
class ColumnBase;

/// During its lifetime this thread steps the algorithm that has declared `access`.
class AccessGuard {
 public:
  explicit AccessGuard(const AccessSet& access) noexcept;
  ~AccessGuard();
  AccessGuard(const AccessGuard&) = delete;
  AccessGuard& operator=(const AccessGuard&) = delete;

 private:
  const AccessSet* before_;
};

/// True if no algorithm steps on this thread, if the one that does has declared the column, or if it claims its entity.
[[nodiscard]] bool may_read(const ColumnBase& column) noexcept;
/// The same, declared as written.
[[nodiscard]] bool may_write(const ColumnBase& column) noexcept;

}  // namespace murosimf
