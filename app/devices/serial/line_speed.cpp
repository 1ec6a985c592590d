#include "devices/serial/line_speed.h"

// The kernel's own definitions, which <termios.h> contradicts: only they know speeds such as 250000.
#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <cerrno>

namespace vantage {

int makeRaw(int descriptor, int baud) {
  struct termios2 settings {};
  if (::ioctl(descriptor, TCGETS2, &settings) != 0) return errno;
  settings.c_iflag &= ~(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON | IXOFF | IXANY | INPCK);
  settings.c_oflag &= ~OPOST;
  settings.c_lflag &= ~(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
  settings.c_cflag &= ~(CSIZE | PARENB | CSTOPB | CRTSCTS | CBAUD | (CBAUD << IBSHIFT));
  settings.c_cflag |= CS8 | CREAD | CLOCAL | HUPCL | BOTHER | (BOTHER << IBSHIFT);
  settings.c_ispeed = static_cast<speed_t>(baud);
  settings.c_ospeed = static_cast<speed_t>(baud);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  return ::ioctl(descriptor, TCSETS2, &settings) == 0 ? 0 : errno;
}

}  // namespace vantage
