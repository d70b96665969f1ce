// Control software for tests: does what control software must not do, in the call and at the time that its options name.
//
// What it does when it is loaded or unloaded is chosen by definitions of the build: MISCHIEF_LOADING, MISCHIEF_ENTRY, MISCHIEF_UNLOADING.
#include <err.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <locale>
#include <stdexcept>
#include <string>
#include <thread>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "murosimf/control_software/murosimf_controller.h"

namespace {

struct Instance {
  const murosimf_signal* position = nullptr;
  murosimf_command *target = nullptr, *led = nullptr;
  std::string mischief, where;
  double at = 0;  // [s]
  int many = 1;   // times
};

volatile int* volatile nothing = nullptr;

void crash() { *nothing = 1; }

void throws() { throw std::runtime_error("left a function that must not throw"); }
void (*volatile const call)() = throws;  // which no compiler sees through
void must_not_throw() noexcept { call(); }

void* wait_in_thread(void*) {
  pthread_exit(nullptr);
  return nullptr;
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

void (*const others_handler)(int) = [](int) {};

/// What ends the program.
void end_all(const std::string& what) {
  if (what == "exit") std::exit(0);
  if (what == "_exit") ::_exit(7);
  if (what == "_Exit") std::_Exit(-3);
  if (what == "quick_exit") std::quick_exit(0);
  if (what == "err") ::errx(0, "software gives up");
  if (what == "abort") std::abort();
  if (what == "terminate") std::terminate();
  if (what == "noexcept") must_not_throw();
  if (what == "pthread_exit") ::pthread_exit(nullptr);
  if (what == "segv") crash();
  if (what == "child_exits" && ::fork() == 0) std::exit(0);
  if (what == "child_comes_back") (void)::fork();
  if (what == "system") (void)!std::system("exit 3");
  if (what == "thread_segv") std::thread(crash).join();
  if (what == "lost_thread_segv") {
    std::thread(crash).detach();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // it has begun by then
  }
  if (what == "thread_exit") std::thread([] { std::exit(0); }).join();
  if (what == "thread_throws") std::thread([] { throw std::runtime_error("in a thread"); }).join();
}

/// What goes beyond rows.
void miss(const std::string& what, Instance& self) {
  double* const values = self.target->values;
  if (what == "one_beyond") values[self.target->count] = 1;
  if (what == "led_beyond") self.led->values[self.led->count] = 1;
  if (what == "far_beyond") {
    for (int i = 0; i < 64; ++i) self.led->values[i] = 1e300;
  }
  if (what == "one_before") values[-1] = 1;
  if (what == "far_before") values[-1000] = 1;
  if (what == "count") self.target->count = 100;
  if (what == "input") const_cast<double*>(self.position->values)[2] = 1;
  if (what == "samples") const_cast<murosimf_signal*>(self.position)->samples = 1;
}

/// What belongs to the thread.
void turn(const std::string& what) {
  if (what == "rounding") std::fesetround(FE_DOWNWARD);
  if (what == "traps") feenableexcept(FE_DIVBYZERO);
#if defined(__x86_64__)
  if (what == "tiny") _mm_setcsr(_mm_getcsr() | 0x8040U);
  if (what == "x87") {
    const unsigned short single = 0x007f;
    __asm__ volatile("fldcw %0" : : "m"(single));
  }
#endif
  if (what == "sigmask") {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
  }
  if (what == "sigaltstack") {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    ::sigaltstack(&none, nullptr);
  }
  if (what == "uselocale") ::uselocale(::newlocale(LC_ALL_MASK, "C.UTF-8", nullptr));
}

/// What belongs to the process.
void change(const std::string& what) {
  if (what == "chdir") (void)!::chdir("/");
  if (what == "umask") (void)::umask(0777);
  if (what == "signal") (void)std::signal(SIGINT, SIG_IGN);
  if (what == "sigaction") (void)std::signal(SIGSEGV, others_handler);
  if (what == "timer") ::alarm(3600);
  if (what == "setlocale") (void)std::setlocale(LC_ALL, "C.UTF-8");
  if (what == "locale") (void)std::locale::global(std::locale(std::locale::classic(), new Comma));
  if (what == "setenv") ::setenv("LC_NUMERIC", "de_DE.UTF-8", 1);
  if (what == "close") ::close(STDOUT_FILENO);
  if (what == "fclose") (void)std::fclose(stdout);
  if (what == "dup2") {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::close(nowhere);
  }
  if (what == "set_terminate") std::set_terminate(std::abort);
}

void make(const std::string& where, Instance& self) {
  if (where != self.where || self.many-- <= 0) return;
  end_all(self.mischief);
  miss(self.mischief, self);
  turn(self.mischief);
  change(self.mischief);
}

void* create(const murosimf_robot* robot, char* error, size_t size) {
  auto* self = new Instance;
  self->position = robot->signal(robot, "joint.position");
  self->target = robot->command(robot, "joint.target");
  self->led = robot->command(robot, "robot.led");
  double many = 1;
  robot->number_option(robot, "at", &self->at);
  robot->number_option(robot, "many", &many);
  self->many = static_cast<int>(many);
  if (const char* mischief = robot->text_option(robot, "mischief")) self->mischief = mischief;
  const char* where = robot->text_option(robot, "where");
  self->where = where ? where : "step";
  if (self->where == "create" && self->mischief == "error") std::memset(error, 'x', size + 100);
  make("create", *self);
  if (self->mischief == "good_thread") {
    pthread_t thread;
    ::pthread_create(&thread, nullptr, wait_in_thread, nullptr);
    ::pthread_join(thread, nullptr);
  }
  return self;
}

void destroy(void* instance) {
  auto* self = static_cast<Instance*>(instance);
  make("destroy", *self);
  delete self;
}

void start(void* instance) { make("start", *static_cast<Instance*>(instance)); }

void step(void* instance, int64_t now) {
  auto& self = *static_cast<Instance*>(instance);
  if (static_cast<double>(now) * 1e-9 < self.at) return;
  make("step", self);
  self.target->values[0] = 0.1;
}

size_t save(void* instance, void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  make("save", self);
  const size_t all = sizeof self.at;
  if (bytes && size >= all) std::memcpy(bytes, &self.at, all);
  if (bytes && self.mischief == "save_beyond") std::memset(bytes, 1, size + 100);
  return all;
}

int load(void* instance, const void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  make("load", self);
  if (self.mischief == "load_input") std::memset(const_cast<void*>(bytes), 1, size);
  return 1;
}

const murosimf_controller functions{MUROSIMF_CONTROLLER_ABI, 0, 50, create, destroy, start, step, save, load};

[[maybe_unused]] volatile bool always = true;

#ifdef MISCHIEF_LOADING
__attribute__((constructor)) void when_loaded() {
  if (always) MISCHIEF_LOADING;
}
#endif
#ifdef MISCHIEF_UNLOADING
__attribute__((destructor)) void when_unloaded() {
  if (always) MISCHIEF_UNLOADING;
}
#endif

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() {
#ifdef MISCHIEF_ENTRY
  if (always) MISCHIEF_ENTRY;
#endif
  return &functions;
}
