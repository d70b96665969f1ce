/// forks.h - a child process that was forked has none of the threads of its parent; what had some is of no use there.
#pragma once

namespace murosimf::python {

/// How often the process was forked on the way from the first one to this one.
[[nodiscard]] unsigned forks() noexcept;
void count_forks();

/// Throws Error if the process was forked after `born`, the number of forks at which `what` was made.
void check_not_forked(unsigned born, const char* what);

}  // namespace murosimf::python
