/// crash_note.h - that control software has crashed: what is left of the process's memory is unknown, so the run ends, with its
/// reports written.
#pragma once

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>

namespace murosimf::connect {

/// Ends Simulation::run between two steps.
class SoftwareCrash : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Shared by all software of a simulation. Any thread may write it down, the one that runs the simulation looks.
class CrashNote {
 public:
  void write(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (text_.empty()) text_ = text;
    there_.store(true, std::memory_order_release);
  }
  /// Throws SoftwareCrash if there is one.
  void check() const {
    if (there_.load(std::memory_order_acquire)) throw SoftwareCrash(text());
  }
  [[nodiscard]] std::string text() const {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  mutable std::mutex mutex_;
  std::string text_;  // the first one
  std::atomic<bool> there_{false};
};

/// Of algorithms of plug-ins, which belong to the whole process: after one of them no simulation of it goes on.
inline CrashNote& crashes_of_plugins() {
  static CrashNote note;
  return note;
}

}  // namespace murosimf::connect
