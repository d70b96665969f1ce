/// terminal_drain.h - reads bytes from the simulation's end of a pseudo terminal as soon as programs have written them, independent
/// of the state of the simulation.
///
/// A real port has sent N bytes N * 10 bit times after they were written; flushing the output later loses nothing. A pseudo
/// terminal keeps them in the kernel until they are read, and a flush drops them. Two measures prevent that: a thread
/// waits for bytes and reads them, so that only the most recent ones are in the kernel; and programs that flush right after a
/// write are delayed until their bytes have passed (writer_hold.h).
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace murosimf::serial {

class TerminalDrain {
 public:
  /// `terminal` must be non-blocking and outlive this object.
  explicit TerminalDrain(int terminal);
  ~TerminalDrain();
  TerminalDrain(const TerminalDrain&) = delete;
  TerminalDrain& operator=(const TerminalDrain&) = delete;

  /// Appends bytes received at one rate [bit/s]: all, or up to a change of the rate. Never waits for programs.
  void take(std::vector<std::uint8_t>& bytes, double& rate) noexcept;
  /// Drops received bytes.
  void discard() noexcept;
  /// Number of bytes that have passed the kernel so far, read or ready to be read.
  [[nodiscard]] std::uint64_t arrived() const noexcept;

 private:
  void drain() noexcept;
  struct Piece {
    std::vector<std::uint8_t> bytes;
    double rate = 0;  // [bit/s]
  };
  void read_all() noexcept;
  void keep_reading() noexcept;

  int terminal_;
  int stop_;  // becomes readable when the thread is to end
  std::mutex mutex_;
  std::deque<Piece> pieces_;
  std::size_t waiting_ = 0;  // bytes in them
  std::atomic<std::uint64_t> moved_ = 0;
  std::thread thread_;
};

}  // namespace murosimf::serial
