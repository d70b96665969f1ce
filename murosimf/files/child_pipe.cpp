#include "murosimf/files/child_pipe.h"

#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/files/spawn.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

[[noreturn]] void cannot_run(const std::string& program, const std::string& reason) {
  throw SetupError(fmt::format("cannot run '{}': {}", program, reason));
}

std::string last_line(std::FILE* file) {
  std::rewind(file);
  std::string line, last;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    if (c == '\n' || c == '\r') {
      if (!line.empty()) last = line;
      line.clear();
    } else {
      line += static_cast<char>(c);
    }
  }
  return line.empty() ? last : line;
}

}  // namespace

// a socket, not a pipe: writing to it when the program is gone is an error, not a signal
ChildPipe::ChildPipe(const std::vector<std::string>& arguments, const std::string& advice)
    : program_(arguments.at(0)), errors_(std::tmpfile(), std::fclose) {
  std::array<int, 2> ends{-1, -1};
  if (!errors_ || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    cannot_run(program_, std::generic_category().message(errno));
  }
  socket_ = ends[0];
  const int words = fileno(errors_.get()), error = spawn(arguments, {ends[1], words, words}, child_);
  close(ends[1]);
  if (error == 0) {
    running_.emplace(child_);
    return;
  }
  close(socket_);
  if (error == ENOENT || error == EACCES) cannot_run(program_, advice);
  cannot_run(program_, std::generic_category().message(error));
}

ChildPipe::~ChildPipe() {
  if (child_ < 0) return;
  kill(child_, SIGTERM);
  close(socket_);
  (void)wait();
}

/// Exit code of the program; -1 if a signal ended it.
int ChildPipe::wait() noexcept {
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  running_.reset();
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void ChildPipe::refuse() {
  const std::string words = last_line(errors_.get());
  throw SetupError(fmt::format("'{}' gave up{}", program_, words.empty() ? " without a word" : ": " + words));
}

void ChildPipe::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno != EINTR) {
      close(socket_);
      (void)wait();
      refuse();
    }
  }
}

void ChildPipe::finish() {
  close(socket_);
  if (wait() != 0) refuse();
}

}  // namespace murosimf::files
