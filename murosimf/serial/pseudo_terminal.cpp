#include "murosimf/serial/pseudo_terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/serial/line_rate.h"
#include "murosimf/serial/terminal_drain.h"
#include "murosimf/serial/writer_hold.h"

namespace murosimf::serial {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what) {
  throw SetupError(fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

/// Otherwise the terminal would echo what the robot sends, and change line ends, until a program sets it to raw mode.
bool make_raw(const char* name, double rate) {
  const int file = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return false;
  termios settings{};
  bool done = tcgetattr(file, &settings) == 0;
  cfmakeraw(&settings);
  done = done && tcsetattr(file, TCSANOW, &settings) == 0 && set_line_rate(file, rate);
  close(file);
  return done;
}

bool is_old_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(fs::symlink_status(path, error)) &&
         fs::read_symlink(path, error).string().starts_with("/dev/pts/");
}

}  // namespace

PseudoTerminal::PseudoTerminal(double rate)
    : file_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)), rate_(rate) {
  if (file_ < 0) fail("no pseudo terminal for a serial line");
  std::array<char, 128> name{};
  if (grantpt(file_) != 0 || unlockpt(file_) != 0 || ptsname_r(file_, name.data(), name.size()) != 0 ||
      !make_raw(name.data(), rate)) {
    // close may change errno, which the message needs
    const int error = errno;
    close(file_);
    errno = error;
    fail("a pseudo terminal for a serial line cannot be opened");
  }
  name_ = name.data();
  drain_ = std::make_unique<TerminalDrain>(file_);
  hold_ = WriterHold::shared();
  hold_->add(name_, *drain_);
}

PseudoTerminal::~PseudoTerminal() {
  hold_->remove(*drain_);
  drain_.reset();
  close(file_);
}

bool PseudoTerminal::is_open() const noexcept {
  pollfd state{.fd = file_, .events = 0, .revents = 0};
  return poll(&state, 1, 0) >= 0 && (state.revents & (POLLHUP | POLLERR)) == 0;
}

void PseudoTerminal::receive(std::vector<std::uint8_t>& bytes) noexcept { drain_->take(bytes, rate_); }

/// Never blocks: a client that does not read loses bytes, as on a real line.
std::size_t PseudoTerminal::send(std::span<const std::uint8_t> bytes) noexcept {
  MUROSIMF_ASSERT(file_ >= 0);
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = write(file_, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    sent += static_cast<std::size_t>(count);
  }
  return sent;
}

/// Bytes waiting at the reader's end can be flushed at that end only, hence it is opened here.
void PseudoTerminal::discard() noexcept {
  const int file = open(name_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  tcflush(file_, TCIOFLUSH);
  tcflush(file, TCIOFLUSH);
  close(file);
  drain_->discard();
}

void check_link_place(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.parent_path();
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) throw SetupError(fmt::format("'{}' is no folder", folder.string()));
  if (fs::exists(fs::symlink_status(path, error)) && !is_old_link(path)) {
    throw SetupError(fmt::format("'{}' is there already, and no link to a terminal", path.string()));
  }
}

TerminalLink::TerminalLink(fs::path path, std::string terminal)
    : path_(std::move(path)), terminal_(std::move(terminal)) {
  check_link_place(path_);
  std::error_code error;
  // exists() follows the link, and the terminal it led to may be gone: the link itself is tested
  if (is_old_link(path_)) fs::remove(path_, error);
  fs::create_symlink(terminal_, path_, error);
  if (error) throw SetupError(fmt::format("no link '{}' can be made: {}", path_.string(), error.message()));
}

TerminalLink::~TerminalLink() {
  std::error_code error;
  if (fs::read_symlink(path_, error) == terminal_) fs::remove(path_, error);
}

}  // namespace murosimf::serial
