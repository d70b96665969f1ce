// share_waves.cpp - linked into every test: threads take part in each wave from the first one on, whether that pays or not, so that
// what differs or races with several threads shows.
#include <cstdlib>

namespace {
[[maybe_unused]] const int set_before_main = setenv("MUROSIMF_SHARE_WAVES", "always", 0);
}  // namespace
