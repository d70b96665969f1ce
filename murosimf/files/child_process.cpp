#include "murosimf/files/child_process.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

[[noreturn]] void cannot_run(const std::string& program, const std::string& reason) {
  throw SetupError(fmt::format("cannot run '{}': {}", program, reason));
}

[[noreturn]] void cannot_run(const std::string& program, int error) {
  cannot_run(program, std::generic_category().message(error));
}

/// Starts a program; `streams` become its standard input, output and errors. Returns 0, or errno of what failed.
int spawn(const std::vector<std::string>& arguments, const std::array<int, 3>& streams, pid_t& child) {
  MUROSIMF_ASSERT(!arguments.empty());
  MUROSIMF_ASSERT(std::ranges::all_of(streams, [](int stream) { return stream >= 0; }));
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int i = 0; i < 3; ++i) posix_spawn_file_actions_adddup2(&actions, streams[i], i);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // Its own process group: Ctrl-C in the terminal must not end it before this program decides to.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
  MUROSIMF_ASSERT(error != 0 || child > 0);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

bool is_missing(int error) { return error == ENOENT || error == EACCES; }

/// Exit code from the status of waitpid; -1 if a signal ended the program.
int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

FilePtr temporary(const std::string& program) {
  FilePtr file(std::tmpfile());
  if (!file) cannot_run(program, errno);
  return file;
}

std::string contents(std::FILE* file) {
  MUROSIMF_ASSERT(file != nullptr);
  std::string text;
  std::array<char, 65536> buffer{};
  std::rewind(file);
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), n);
  return text;
}

/// The last line that is not empty.
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

std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments, const std::string& input) {
  const std::string& program = arguments.at(0);
  // Files, not pipes: a program that writes much before it reads all would block both sides.
  const FilePtr in = temporary(program), out = temporary(program), err = temporary(program);
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
    cannot_run(program, errno);
  }
  std::rewind(in.get());
  pid_t child = 0;
  if (const int error = spawn(arguments, {fileno(in.get()), fileno(out.get()), fileno(err.get())}, child); error != 0) {
    if (is_missing(error)) return std::nullopt;
    cannot_run(program, error);
  }
  const CleanupGuard running(child);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) cannot_run(program, errno);
  }
  return ProcessResult{exit_code(status), contents(out.get()), contents(err.get())};
}

// A socket, not a pipe: writing to it after the program has ended is an error, not a signal.
ChildPipe::ChildPipe(const std::vector<std::string>& arguments, const std::string& advice)
    : program_(arguments.at(0)), errors_(temporary(program_)) {
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) cannot_run(program_, errno);
  socket_ = ends[0];
  const int words = fileno(errors_.get()), error = spawn(arguments, {ends[1], words, words}, child_);
  close(ends[1]);  // only the program holds this end now, so that its exit is noticed
  if (error == 0) {
    running_.emplace(child_);
    return;
  }
  close(socket_);
  if (is_missing(error)) cannot_run(program_, advice);
  cannot_run(program_, error);
}

ChildPipe::~ChildPipe() {
  if (child_ < 0) return;
  kill(child_, SIGTERM);
  close(socket_);
  (void)wait();
}

/// Waits for the end of the program and returns its exit code.
int ChildPipe::wait() noexcept {
  MUROSIMF_ASSERT(child_ > 0);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  running_.reset();
  child_ = -1;
  return exit_code(status);
}

void ChildPipe::refuse() {
  const std::string words = last_line(errors_.get());
  throw SetupError(fmt::format("'{}' gave up{}", program_, words.empty() ? " without a word" : ": " + words));
}

void ChildPipe::write(std::span<const std::byte> bytes) {
  MUROSIMF_ASSERT(socket_ >= 0 && child_ > 0);
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

std::string ChildPipe::finish() {
  MUROSIMF_ASSERT(child_ > 0);
  close(socket_);
  if (wait() != 0) refuse();
  return last_line(errors_.get());
}

}  // namespace murosimf::files
