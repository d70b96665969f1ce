#include "murosimf/network/reception.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace murosimf::network {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr auto longest_pause = 500ms;      // between checks of limits
constexpr auto out_of_descriptors = 50ms;  // until accepting is tried again

}  // namespace

Reception::Reception(const ReceptionOptions& options, Door door)
    : options_(options),
      door_(std::move(door)),
      listener_(Socket::listen(options.address)),
      wake_(::eventfd(0, EFD_CLOEXEC)) {
  if (wake_ < 0) throw NetworkError("too many open files");
  thread_ = std::thread([this] { receive_all(); });
}

Reception::~Reception() {
  ends_ = true;
  (void)::eventfd_write(wake_, 1);
  thread_.join();
  ::close(wake_);
}

/// Accepts all waiting connections. If there are too many, the one that has waited longest is rejected.
void Reception::accept_all(WallTime now) {
  for (;;) {
    Socket socket = listener_.accept();
    if (!socket.is_open()) {
      // Without descriptors the connection stays in the queue, and poll() returns at once.
      if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(out_of_descriptors);
      return;
    }
    std::string address = to_text(socket.peer_address());
    const auto limit =
        std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(options_.hello_limit));
    if (strangers_.size() >= most_strangers) {
      door_.turn_away(strangers_.front().caller, "too many clients connect without a greeting");
      strangers_.pop_front();
    }
    strangers_.push_back({{{std::move(socket), options_.longest}, std::move(address)}, now + limit});
  }
}

/// Whether the caller is finished: admitted or rejected.
bool Reception::inspect(Stranger& stranger, WallTime now) const {
  try {
    const auto message = stranger.caller.connection.receive();
    if (!message && now < stranger.end) return false;
    if (!message) throw NetworkError("has sent no greeting in time");
    door_.admit(stranger.caller, *message);
  } catch (const NetworkError& error) {
    door_.turn_away(stranger.caller, fmt::format("it {}", error.what()));
  }
  return true;
}

void Reception::receive_all() {
  std::vector<pollfd> asked;
  while (!ends_) {
    // In this order: the event that ends the thread, the listener, the callers.
    asked.assign({{wake_, POLLIN, 0}, {listener_.number(), POLLIN, 0}});
    for (const Stranger& stranger : strangers_) {
      asked.push_back({stranger.caller.connection.socket().number(), POLLIN, 0});
    }
    (void)::poll(asked.data(), asked.size(), strangers_.empty() ? -1 : static_cast<int>(longest_pause / 1ms));
    const WallTime now = WallClock::now();
    // Callers first: accept_all() may remove one of them.
    strangers_.remove_if([&](Stranger& stranger) { return inspect(stranger, now); });
    if (asked[1].revents != 0) accept_all(now);
  }
}

}  // namespace murosimf::network
