#include "murosimf/control_software/guard/call_end.h"

#include <algorithm>
#include <csignal>

namespace murosimf::control_software {

const char* crash_name(int signal) noexcept {
  switch (signal) {
    case SIGSEGV: return "SIGSEGV";
    case SIGBUS: return "SIGBUS";
    case SIGFPE: return "SIGFPE";
    case SIGILL: return "SIGILL";
    default: return "SIGABRT";
  }
}

NumberText::NumberText(int number) noexcept {
  auto* end = text.begin();
  // digits from the last to the first, reversed below: no library function that may lock or allocate
  long long rest = number < 0 ? -static_cast<long long>(number) : number;
  do {
    *end++ = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest > 0);
  if (number < 0) *end++ = '-';
  std::reverse(text.begin(), end);
}

}  // namespace murosimf::control_software
