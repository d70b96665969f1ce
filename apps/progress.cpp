#include "apps/progress.h"

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "apps/error_output.h"

namespace murosimf::app {
namespace {

constexpr std::chrono::milliseconds between_drawings(100);
constexpr std::chrono::minutes between_lines(1);
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

std::string rate_of(double simulated, double elapsed) {
  if (elapsed < least_elapsed || simulated <= 0) return {};
  const double rate = simulated / elapsed;
  return fmt::format("{:.{}f} times real time", rate, rate < 10 ? 2 : rate < 100 ? 1 : 0);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), next_(terminal_ ? start_ : start_ + between_lines) {}

Progress::~Progress() { hide(); }

void Progress::hide() {
  if (terminal_) show_on_terminal("\r\033[K");
}

void Progress::show(double share, const std::string& words) {
  const auto now = WallClock::now();
  if (now < next_) return;
  next_ = terminal_ ? now + between_drawings : now + between_lines;
  share = std::clamp(share, 0.0, 1.0);
  const std::string left = time_left(share, std::chrono::duration<double>(now - start_).count());
  const std::string line = left.empty() ? words : words + ", " + left;
  if (terminal_) return show_on_terminal(fmt::format("\r\033[K{} {}", bar_of(share), line));
  say_note(line);
}

}  // namespace murosimf::app
