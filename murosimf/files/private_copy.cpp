#include "murosimf/files/private_copy.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_library_bytes = 1'000'000'000;

std::uint32_t next_number() {
  static std::atomic<std::uint32_t> count{0};
  return count++;
}

bool write_all(int descriptor, const std::string& bytes) {
  MUROSIMF_ASSERT(descriptor >= 0);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
    MUROSIMF_ASSERT(done == bytes.size());
  }
  return true;
}

/// Reads a structure of the file; false if it is not within it.
template <class T>
bool read_at(const std::string& bytes, std::uint64_t offset, T& structure) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) return false;
  std::memcpy(&structure, bytes.data() + offset, sizeof(T));
  return true;
}

}  // namespace

std::string read_library(const fs::path& file) { return read_input_file(file, most_library_bytes); }

bool is_whole_library(const std::string& bytes) {
  Elf64_Ehdr header{};
  // A beginning of the ELF mark is an ELF file that has just been created.
  if (bytes.size() < SELFMAG) return !bytes.empty() && bytes.compare(0, bytes.size(), ELFMAG, bytes.size()) != 0;
  if (bytes.compare(0, SELFMAG, ELFMAG) != 0) return bytes.find_first_not_of('\0') != std::string::npos;
  if (!read_at(bytes, 0, header)) return false;
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return true;
  // The table of sections is the last thing that linkers write.
  const std::uint64_t sections = header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize;
  if (sections > bytes.size()) return false;
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    if (!read_at(bytes, header.e_phoff + i * header.e_phentsize, segment)) return false;
    if (segment.p_type == PT_LOAD && segment.p_offset + segment.p_filesz > bytes.size()) return false;
  }
  return true;
}

/// The kernel grants a lease to read only if no program has the file open for writing; it is returned at once.
bool is_being_written(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  (void)::fcntl(descriptor, F_SETSIG, SIGURG);  // the signal of a program that opens it at this moment is ignored
  const bool taken = ::fcntl(descriptor, F_SETLEASE, F_RDLCK) == 0;
  const bool written = !taken && errno == EAGAIN;
  if (taken) (void)::fcntl(descriptor, F_SETLEASE, F_UNLCK);
  ::close(descriptor);
  return written;
}

PrivateCopy::PrivateCopy(const fs::path& file, const std::string& shown) {
  const std::string bytes = read_library(file);
  if (!is_whole_library(bytes)) {
    throw SetupError(fmt::format("{}: is not whole, {} bytes: is it being written? Try again", shown, bytes.size()));
  }
  if (write_beside(file, bytes) || write_to_memory(bytes)) return;
  const std::string reason = std::strerror(errno);
  throw SetupError(fmt::format("{}: cannot be copied, neither beside it nor to memory: {}", shown, reason));
}

bool PrivateCopy::write_beside(const fs::path& file, const std::string& bytes) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) return false;
  // Process and number: several runs, and several copies in one run, do not collide.
  path_ = real.parent_path() / fmt::format(".{}.murosimf-{}-{}", real.filename().string(), ::getpid(), next_number());
  const int descriptor = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0700);
  if (descriptor < 0) return false;
  beside_ = write_all(descriptor, bytes);
  if (::close(descriptor) != 0) beside_ = false;
  if (!beside_) ::unlink(path_.c_str());
  return beside_;
}

/// Descriptors are reused, and the loader identifies libraries by their names: so each name is unique, with the bits of a
/// number as "//" and "/.".
bool PrivateCopy::write_to_memory(const std::string& bytes) {
  descriptor_ = ::memfd_create("library", MFD_CLOEXEC);
  if (descriptor_ < 0 || !write_all(descriptor_, bytes)) return false;
  std::string name = "/proc/self/fd";
  const std::uint32_t number = next_number();
  for (int bit = 0; bit < 32; ++bit) name += (number >> bit & 1) != 0 ? "/." : "//";
  MUROSIMF_ASSERT(descriptor_ >= 0);
  path_ = fmt::format("{}/{}", name, descriptor_);
  return true;
}

PrivateCopy::~PrivateCopy() {
  if (beside_) ::unlink(path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace murosimf::files
