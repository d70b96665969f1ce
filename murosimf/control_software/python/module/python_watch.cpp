#include "murosimf/control_software/python/module/python_watch.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>

namespace murosimf::control_software::python {
namespace {

std::atomic<bool> watching{false};  // in this process

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

}  // namespace

Watch::Watch(Object late, Object interrupted, bool (*asked)(), bool spare_main)
    : late_(std::move(late)), interrupted_(std::move(interrupted)), asked_(asked), spare_main_(spare_main) {}

Watch::Place& Watch::place() {
  thread_local Place* own = nullptr;
  if (own) return *own;
  const std::lock_guard lock(places_lock_);
  own = places_.emplace_back(std::make_unique<Place>()).get();
  own->thread = PyThread_get_thread_ident();
  own->main = ::gettid() == ::getpid();
  return *own;
}

void Watch::keep_watching() {
  if (watching.load(std::memory_order_relaxed) || watching.exchange(true)) return;
  static const int known = pthread_atfork(nullptr, nullptr, [] { watching = false; });
  (void)known;
  std::thread([this] { watch(); }).detach();
}

void Watch::watch() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const bool asked_to_end = asked_ && asked_();
    std::vector<Place*> due;
    {
      const std::lock_guard lock(places_lock_);
      for (const auto& place : places_) {
        const std::int64_t end = place->due;
        if (end != 0 && (asked_to_end || now() > end)) due.push_back(place.get());
      }
    }
    for (Place* place : due) strike(*place, asked_to_end);
  }
}

void Watch::strike(Place& place, bool asked_to_end) {
  const Lock locked;
  asked_to_end = asked_to_end && !(place.main && spare_main_);
  const std::int64_t end = place.due;  // it may have ended meanwhile
  if (end == 0 || !(asked_to_end || now() > end)) return;
  place.struck = true;
  PyThreadState_SetAsyncExc(place.thread, (asked_to_end ? interrupted_ : late_).get());
}

Watch::Call::Call(Watch& watch, const Class* running, Duration limit) : place_(watch.place()), before_(place_.running) {
  watch.keep_watching();
  place_.running = running;
  place_.due = now() + limit.count();
}

Watch::Call::~Call() {
  place_.due = 0;
  place_.running = before_;
  if (place_.struck) PyThreadState_SetAsyncExc(place_.thread, nullptr);
  place_.struck = false;
}

}  // namespace murosimf::control_software::python
