#include "murosimf/files/child_process.h"

#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/files/file_pointer.h"
#include "murosimf/files/leftovers.h"
#include "murosimf/files/spawn.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

[[noreturn]] void refuse(const std::string& program, int error) {
  throw SetupError(fmt::format("cannot run '{}': {}", program, std::generic_category().message(error)));
}

FilePtr temporary(const std::string& program) {
  FilePtr file(std::tmpfile());
  if (!file) refuse(program, errno);
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 65536> buffer{};
  std::rewind(file);
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), n);
  return text;
}

}  // namespace

std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments, const std::string& input) {
  const std::string& program = arguments.at(0);
  const FilePtr in = temporary(program), out = temporary(program), err = temporary(program);
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
    refuse(program, errno);
  }
  std::rewind(in.get());
  pid_t child = 0;
  if (const int error = spawn(arguments, {fileno(in.get()), fileno(out.get()), fileno(err.get())}, child); error != 0) {
    if (error == ENOENT || error == EACCES) return std::nullopt;
    refuse(program, error);
  }
  const Leftover running(child);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) refuse(program, errno);
  }
  return ProcessResult{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out.get()), contents(err.get())};
}

}  // namespace murosimf::files
