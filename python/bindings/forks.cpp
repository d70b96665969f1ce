#include "forks.h"

#include <string>

#include <pthread.h>

#include "murosimf/error.h"

namespace murosimf::python {
namespace {

unsigned count = 0;  // written by the only thread that a new child has

}  // namespace

unsigned forks() noexcept { return count; }

void count_forks() {
  static const int registered = pthread_atfork(nullptr, nullptr, [] { ++count; });
  (void)registered;
}

void check_not_forked(unsigned born, const char* what) {
  if (born == count) return;
  throw Error(std::string(what) +
              " was made before this process was forked and has threads, which are not here: make it in the child "
              "process, give it "
              "threads=1, or start processes with multiprocessing.get_context('spawn')");
}

}  // namespace murosimf::python
