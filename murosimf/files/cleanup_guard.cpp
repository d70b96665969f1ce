#include "murosimf/files/cleanup_guard.h"

#include <array>
#include <climits>
#include <csignal>
#include <cstring>

#include <unistd.h>

#include "murosimf/math/assert.h"

namespace murosimf::files {
namespace {

// Places are claimed without locks: run_cleanup() may interrupt any thread at any instruction.
enum CleanupState : int { free_place, being_noted, noted_file, noted_child };

struct CleanupPlace {
  std::atomic<int> state{free_place};
  pid_t child = -1;
  std::array<char, PATH_MAX> file{};
};

std::array<CleanupPlace, 32> cleanup_places;

CleanupPlace* claim_place() noexcept {
  for (CleanupPlace& place : cleanup_places) {
    int expected = free_place;
    if (place.state.compare_exchange_strong(expected, being_noted)) return &place;
  }
  return nullptr;
}

}  // namespace

CleanupGuard::CleanupGuard(const std::filesystem::path& file) noexcept {
  CleanupPlace* place = file.native().size() < PATH_MAX ? claim_place() : nullptr;
  if (!place) return;
  // The state comes last: a handler in between sees no half-written name.
  std::memcpy(place->file.data(), file.c_str(), file.native().size() + 1);
  state_ = &place->state;
  *state_ = noted_file;
}

CleanupGuard::CleanupGuard(pid_t child) noexcept {
  MUROSIMF_ASSERT(child > 0);  // kill() of 0 or -1 would end other processes, too
  CleanupPlace* place = claim_place();
  if (!place) return;
  place->child = child;
  state_ = &place->state;
  *state_ = noted_child;
}

CleanupGuard::~CleanupGuard() {
  MUROSIMF_ASSERT(!state_ || *state_ == noted_file || *state_ == noted_child);
  if (state_) *state_ = free_place;
}

// Children first: they may be writing the files.
void run_cleanup() noexcept {
  for (const CleanupPlace& place : cleanup_places) {
    if (place.state == noted_child) (void)kill(place.child, SIGKILL);
  }
  for (const CleanupPlace& place : cleanup_places) {
    if (place.state == noted_file) (void)unlink(place.file.data());
  }
}

}  // namespace murosimf::files
