#include "murosimf/serial/terminal_drain.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/serial/line_rate.h"
#include "murosimf/serial/quiet_thread.h"

namespace murosimf::serial {
namespace {

constexpr std::size_t most_waiting = 1 << 16;  // [byte] limits memory; beyond it programs wait, as for a slower port

}  // namespace

TerminalDrain::TerminalDrain(int terminal) : terminal_(terminal), stop_(eventfd(0, EFD_CLOEXEC)) {
  if (stop_ < 0) throw SetupError("no file descriptor is left for a serial line");
  thread_ = quiet_thread([this] { keep_reading(); });
}

/// The event wakes the thread from its wait.
TerminalDrain::~TerminalDrain() {
  const std::uint64_t one = 1;
  while (write(stop_, &one, sizeof one) < 0 && errno == EINTR) {
  }
  thread_.join();
  close(stop_);
}

void TerminalDrain::read_all() noexcept {
  std::array<std::uint8_t, 4096> some{};
  while (waiting_ < most_waiting) {
    const ssize_t count = read(terminal_, some.data(), some.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    const double rate = line_rate(terminal_);
    // the rate is read after the bytes: a program sets it before it writes
    if (pieces_.empty() || pieces_.back().rate != rate) pieces_.push_back({{}, rate});
    std::vector<std::uint8_t>& bytes = pieces_.back().bytes;
    bytes.insert(bytes.end(), some.data(), some.data() + count);
    waiting_ += static_cast<std::size_t>(count);
    moved_ += static_cast<std::uint64_t>(count);
  }
}

void TerminalDrain::drain() noexcept {
  const std::scoped_lock lock(mutex_);
  read_all();
}

void TerminalDrain::take(std::vector<std::uint8_t>& bytes, double& rate) noexcept {
  const std::scoped_lock lock(mutex_);
  read_all();  // includes bytes that the thread has not read yet
  if (pieces_.empty()) return;
  Piece& first = pieces_.front();
  bytes.insert(bytes.end(), first.bytes.begin(), first.bytes.end());
  rate = first.rate;
  MUROSIMF_ASSERT(waiting_ >= first.bytes.size());
  waiting_ -= first.bytes.size();
  pieces_.pop_front();
}

void TerminalDrain::discard() noexcept {
  const std::scoped_lock lock(mutex_);
  read_all();
  pieces_.clear();
  waiting_ = 0;
}

std::uint64_t TerminalDrain::arrived() const noexcept {
  int ready = 0;
  if (ioctl(terminal_, FIONREAD, &ready) != 0 || ready < 0) ready = 0;
  return moved_.load(std::memory_order_relaxed) + static_cast<std::uint64_t>(ready);
}

/// Bytes may stay in the kernel for a moment: there is room for 4 kB, and no flush reaches them there. Hence one read per pause.
void TerminalDrain::keep_reading() noexcept {
  constexpr int pause = 1;  // [ms]
  std::array<pollfd, 2> files{pollfd{stop_, POLLIN, 0}, pollfd{terminal_, POLLIN, 0}};
  for (bool wait = true;; wait = !wait) {
    const int ready = poll(files.data(), wait ? 2 : 1, wait ? -1 : pause);
    if (ready < 0 && errno != EINTR) return;
    if ((files[0].revents & POLLIN) != 0) return;
    if (!wait) drain();
  }
}

}  // namespace murosimf::serial
