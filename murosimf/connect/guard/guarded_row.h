/// guarded_row.h - numbers or bytes that are shared with code that one does not trust, in pages of their own: who goes beyond their end
/// or writes to what is to be read only is stopped there, and the row is known by its address.
///
///     no access | head | canary, body, canary | no access
///
/// The head says what the body is (murosimf_signal); software may only read it. The body ends where its last page ends, but for what
/// keeps it at multiples of 64 bytes. What is for reading is mapped twice: the simulator writes to the one place what software reads at
/// the other.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace murosimf::connect {

class GuardedRow {
 public:
  enum class Use { read, write };
  /// What an access that was not allowed was: nothing of this row, before it, behind it, or writing to what is for reading.
  enum class Side { none, before, behind, inside };

  /// `name`, and `size` ("3 numbers"), are for messages; `bytes` of the body. Throws std::bad_alloc.
  GuardedRow(std::string name, std::string size, std::size_t head, std::size_t bytes, Use use);
  ~GuardedRow();
  GuardedRow(const GuardedRow&) = delete;
  GuardedRow& operator=(const GuardedRow&) = delete;

  // Where the simulator writes and reads, and where software does.
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
  /// The head does not change any more.
  void close_head() const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& size() const { return size_; }

  /// Where its canaries have been written to; none: they are as they were.
  [[nodiscard]] Side damage() const noexcept;
  /// What an access to this address, which has failed, was. May be called in signal handlers.
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
  /// The first that software has written beyond.
  [[nodiscard]] Found damaged() const noexcept;
  /// The one whose pages have this address. May be called in signal handlers.
  [[nodiscard]] Found at(const void* address) const noexcept;

 private:
  std::deque<GuardedRow> rows_;
};

}  // namespace murosimf::connect
