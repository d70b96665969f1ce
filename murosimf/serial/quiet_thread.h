/// quiet_thread.h - starts a thread that handles no signals: those are left to the main thread of the program.
#pragma once

#include <csignal>
#include <pthread.h>
#include <thread>
#include <utility>

namespace murosimf::serial {

template <class F>
std::thread quiet_thread(F&& f) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::forward<F>(f));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace murosimf::serial
