#include "murosimf/control_software/guard/guarded_row.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {
namespace {

constexpr std::size_t alignment = 64;  // [byte] vector registers, a cache line
constexpr std::byte canary{0xc5};

std::size_t page() {
  static const auto size = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return size;
}

std::size_t rounded_up(std::size_t bytes, std::size_t to) {
  MUROSIMF_ASSERT(to > 0);
  return (bytes + to - 1) / to * to;
}

/// Reserves inaccessible memory, with a page before and behind: an overrun by less than a page always faults.
std::byte* reserve(std::size_t bytes) {
  void* const memory =
      ::mmap(nullptr, bytes + 2 * page(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return static_cast<std::byte*>(memory) + page();
}

void release(std::byte* memory, std::size_t bytes) {
  if (memory) ::munmap(memory - page(), bytes + 2 * page());
}

/// Compares words of eight bytes; memcmp takes five times as long for so few.
bool only_canaries(const std::byte* first, const std::byte* last) {
  std::uint64_t found = 0, expected = 0;
  std::memset(&expected, static_cast<int>(canary), sizeof expected);
  std::uint64_t differences = 0;
  for (; last - first >= static_cast<std::ptrdiff_t>(sizeof found); first += sizeof found) {
    std::memcpy(&found, first, sizeof found);
    differences |= found ^ expected;
  }
  return differences == 0 && std::all_of(first, last, [](std::byte each) { return each == canary; });
}

}  // namespace

GuardedRow::GuardedRow(std::string name, std::string size, std::size_t head, std::size_t bytes, Use use)
    : name_(std::move(name)), size_(std::move(size)), bytes_(bytes), use_(use) {
  first_page_ = rounded_up(std::max<std::size_t>(head, 1), page());
  end_ = first_page_ + rounded_up(std::max<std::size_t>(bytes, 1), page());
  body_ = (end_ - bytes) / alignment * alignment;
  MUROSIMF_ASSERT(first_page_ >= head && body_ >= first_page_ && body_ + bytes <= end_);
  try {
    map();
  } catch (...) {
    release(shown_, end_);
    release(use == Use::read ? own_ : nullptr, end_);
    throw;
  }
  if (use == Use::read) return;
  std::fill(own_ + first_page_, own_ + body_, canary);
  std::fill(own_ + body_ + bytes_, own_ + end_, canary);
}

void GuardedRow::map() {
  shown_ = reserve(end_);
  if (use_ == Use::write) {
    own_ = shown_;
    if (::mprotect(own_, end_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
    return;
  }
  // one file, mapped twice: software gets the mapping without write access
  own_ = reserve(end_);
  const int file = ::memfd_create("murosimf_row", MFD_CLOEXEC);
  if (file < 0) throw std::bad_alloc();
  const bool mapped = ::ftruncate(file, static_cast<off_t>(end_)) == 0 &&
                      ::mmap(own_, end_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, 0) != MAP_FAILED &&
                      ::mmap(shown_, end_, PROT_READ, MAP_SHARED | MAP_FIXED, file, 0) != MAP_FAILED;
  ::close(file);
  if (!mapped) throw std::bad_alloc();
}

GuardedRow::~GuardedRow() {
  if (own_ != shown_) release(own_, end_);
  release(shown_, end_);
}

void GuardedRow::close_head() const { (void)::mprotect(shown_, first_page_, PROT_READ); }

/// Only one alignment before the body is checked: a write farther away has crossed these canaries as well.
GuardedRow::Side GuardedRow::damage() const noexcept {
  if (use_ == Use::read) return Side::none;
  const std::byte* const body = own_ + body_;
  if (!only_canaries(body + bytes_, own_ + end_)) return Side::behind;
  if (!only_canaries(body - std::min(alignment, body_ - first_page_), body)) return Side::before;
  return Side::none;
}

GuardedRow::Side GuardedRow::side_of(const void* address) const noexcept {
  const auto* const place = static_cast<const std::byte*>(address);
  if (place < shown_ - page() || place >= shown_ + end_ + page()) return Side::none;
  if (place >= shown_ + end_) return Side::behind;
  if (place < shown_ || (use_ == Use::write && place < shown_ + first_page_)) return Side::before;
  return Side::inside;
}

GuardedRows::Found GuardedRows::damaged() const noexcept {
  for (const GuardedRow& row : rows_) {
    if (const GuardedRow::Side side = row.damage(); side != GuardedRow::Side::none) return {&row, side};
  }
  return {};
}

GuardedRows::Found GuardedRows::at(const void* address) const noexcept {
  for (const GuardedRow& row : rows_) {
    if (const GuardedRow::Side side = row.side_of(address); side != GuardedRow::Side::none) return {&row, side};
  }
  return {};
}

}  // namespace murosimf::control_software
