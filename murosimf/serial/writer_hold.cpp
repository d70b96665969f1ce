#include "murosimf/serial/writer_hold.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "murosimf/serial/quiet_thread.h"
#include "murosimf/serial/terminal_drain.h"

namespace murosimf::serial {
namespace {

/// Processors that this process may run on.
std::vector<int> processors_here() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return {};
  std::vector<int> processors;
  for (int i = 0; i < CPU_SETSIZE; ++i) {
    if (CPU_ISSET(i, &set)) processors.push_back(i);
  }
  return processors;
}

void stay_on(int processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(processor, &set);
  pthread_setaffinity_np(pthread_self(), sizeof set, &set);
}

/// Raises the priority of this thread above ordinary ones, where permitted.
void go_first() {
  int policy = 0;
  sched_param priority{};
  if (pthread_getschedparam(pthread_self(), &policy, &priority) != 0 || policy != SCHED_OTHER) return;
  priority.sched_priority = sched_get_priority_min(SCHED_FIFO);
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

}  // namespace

/// One for all terminals of the process: its threads occupy every processor.
std::shared_ptr<WriterHold> WriterHold::shared() {
  static std::mutex mutex;
  static std::weak_ptr<WriterHold> existing;
  const std::scoped_lock lock(mutex);
  std::shared_ptr<WriterHold> hold = existing.lock();
  if (!hold) existing = hold = std::shared_ptr<WriterHold>(new WriterHold);
  return hold;
}

WriterHold::WriterHold() : stop_(eventfd(0, EFD_CLOEXEC)) {
  const std::vector<int> numbers = processors_here();
  if (stop_ < 0 || numbers.size() > most_processors) return;
  for (const int number : numbers) {
    auto processor = std::make_unique<Processor>();
    processor->number = number;
    processor->events = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (processor->events < 0) continue;
    processors_.push_back(std::move(processor));
  }
  for (const auto& processor : processors_) {
    processor->thread = quiet_thread([this, at = processor.get()] { look_after(*at); });
  }
}

WriterHold::~WriterHold() {
  const std::uint64_t one = 1;
  if (stop_ >= 0) {
    while (write(stop_, &one, sizeof one) < 0 && errno == EINTR) {
    }
  }
  for (const auto& processor : processors_) {
    processor->thread.join();
    close(processor->events);
  }
  if (stop_ >= 0) close(stop_);
}

void WriterHold::add(const std::string& terminal, TerminalDrain& drain) {
  for (const auto& processor : processors_) {
    const std::scoped_lock lock(processor->mutex);
    const int watch = inotify_add_watch(processor->events, terminal.c_str(), IN_MODIFY);
    if (watch >= 0) processor->drains[watch] = {&drain, drain.arrived(), false};
  }
}

void WriterHold::remove(const TerminalDrain& drain) {
  for (const auto& processor : processors_) {
    const std::scoped_lock lock(processor->mutex);
    const auto found =
        std::ranges::find_if(processor->drains, [&](const auto& entry) { return entry.second.drain == &drain; });
    if (found == processor->drains.end()) continue;
    inotify_rm_watch(processor->events, found->first);
    processor->drains.erase(found);
  }
}

/// A watch wakes this thread as soon as a client writes; it runs before the client on the same processor.
void WriterHold::look_after(Processor& processor) const {
  stay_on(processor.number);
  go_first();
  std::array<pollfd, 2> files{pollfd{stop_, POLLIN, 0}, pollfd{processor.events, POLLIN, 0}};
  for (;;) {
    if (poll(files.data(), files.size(), -1) < 0 && errno != EINTR) return;
    if ((files[0].revents & POLLIN) != 0) return;
    if ((files[1].revents & POLLIN) != 0) hold(processor);
  }
}

void WriterHold::hold(Processor& processor) {
  const auto end = std::chrono::steady_clock::now() + longest_hold;
  alignas(inotify_event) std::array<char, 4096> events{};
  const ssize_t size = read(processor.events, events.data(), events.size());
  const std::scoped_lock lock(processor.mutex);
  for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(inotify_event)) <= size;) {
    inotify_event event{};
    // copied, since the buffer gives no alignment for the second event
    std::memcpy(&event, events.data() + at, sizeof event);
    at += static_cast<ssize_t>(sizeof event + event.len);
    const auto found = processor.drains.find(event.wd);
    if (found == processor.drains.end()) continue;
    Watched& watched = found->second;
    const TerminalDrain& drain = *watched.drain;
    const std::uint64_t before = watched.late ? drain.arrived() : watched.arrived;
    while (drain.arrived() <= before && std::chrono::steady_clock::now() < end) {
    }
    watched.arrived = drain.arrived();
    watched.late = watched.arrived <= before;
  }
}

}  // namespace murosimf::serial
