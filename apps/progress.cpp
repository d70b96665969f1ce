#include "apps/progress.h"

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "apps/last_words.h"

namespace murosimf::app {
namespace {

constexpr double least_share = 0.01, least_elapsed = 0.5;  // [s]; before, an estimate would be a guess

std::string bar_of(double share) {
  constexpr int width = 40;
  const int done = static_cast<int>(share * width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", done, "", width - done);
}

}  // namespace

std::string time_left(double share, double elapsed) {
  if (share < least_share || elapsed < least_elapsed) return {};
  const auto seconds = static_cast<long long>(elapsed * (1 - share) / share + 0.5);
  if (seconds < 60) return fmt::format("{} s left", seconds);
  if (seconds < 3600) return fmt::format("{} min {:02} s left", seconds / 60, seconds % 60);
  return fmt::format("{} h {:02} min left", seconds / 3600, seconds / 60 % 60);
}

Progress::Progress() : shown_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { hide(); }

void Progress::hide() {
  if (shown_) show_on_terminal("\r\033[K");
}

void Progress::show(double share, const std::string& words) {
  const auto now = WallClock::now();
  if (!shown_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  share = std::clamp(share, 0.0, 1.0);
  const std::string left = time_left(share, std::chrono::duration<double>(now - start_).count());
  show_on_terminal(fmt::format("\r\033[K{} {}{}{}", bar_of(share), words, left.empty() ? "" : ", ", left));
}

}  // namespace murosimf::app
