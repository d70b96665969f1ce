/// writer_hold.h - keeps programs that have written to a pseudo terminal from running on until their bytes have come through.
///
/// Linux hands what is written to a pseudo terminal over in a thread of the kernel, some microseconds later; a program that flushes its
/// output right after a write (tcflush, TCOFLUSH) can be faster, and the kernel then drops the bytes. So there is one thread for
/// each processor, which the write itself wakes (inotify), and which takes the writer's processor for the moment that the kernel
/// needs, at most longest_hold. With real-time priority (root, CAP_SYS_NICE or RLIMIT_RTPRIO) that is nearly always
/// soon enough, without it only where the scheduler agrees. On machines with more than most_processors nobody is held:
/// the kernel finds an idle one there.
#pragma once

#include <chrono>
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

  /// That of this process; it lives as long as anybody has it.
  [[nodiscard]] static std::shared_ptr<WriterHold> shared();

  ~WriterHold();
  WriterHold(const WriterHold&) = delete;
  WriterHold& operator=(const WriterHold&) = delete;

  /// From now on those who write to the terminal of that name ("/dev/pts/3") are held.
  void add(const std::string& terminal, TerminalDrain& drain);
  /// From now on not; nobody uses the drain any more.
  void remove(const TerminalDrain& drain);

 private:
  WriterHold();

  struct Watched {
    TerminalDrain* drain = nullptr;
    std::uint64_t arrived = 0;  // of it, after the last hold
    bool late = false;          // that one has ended before its bytes came
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
