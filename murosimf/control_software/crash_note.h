/// crash_note.h - records that control software has crashed: the state of the process's memory is then unknown, so the run ends, with
/// reports written.
#pragma once

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>

namespace murosimf::control_software {

/// Ends Simulation::run between two steps.
class SoftwareCrash : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Shared by all software of a simulation. Any thread may write it; the thread that runs the simulation checks it.
class CrashNote {
 public:
  void write(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (text_.empty()) text_ = text;
    there_.store(true, std::memory_order_release);
  }
  /// If it is this: what failed begins anew, and the process is as it was.
  void take_back(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (text.empty() || text != text_) return;
    text_.clear();
    there_.store(false, std::memory_order_release);
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

/// Of plug-in algorithms, which belong to the whole process: after a crash of one, no simulation of the process continues.
inline CrashNote& crashes_of_plugins() {
  static CrashNote note;
  return note;
}

}  // namespace murosimf::control_software
