/// writer_hold.h - delays programs that have written to a pseudo terminal until their bytes have passed the kernel.
///
/// Linux passes bytes written to a pseudo terminal on in a kernel thread, some microseconds later; a program that flushes its
/// output right after a write (tcflush, TCOFLUSH) can be faster, and the kernel then drops the bytes. Therefore one thread for
/// each processor is woken by the write itself (inotify) and occupies the writer's processor for the moment that the kernel
/// needs, at most longest_hold. With real-time priority (root, CAP_SYS_NICE or RLIMIT_RTPRIO) that is nearly always
/// soon enough, without it only if the scheduler happens to allow it. On machines with more than most_processors no thread is used:
/// the kernel finds an idle processor there.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace murosimf::serial {

class TerminalDrain;

class WriterHold {
 public:
  static constexpr std::chrono::microseconds longest_hold{100};
  static constexpr std::size_t most_processors = 8;

  /// The instance of this process; it lives as long as it is used.
  [[nodiscard]] static std::shared_ptr<WriterHold> shared();

  ~WriterHold();
  WriterHold(const WriterHold&) = delete;
  WriterHold& operator=(const WriterHold&) = delete;

  /// Programs that write to the terminal of that name ("/dev/pts/3") are delayed from now on.
  void add(const std::string& terminal, TerminalDrain& drain);
  /// Ends that; the drain is no longer used afterwards.
  void remove(const TerminalDrain& drain);

 private:
  WriterHold();

  struct Watched {
    TerminalDrain* drain = nullptr;
    std::uint64_t arrived = 0;  // bytes counted after the last hold
    bool late = false;          // the last hold ended before its bytes arrived
  };
  struct Processor {
    int number = 0;
    int events = -1;                // of inotify
    std::mutex mutex;               // of the map
    std::map<int, Watched> drains;  // by watch
    std::thread thread;
  };
  void look_after(Processor& processor) const;
  static void hold(Processor& processor);

  int stop_;
  std::vector<std::unique_ptr<Processor>> processors_;
};

}  // namespace murosimf::serial
