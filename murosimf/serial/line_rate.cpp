#include "murosimf/serial/line_rate.h"

// Rates without a name exist in termios2 only, whose header cannot be included together with <termios.h>.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace murosimf::serial {

double line_rate(int terminal) noexcept {
  termios2 settings{};
  return ioctl(terminal, TCGETS2, &settings) == 0 ? settings.c_ospeed : 0;
}

bool set_line_rate(int terminal, double rate) noexcept {
  termios2 settings{};
  if (ioctl(terminal, TCGETS2, &settings) != 0) return false;
  settings.c_cflag = (settings.c_cflag & ~static_cast<tcflag_t>(CBAUD)) | BOTHER;
  settings.c_ospeed = settings.c_ispeed = static_cast<speed_t>(rate);
  return ioctl(terminal, TCSETS2, &settings) == 0;
}

}  // namespace murosimf::serial
