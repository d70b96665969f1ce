/// terminal_drain.h - takes bytes from the simulation's end of a pseudo terminal as soon as programs have written them, whatever the
/// simulation does meanwhile.
///
/// A real port has sent N bytes N * 10 bit times after they were written; whoever flushes its output later loses nothing. A pseudo
/// terminal keeps them in the kernel until somebody reads, and a flush drops what is there. Two things are against that: a thread
/// waits for bytes and reads them, so that no more than a moment's are in the kernel; and programs that flush right after a
/// write are kept from running on until their bytes have come through (writer_hold.h).
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
  /// Of a terminal that does not block; it must live longer than this.
  explicit TerminalDrain(int terminal);
  ~TerminalDrain();
  TerminalDrain(const TerminalDrain&) = delete;
  TerminalDrain& operator=(const TerminalDrain&) = delete;

  /// Appends what has come at one rate [bit/s], all of it or up to where the rate has changed. Never waits for programs.
  void take(std::vector<std::uint8_t>& bytes, double& rate) noexcept;
  /// Forgets what has come.
  void discard() noexcept;
  /// How many bytes have come through the kernel so far, read or ready to be read.
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
