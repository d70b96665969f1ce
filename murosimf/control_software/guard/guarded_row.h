/// guarded_row.h - numbers or bytes that are shared with untrusted code, in pages of their own: an access beyond their end,
/// or a write to read-only memory, faults at once, and the row is identified by the address.
///
///     no access | head | canary, body, canary | no access
///
/// The head describes the body (murosimf_signal); software may only read it. The body ends where its last page ends, except for
/// padding that aligns it to 64 bytes. Read-only memory is mapped twice: the simulator writes one mapping, software reads
/// the other.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace murosimf::control_software {

class GuardedRow {
 public:
  enum class Use { read, write };
  /// Kind of a forbidden access: nothing of this row, before it, behind it, or a write to read-only memory.
  enum class Side { none, before, behind, inside };

  /// `name`, and `size` ("3 numbers"), are for messages; `bytes` of the body. Throws std::bad_alloc.
  GuardedRow(std::string name, std::string size, std::size_t head, std::size_t bytes, Use use);
  ~GuardedRow();
  GuardedRow(const GuardedRow&) = delete;
  GuardedRow& operator=(const GuardedRow&) = delete;

  // Addresses for the simulator, and for software.
  template <class Head>
  [[nodiscard]] Head& head() const {
    return *reinterpret_cast<Head*>(own_);
  }
  template <class Head>
  [[nodiscard]] Head& shown_head() const {
    return *reinterpret_cast<Head*>(shown_);
  }
  template <class Number>
  [[nodiscard]] Number* body() const {
    return reinterpret_cast<Number*>(own_ + body_);
  }
  template <class Number>
  [[nodiscard]] Number* shown_body() const {
    return reinterpret_cast<Number*>(shown_ + body_);
  }
  /// Makes the head read-only.
  void close_head() const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& size() const { return size_; }

  /// Where its canaries have been overwritten; none: they are intact.
  [[nodiscard]] Side damage() const noexcept;
  /// Classifies a failed access to this address. May be called in signal handlers.
  [[nodiscard]] Side side_of(const void* address) const noexcept;

 private:
  void map();

  std::string name_, size_;
  std::size_t bytes_;           // of the body
  std::size_t body_ = 0;        // begins there
  std::size_t end_ = 0;         // of the pages
  std::size_t first_page_ = 0;  // of the body
  Use use_;
  std::byte* own_ = nullptr;    // head
  std::byte* shown_ = nullptr;  // the same of software
};

/// Those of one robot; they stay where they are.
class GuardedRows {
 public:
  GuardedRow& add(std::string name, std::string size, std::size_t head, std::size_t bytes, GuardedRow::Use use) {
    return rows_.emplace_back(std::move(name), std::move(size), head, bytes, use);
  }

  struct Found {
    const GuardedRow* row = nullptr;  ///< null: none
    GuardedRow::Side side = GuardedRow::Side::none;
  };
  /// The first row beyond whose bounds software has written.
  [[nodiscard]] Found damaged() const noexcept;
  /// The row whose pages contain this address. May be called in signal handlers.
  [[nodiscard]] Found at(const void* address) const noexcept;

 private:
  std::deque<GuardedRow> rows_;
};

}  // namespace murosimf::control_software
