#include "murosimf/files/leftovers.h"

#include <array>
#include <climits>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace murosimf::files {
namespace {

enum LeftoverState : int { free_place, being_noted, noted_file, noted_child };

struct LeftoverPlace {
  std::atomic<int> state{free_place};
  pid_t child = -1;
  std::array<char, PATH_MAX> file{};
};

std::array<LeftoverPlace, 32> leftover_places;

LeftoverPlace* take_place() noexcept {
  for (LeftoverPlace& place : leftover_places) {
    int expected = free_place;
    if (place.state.compare_exchange_strong(expected, being_noted)) return &place;
  }
  return nullptr;
}

}  // namespace

Leftover::Leftover(const std::filesystem::path& file) noexcept {
  LeftoverPlace* place = file.native().size() < PATH_MAX ? take_place() : nullptr;
  if (!place) return;
  std::memcpy(place->file.data(), file.c_str(), file.native().size() + 1);
  state_ = &place->state;
  *state_ = noted_file;
}

Leftover::Leftover(pid_t child) noexcept {
  LeftoverPlace* place = take_place();
  if (!place) return;
  place->child = child;
  state_ = &place->state;
  *state_ = noted_child;
}

Leftover::~Leftover() {
  if (state_) *state_ = free_place;
}

// children first: they may be writing the files
void remove_leftovers() noexcept {
  for (const LeftoverPlace& place : leftover_places) {
    if (place.state == noted_child) (void)kill(place.child, SIGKILL);
  }
  for (const LeftoverPlace& place : leftover_places) {
    if (place.state == noted_file) (void)unlink(place.file.data());
  }
}

}  // namespace murosimf::files
