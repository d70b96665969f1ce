/// python_watch.h - ends calls of classes that take too long, and those that run while the program is asked to end.
///
/// A thread looks at the running calls fifty times a second, and has an exception raised in those that are to end: where they run Python's
/// own code, not in the middle of code in C.
#pragma once

#include "murosimf/control_software/python/module/python_object.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "murosimf/world/time.h"

namespace murosimf::control_software::python {

class Class;  // python_class.h

class Watch {
 public:
  /// A thread with calls of classes. Changed with the interpreter's lock only, but for the atomic parts.
  struct Place {
    std::atomic<std::int64_t> due{0};  ///< [ns] 0: there is no call
    unsigned long thread = 0;          ///< as Python counts them
    bool main = false;                 ///< the first thread of the process
    bool struck = false;               ///< an exception was raised in the present call
    const Class* running = nullptr;    ///< whose call it is
  };

  /// `late` and `interrupted` are types of exceptions; `asked` says whether the program is asked to end, null: never. In the main thread of
  /// a Python program (`spare_main`) its own handler of signals does that.
  Watch(Object late, Object interrupted, bool (*asked)(), bool spare_main);

  /// Of this thread.
  [[nodiscard]] Place& place();

  /// A call, with the interpreter's lock. No exception of the watch is left behind at its end.
  class Call {
   public:
    Call(Watch& watch, const Class* running, Duration limit);
    ~Call();
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Place& place_;
    const Class* const before_;
  };

 private:
  /// A forked child has no thread that watches: it begins one with its next call.
  void keep_watching();
  void watch();
  void strike(Place& place, bool asked_to_end);

  Object late_, interrupted_;
  bool (*asked_)();
  bool spare_main_;
  std::mutex places_lock_;
  std::vector<std::unique_ptr<Place>> places_;
};

}  // namespace murosimf::control_software::python
